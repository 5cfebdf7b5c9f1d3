#pragma once

#include <array>

#include "contenders.hpp"
#include "reference.hpp"

namespace accuracy {

/// One quantity of a law: as a contender gives it, and exactly.
struct Quantity {
  const char* name;
  double Values::*value;
  Quad ReferenceRow::*exact;
};

inline constexpr std::array<Quantity, 4> quantities{{{"phi", &Values::phi, &ReferenceRow::phi},
                                                     {"xi", &Values::xi, &ReferenceRow::xi},
                                                     {"eta", &Values::eta, &ReferenceRow::eta},
                                                     {"f2", &Values::second, &ReferenceRow::second}}};

}  // namespace accuracy
