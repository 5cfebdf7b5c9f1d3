#include "contensou/output/progress.hpp"

#include <cmath>
#include <cstdio>
#include <ostream>

namespace contensou {

Progress::~Progress() {
  if (shown_) out_ << "\r\x1b[K" << std::flush;  // carriage return, erase to the end of the line
}

void Progress::show(double t, double elapsed) {
  constexpr double between = 0.2;  // seconds
  if (elapsed < next_) return;
  next_ = elapsed + between;
  const double share = (t - begin_) / (end_ - begin_);
  char line[128];
  std::snprintf(line, sizeof line, "\rt = %.4g of %.4g s, %.0f %%", t, end_, 100 * share);
  out_ << line;
  if (share > 0) {
    std::snprintf(line, sizeof line, ", %.0f s left", std::ceil(elapsed * (1 - share) / share));
    out_ << line;
  }
  out_ << "\x1b[K" << std::flush;
  shown_ = true;
}

}  // namespace contensou
