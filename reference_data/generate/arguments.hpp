#pragma once

#include <string>
#include <vector>

namespace reference {

/// The u of the tables laws/*.tsv, ascending: 0, the smallest subnormal, 1e-300, 10^{k/6} for k = −36..36
/// (nearest doubles), 1 ± 2^-k for k = 1..52, both neighbours of 1, 1, 1e300, the largest double, ∞.
std::vector<double> law_arguments();

/// A named range of u for the accuracy tables.
struct Range {
  std::string name;
  std::string interval;
  std::vector<double> u;
};

/// The ranges of accuracy/*.tsv, each with its two outermost doubles and as many pseudo-random ones between
/// them (always the same) as make 250, ascending and different. Random means: binary exponent of u (of |1 −
/// u| in the two seams) uniform, all bits after the leading one random.
std::vector<Range> accuracy_ranges();

}  // namespace reference
