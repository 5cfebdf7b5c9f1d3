#pragma once

#include <filesystem>
#include <functional>

namespace reproduce {

/// `main` of every program the report is made of, figure, verification or benchmark: NAME [--out FOLDER],
/// FOLDER = build/report/data unless told otherwise. Returns what run(FOLDER) returns, 1 where it throws
/// (after a line on standard error), 2 for bad arguments.
int program_main(int argc, char** argv, const std::function<int(const std::filesystem::path& folder)>& run);

}  // namespace reproduce
