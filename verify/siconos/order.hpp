#pragma once

#include <vector>

namespace verify::siconos {

/// The least-squares slope of log error over −log points: the order p of error ~ N^−p.
///
/// What to expect of N points for the friction of a patch: the integrand of Φ has a cone |x − p| at the
/// centre of rotation p, that of the force a jump in all directions there. Rings (4n circles' angles, n Gauss
/// radii): a jump leaves O(1) on the ring through p, of angular error 1/n and weight 1/n: force N^−1, support
/// N^−3/2 (one power of 1/n more). With p well outside the patch all is analytic, and the error falls
/// exponentially in n. With p at the centre only the torque's ρ is left, √t at the end of a Gauss rule: n^−3,
/// N^−3/2. Sunflower: N^−1 whatever p, from the end of the spiral, for force and support.
double order(const std::vector<double>& points, const std::vector<double>& errors);

}  // namespace verify::siconos
