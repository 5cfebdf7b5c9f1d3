#pragma once

#include <iosfwd>
#include <string>
#include <utility>

namespace contensou {

/// The progress of a simulation, or of many, on one line of a terminal, written over again and again: how far
/// it is, and how long the rest will take if it goes on like this. Silent for the first second, so that what
/// is short shows nothing; then at most five times a second.
class Progress {
 public:
  /// `terminal` outlives this. What is counted runs from `begin` to `end`: simulated time, or what `before`
  /// and `after` say around the numbers.
  Progress(std::ostream& terminal, double begin, double end,
           std::string before = "t = ", std::string after = " s")
      : out_(terminal), before_(std::move(before)), after_(std::move(after)), begin_(begin), end_(end) {}
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// The count is at `at`, `elapsed` seconds of wall time after it was at `begin`.
  void show(double at, double elapsed);

 private:
  std::ostream& out_;
  std::string before_, after_;
  double begin_;
  double end_;
  double next_ = 1;  ///< elapsed time of the next line [s]
  bool shown_ = false;
};

}  // namespace contensou
