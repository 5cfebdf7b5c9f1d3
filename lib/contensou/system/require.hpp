#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "contensou/text/number.hpp"

namespace contensou {

constexpr const char* positive_number = "a number > 0";
constexpr const char* nonnegative_number = "a number >= 0";
constexpr const char* finite_number = "a finite number";

/// Throws std::invalid_argument with one line, "SYSTEM: WHAT VALUE, expected EXPECTED", unless the value is
/// finite and fine.
inline void require(const char* system, bool fine, const char* what, double value, const char* expected) {
  if (fine && std::isfinite(value)) return;
  throw std::invalid_argument(std::string(system) + ": " + what + " " + to_text(value) + ", expected " +
                              expected);
}

}  // namespace contensou
