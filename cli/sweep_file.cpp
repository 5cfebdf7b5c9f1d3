#include "sweep_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "bad_input.hpp"
#include "contensou/output/file.hpp"
#include "contensou/text/name.hpp"
#include "contensou/text/quoted.hpp"

namespace cli {
namespace {

constexpr const char* fingerprint_comment = "# fingerprint: ";

std::string all_of(int file, std::size_t size) {
  std::string text(size, '\0');
  std::size_t got = 0;
  while (got < size) {
    const ssize_t more = pread(file, text.data() + got, size - got, static_cast<off_t>(got));
    if (more < 0 && errno == EINTR) continue;
    if (more <= 0) break;
    got += static_cast<std::size_t>(more);
  }
  text.resize(got);
  return text;
}

BadInput unusable(const std::filesystem::path& path) {
  return BadInput("--out: " + contensou::in_quotes(path.string()) +
                  " cannot be written; expected the name of a regular file to write");
}

}  // namespace

std::string SweepHeader::text() const {
  std::string text;
  for (const std::string& comment : comments) text += "# " + comment + '\n';
  text += fingerprint_comment + fingerprint + '\n';
  for (std::size_t i = 0; i < columns.size(); ++i) text += (i == 0 ? "" : "\t") + columns[i];
  return text + '\n';
}

SweepFile::SweepFile(std::filesystem::path path, SweepHeader header, bool restart)
    : path_(std::move(path)), header_(std::move(header)), rows_(header_.runs) {
  try {
    open();
    if (!restart) read();
  } catch (...) {
    close();
    throw;
  }
}

SweepFile::~SweepFile() { close(); }

void SweepFile::close() {
  if (file_ >= 0) ::close(file_);
  file_ = -1;
}

/// Opens and locks the file, if there is one.
void SweepFile::open() {
  file_ = ::open(path_.c_str(), O_RDWR | O_APPEND | O_CLOEXEC | O_NONBLOCK);
  if (file_ < 0 && errno == ENOENT) return;
  struct stat opened {
  }, named{};
  if (file_ < 0 || fstat(file_, &opened) != 0 || !S_ISREG(opened.st_mode)) throw unusable(path_);
  // Where locks are not to be had (some network file systems) it goes without.
  const bool in_use = flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  // The other sweep's last act is to put a new file in the place of the one that it has locked.
  const bool replaced = stat(path_.c_str(), &named) != 0 || named.st_ino != opened.st_ino;
  if (in_use || replaced)
    throw BadInput("--out: " + contensou::in_quotes(path_.string()) +
                   " is being written by another sweep; expected one at a time");
}

std::size_t SweepFile::end_of_header(std::string_view text) const {
  const std::string columns =
      header_.text().substr(header_.text().rfind('\n', header_.text().size() - 2) + 1);
  bool same = false;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string_view::npos) break;
    const std::string_view line = text.substr(begin, end + 1 - begin);
    begin = end + 1;
    if (!line.starts_with('#')) return same && line == columns ? begin : std::string_view::npos;
    if (line == fingerprint_comment + header_.fingerprint + '\n') same = true;
  }
  return std::string_view::npos;
}

std::size_t SweepFile::run_of(std::string_view line) const {
  const auto cells = static_cast<std::size_t>(std::count(line.begin(), line.end(), '\t')) + 1;
  std::size_t run = 0;
  const bool good = cells == header_.columns.size() && contensou::parse(line.substr(0, line.find('\t')), run);
  return good && run < header_.runs ? run : header_.runs;
}

void SweepFile::read() {
  struct stat status {};
  if (file_ < 0 || fstat(file_, &status) != 0 || status.st_size == 0) return;
  const std::string text = all_of(file_, static_cast<std::size_t>(status.st_size));
  const std::string name = contensou::printable(path_.string());
  std::size_t begin = end_of_header(text);
  if (begin == std::string::npos)
    throw BadInput(name +
                   ": is not of this sweep: another command, scene or version made it; expected --out with "
                   "another name, or --restart to overwrite it");
  size_ = begin;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = std::string_view(text).substr(begin, end - begin);
    const std::size_t run = run_of(line);
    // A last line that the end of the program, or of the power, tore: its run is done again.
    if (end >= text.size() - 1 && (end == text.size() || run == header_.runs)) break;
    if (run == header_.runs)
      throw BadInput(
          name + ':' +
          std::to_string(1 +
                         std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(begin), '\n')) +
          ": is no row of this sweep; expected its table as it was left, or --restart to overwrite it");
    if (rows_[run].empty()) rows_[run] = line;
    size_ = begin = end + 1;
  }
}

std::vector<std::size_t> SweepFile::missing() const {
  std::vector<std::size_t> runs;
  for (std::size_t run = 0; run < rows_.size(); ++run) {
    if (rows_[run].empty()) runs.push_back(run);
  }
  return runs;
}

void SweepFile::begin() {
  if (size_ != 0) {
    if (ftruncate(file_, static_cast<off_t>(size_)) != 0) throw unusable(path_);
    return;
  }
  try {
    contensou::write_file(header_.text(), path_);
  } catch (const std::runtime_error&) {
    throw unusable(path_);
  }
  close();
  open();
  if (file_ < 0) throw unusable(path_);
}

void SweepFile::append(const std::string& row) {
  const std::string line = row + '\n';
  ssize_t written = 0;
  do {
    written = write(file_, line.data(), line.size());
  } while (written < 0 && errno == EINTR);
  if (written != static_cast<ssize_t>(line.size()))
    throw std::runtime_error(contensou::printable(path_.string()) + ": cannot be written: " +
                             (written < 0 ? std::strerror(errno) : "the disk is full") +
                             "; the same command goes on from here");
  rows_.at(run_of(row)) = row;
}

void SweepFile::finish() const {
  std::string text = header_.text();
  for (const std::string& row : rows_) text += row + '\n';
  contensou::write_file(text, path_);
}

}  // namespace cli
