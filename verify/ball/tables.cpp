#include "tables.hpp"

#include <cmath>

namespace verify::ball {

std::vector<BorderPoint> border_points(const std::vector<accuracy::ReferenceRow>& rows) {
  std::vector<BorderPoint> points;
  for (const accuracy::ReferenceRow& row : rows) {
    const Pair point{static_cast<Real>(row.xi), static_cast<Real>(row.eta)};
    const Real u = row.u;
    const Pair direction = std::isinf(u) ? Pair{1, 0} : Pair{u, 1};
    const Real length = std::hypot(direction.t, direction.tau);
    const Pair normal{direction.t / length, direction.tau / length};
    points.push_back({point, normal, static_cast<Real>(row.phi)});
  }
  return points;
}

}  // namespace verify::ball
