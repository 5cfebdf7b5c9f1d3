#pragma once

#include <stdexcept>

namespace contensou {

/// The arguments at the door of every law: v, s >= 0, not both zero, not both infinite, no NaN.
/// Throws std::domain_error otherwise.
inline void require_slip(double v, double s) {
  if (!(v >= 0 && s >= 0)) throw std::domain_error("friction law: v and s must be numbers >= 0");
  if (v == 0 && s == 0) throw std::domain_error("friction law: at v = s = 0 the friction is a set, not a number");
  if (v == s && v > 1.7976931348623157e308) {
    throw std::domain_error("friction law: v and s are both infinite, their ratio is not defined");
  }
}

}  // namespace contensou
