#pragma once

#include <filesystem>
#include <string>

/// Figures without a friction law in them have no reference curves: their geometry must be what the paper
/// says.
bool is_drawing(const std::string& figure);
/// Reads the figure's tables in `folder`, prints what is wrong.
bool geometry_holds(const std::string& figure, const std::filesystem::path& folder);
