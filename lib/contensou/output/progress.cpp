#include "contensou/output/progress.hpp"

#include <cmath>
#include <cstdio>
#include <ostream>

namespace contensou {
namespace {

std::string formatted(const char* format, double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

/// A time in four digits, a number of runs in all of its own.
std::string count(double value) {
  const bool whole = value == std::floor(value) && std::abs(value) < 1e9;
  return formatted(whole ? "%.0f" : "%.4g", value);
}

/// "40 s", "12 min", "3.4 h": no more digits than such a guess is worth.
std::string duration(double seconds) {
  constexpr double minute = 60, hour = 3600;
  if (seconds <= 3 * minute) return formatted("%.0f s", std::ceil(seconds));
  if (seconds < 2 * hour) return formatted("%.0f min", std::ceil(seconds / minute));
  return formatted("%.1f h", seconds / hour);
}

}  // namespace

Progress::~Progress() {
  if (shown_) out_ << "\r\x1b[K" << std::flush;  // carriage return, erase to the end of the line
}

void Progress::show(double at, double elapsed) {
  constexpr double between = 0.2;  // seconds
  if (elapsed < next_) return;
  next_ = elapsed + between;
  out_ << '\r' << before_ << count(at) << " of " << count(end_) << after_
       << formatted(", %.0f %%", 100 * at / end_);
  const double share = (at - begin_) / (end_ - begin_);
  if (share > 0) out_ << ", " << duration(elapsed * (1 - share) / share) << " left";
  out_ << "\x1b[K" << std::flush;
  shown_ = true;
}

}  // namespace contensou
