#pragma once

#include <iosfwd>

namespace contensou {

/// The progress of a simulation on one line of a terminal, written over again and again: how far it is, and
/// how long the rest will take if it goes on like this. Silent for the first second, so that a short run
/// shows nothing; then at most five times a second.
class Progress {
 public:
  /// `terminal` outlives this. Simulated time runs from `begin` to `end` [s].
  Progress(std::ostream& terminal, double begin, double end) : out_(terminal), begin_(begin), end_(end) {}
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// At simulated time t, `elapsed` seconds of wall time after the start.
  void show(double t, double elapsed);

 private:
  std::ostream& out_;
  double begin_;
  double end_;
  double next_ = 1;  ///< elapsed time of the next line [s]
  bool shown_ = false;
};

}  // namespace contensou
