#pragma once

#include <cmath>
#include <cstdint>

#include "contensou/integrate/motion.hpp"

namespace contensou {

/// The times at which an observer is shown the motion: start, start + k·interval, end; each once, in order.
class SampleClock {
 public:
  SampleClock(double start, double end, double interval) : start_(start), end_(end), interval_(interval) {}

  /// The next time to be shown; infinite after the last.
  double next() const {
    if (done_) return std::numeric_limits<double>::infinity();
    const double t = count_ == 0 ? start_ : start_ + static_cast<double>(count_) * interval_;
    return t < end_ ? t : end_;
  }
  void advance() {
    done_ = !(next() < end_);
    ++count_;
  }

 private:
  double start_;
  double end_;
  double interval_;
  std::int64_t count_ = 0;
  bool done_ = false;
};

/// Appends what happened to contact i between two modes: close | open | stick | slip. A contact that closes
/// slips unless it sticks at once, which is an event of its own.
inline void record_change(double t, std::size_t contact, ContactMode before, ContactMode after,
                          std::vector<Event>& events) {
  if (before == after) return;
  if (after == ContactMode::open) {
    events.push_back({t, EventKind::open, contact});
    return;
  }
  if (before == ContactMode::open) events.push_back({t, EventKind::close, contact});
  if (after == ContactMode::stick) events.push_back({t, EventKind::stick, contact});
  if (before == ContactMode::stick) events.push_back({t, EventKind::slip, contact});
}

}  // namespace contensou
