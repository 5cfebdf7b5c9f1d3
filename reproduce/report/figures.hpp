#pragma once

#include <filesystem>
#include <string>

namespace report {

/// The figures of the paper as HTML: drawings inline, text and command from each folder's README.md (three
/// lines: what, how to make it, its data), tables attached as data: links so that the page stays one file.
/// `sources` is the folder of figNN/; a drawing that is missing is named instead of shown.
std::string figures(const std::filesystem::path& sources, const std::filesystem::path& report);

/// An SVG file ready to stand inside a page: no XML prologue, every id and every reference to one prefixed by
/// `prefix`, `title` as its accessible name.
std::string inline_svg(const std::filesystem::path& file, const std::string& prefix,
                       const std::string& title);

/// The whole of a file; throws std::runtime_error naming it where it cannot be read.
std::string read_text(const std::filesystem::path& file);

}  // namespace report
