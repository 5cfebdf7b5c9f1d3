#pragma once

#include <string>
#include <string_view>

#include "contensou/output/table.hpp"

/// Text and tables as HTML. Everything that comes from a file goes through one of these.
namespace report {

/// The five characters with a meaning in HTML, escaped: safe as text and in quoted attributes.
std::string escape(std::string_view text);

/// Plain text with Unicode mathematics: escaped, `code` set as code, λ_N or P_F set with a subscript.
std::string prose(std::string_view text);

/// A number as a reader wants it (4 digits, powers of ten; what is not 1 does not read 1), other text as
/// prose.
std::string cell(std::string_view text);

/// A table that page.js sorts by a click on a column's head and filters by text or verdict; scrolls by itself
/// where the screen is narrow. Its comment lines stand above it. Long tables are folded unless `open`.
std::string table(const contensou::Table& table, std::string_view id, std::string_view title, bool open);

/// For data: URIs.
std::string base64(std::string_view bytes);

}  // namespace report
