#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "contensou/scene/reader.hpp"
#include "contensou/system/body_limits.hpp"
#include "contensou/text/number.hpp"

namespace contensou {

inline void require_unit_length(const SceneReader& read, std::string_view key, double length,
                                std::string_view expected) {
  if (!(std::abs(length - 1) <= unit_tolerance)) read.refuse(key, "has length " + to_text(length), expected);
}

}  // namespace contensou
