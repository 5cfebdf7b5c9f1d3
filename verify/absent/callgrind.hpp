#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace verify::absent {

/// What callgrind counted of one function.
struct FunctionCount {
  std::int64_t calls = 0;
  std::int64_t instructions = 0;  ///< its own, without those of what it calls
};

/// What callgrind counted of one run of a program.
struct Profile {
  std::int64_t instructions = 0;
  std::map<std::string, FunctionCount, std::less<>> functions;  ///< by demangled name
};

/// Runs a program to its end under callgrind; `folder` is there and takes the raw counts. Throws
/// std::runtime_error with the program's own words where it fails.
Profile profile(const std::vector<std::string>& command, const std::filesystem::path& folder);

/// Reads callgrind's file (format version 1).
Profile read_profile(const std::filesystem::path& file);

/// "contensou::f<int>" of "double contensou::f<int>(std::vector<int> const&)": without type and arguments.
std::string_view qualified_name(std::string_view demangled);

}  // namespace verify::absent
