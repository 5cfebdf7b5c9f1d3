#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "contensou/scene/reader.hpp"
#include "contensou/text/number.hpp"

namespace contensou {

/// Lengths that are to be 1: what a hand-written file may be off, ten digits.
inline constexpr double unit_tolerance = 1e-9;

inline void require_unit_length(const SceneReader& read, std::string_view key, double length,
                                std::string_view expected) {
  if (!(std::abs(length - 1) <= unit_tolerance)) read.refuse(key, "has length " + to_text(length), expected);
}

}  // namespace contensou
