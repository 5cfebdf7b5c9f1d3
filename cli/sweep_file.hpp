#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

/// What stands at the top of a sweep's table, and how many rows are to come.
struct SweepHeader {
  std::vector<std::string> comments;  ///< without "# "
  std::string fingerprint;            ///< a comment, too; a table with another one is of another sweep
  std::vector<std::string> columns;   ///< the first is the run's number
  std::size_t runs = 0;

  std::string text() const;
};

/// The table of a sweep, which grows by a row as each run finishes, in whatever order, and can be gone on
/// with after the program was killed at any moment. One process at a time has it (an advisory lock).
class SweepFile {
 public:
  /// Looks at what is there and changes nothing. Throws BadInput for a file that is of another sweep, in
  /// use, or no regular file; with `restart` another sweep's is overwritten by begin().
  SweepFile(std::filesystem::path path, SweepHeader header, bool restart);
  ~SweepFile();
  SweepFile(const SweepFile&) = delete;
  SweepFile& operator=(const SweepFile&) = delete;

  /// The runs that have no row yet, in order.
  std::vector<std::size_t> missing() const;

  /// Makes the file where there is none, cuts off a last row that was torn. BadInput if it cannot.
  void begin();
  /// Adds one row, a whole line without its end, in one write; throws std::runtime_error where the disk does
  /// not take it.
  void append(const std::string& row);
  /// Puts the rows in order, under a temporary name, then renamed.
  void finish() const;

 private:
  void open();
  void close();
  void read();
  /// Where the rows begin in a table of this sweep; npos if it is of another.
  std::size_t end_of_header(std::string_view text) const;
  /// The run whose row a line is; `runs` if it is none.
  std::size_t run_of(std::string_view line) const;

  std::filesystem::path path_;
  SweepHeader header_;
  std::vector<std::string> rows_;  ///< by run; empty: none yet
  std::size_t size_ = 0;           ///< of the file up to its last whole row [bytes]
  int file_ = -1;
};

}  // namespace cli
