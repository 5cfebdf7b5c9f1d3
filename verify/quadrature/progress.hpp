#pragma once

#include <unistd.h>

#include <cstdio>

namespace verify {

/// A percentage on standard error where that is a terminal; silent elsewhere.
class Progress {
 public:
  explicit Progress(int steps) : steps_(steps), shown_(isatty(STDERR_FILENO) != 0) {}
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance() {
    ++done_;
    const int percent = 100 * done_ / steps_;
    if (shown_ && percent != percent_) std::fprintf(stderr, "\r%3d %%", percent);
    percent_ = percent;
  }
  /// Before a line of ordinary output.
  void clear() const {
    if (shown_) std::fputs("\r     \r", stderr);
  }

 private:
  int steps_;
  int done_ = 0;
  int percent_ = -1;
  bool shown_;
};

}  // namespace verify
