#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace contensou {

/// Writes any text under a temporary name beside `path`, then renames: a reader never sees half a file. Makes
/// missing folders. Through a link, the file it leads to is replaced; what is there and no regular file (a
/// folder, a device) is refused. Throws std::runtime_error naming the path where that fails; then nothing is
/// left behind.
void write_file(std::string_view text, const std::filesystem::path& path);

/// A text and where it goes.
struct FileText {
  std::filesystem::path path;
  std::string_view text;
};

/// The same for files that belong together: all are written under their temporary names before the first is
/// renamed, so that a full disk leaves all of the old ones or none.
void write_files(const std::vector<FileText>& files);

}  // namespace contensou
