#include "pile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contensou/output/table.hpp"

namespace verify::answers::pile {

Spread reference() {
  const contensou::Table table = contensou::read_table(CONTENSOU_REFERENCE_DATA "/scenes/pile.tsv");
  const auto names = table.texts("outcome");
  const auto means = table.numbers("mean"), deviations = table.numbers("deviation");
  Spread spread;
  for (std::size_t i = 0; i < names.size(); ++i) spread[names[i]] = {means[i], deviations[i]};
  return spread;
}

double deepest(const Shipped& run) {
  double worst = -std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Vector3d centre = run.end().q.segment<3>(7 * i);  // free bodies: position, quaternion
    for (Eigen::Index k = 0; k < 2; ++k)
      worst = std::max({worst, radius - centre[k], centre[k] - (width - radius)});
    worst = std::max(worst, radius - centre[2]);
  }
  return worst;
}

}  // namespace verify::answers::pile
