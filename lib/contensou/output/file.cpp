#include "contensou/output/file.hpp"

#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace contensou {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path) {
  throw std::runtime_error(path.string() + ": cannot be written");
}

/// What the rename is to replace: the file a link leads to, never the link itself, and nothing but a regular
/// file.
fs::path replaceable(const fs::path& path) {
  std::error_code error;
  const bool is_link = fs::is_symlink(fs::symlink_status(path, error));
  const fs::path target = is_link ? fs::canonical(path, error) : path;
  const auto status = fs::status(target, error);
  if (target.empty() || (fs::exists(status) && !fs::is_regular_file(status))) {
    throw std::runtime_error(path.string() + ": cannot be written, it is not a regular file");
  }
  return target;
}

/// A text on disk under its temporary name, which is gone again unless renamed.
class Staged {
 public:
  explicit Staged(const FileText& file)
      : path_(replaceable(file.path)), temporary_(path_.string() + ".part") {
    std::error_code error;
    if (path_.has_parent_path()) fs::create_directories(path_.parent_path(), error);
    std::ofstream out(temporary_, std::ios::binary | std::ios::trunc);
    out.write(file.text.data(), static_cast<std::streamsize>(file.text.size()));
    out.close();
    if (out) return;
    fs::remove(temporary_, error);
    refuse(path_);
  }
  Staged(Staged&& other) noexcept
      : path_(std::move(other.path_)), temporary_(std::exchange(other.temporary_, {})) {}
  Staged(const Staged&) = delete;
  Staged& operator=(const Staged&) = delete;
  Staged& operator=(Staged&&) = delete;
  ~Staged() {
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove(temporary_, ignored);
  }

  void rename() {
    std::error_code error;
    fs::rename(temporary_, path_, error);
    if (error) refuse(path_);
    temporary_.clear();
  }

 private:
  fs::path path_;
  fs::path temporary_;
};

}  // namespace

void write_files(const std::vector<FileText>& files) {
  std::vector<Staged> staged;
  staged.reserve(files.size());
  for (const FileText& file : files) staged.emplace_back(file);
  for (Staged& file : staged) file.rename();
}

void write_file(std::string_view text, const std::filesystem::path& path) { write_files({{path, text}}); }

}  // namespace contensou
