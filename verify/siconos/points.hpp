#pragma once

#include <string>
#include <vector>

namespace verify::siconos {

/// A point of the disk of radius 1 that carries the share `weight` of the normal force.
struct PatchPoint {
  double x, y, weight;
};

enum class Pressure { uniform, hertz };

/// 4n² points: n circles at Gauss–Legendre nodes, 4n points on each at equal angles. What both rules leave of
/// a smooth integrand falls faster than any power of n. The circles' variable t makes the radial integrand
/// smooth: t = ρ² for uniform pressure, t = √(1 − ρ²) for Hertz pressure with weight 3t² dt.
std::vector<PatchPoint> rings(Pressure pressure, int n);

/// `count` points of equal weight on a spiral, each a golden angle further than the last (Vogel's sunflower),
/// at radii that enclose (i + ½)/count of the force. For a smooth integrand the sum is off by O(1/count), by
/// Abel's summation of the angle's powers along the spiral.
std::vector<PatchPoint> sunflower(Pressure pressure, int count);

}  // namespace verify::siconos
