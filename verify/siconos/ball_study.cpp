#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "contensou/ball/friction_ball.hpp"
#include "contensou/ball/smooth_plate.hpp"
#include "contensou/output/table.hpp"
#include "order.hpp"
#include "patch_study.hpp"
#include "points.hpp"

namespace verify::siconos {
namespace {

/// Unit normals of the ball's border: polar angles with uniform u in (0, 2) and azimuths by the golden angle.
/// The centre of rotation 1/u... is at distance u from the centre of the patch.
std::vector<Eigen::Vector3d> normals(int count) {
  std::vector<Eigen::Vector3d> all;
  for (int i = 0; i < count; ++i) {
    const double u = 2 * (i + 0.5) / count;
    const double angle = 2 * std::numbers::pi * std::numbers::phi * i;
    all.emplace_back(Eigen::Vector3d(u * std::cos(angle), u * std::sin(angle), 1).normalized());
  }
  return all;
}

/// The support function of the sum of N disks, each of radius w_i in the plane of its point's velocity.
double support(const std::vector<PatchPoint>& points, const Eigen::Vector3d& gamma) {
  double sum = 0;
  for (const PatchPoint& p : points) {
    const double v1 = gamma.x() - gamma.z() * p.y;
    const double v2 = gamma.y() + gamma.z() * p.x;
    sum += p.weight * std::sqrt(v1 * v1 + v2 * v2);
  }
  return sum;
}

}  // namespace

void check_ball(Record& record, const std::filesystem::path& folder) {
  using namespace contensou;
  const FrictionBall uniform{SmoothPlate(UniformLaw{})};
  const FrictionBall hertz{SmoothPlate(HertzLaw{})};
  const std::vector<Eigen::Vector3d> directions = normals(1000);
  Table table{
      {"The friction ball of N points with Coulomb friction (the Minkowski sum of N disks) against ours, in "
       "units of mu lambda_N.",
       "error: largest difference of the support functions over 1000 unit normals with 0 < u < 2, that is "
       "the Hausdorff distance of the two sets"},
      {"pressure", "set", "points", "error"},
      {}};
  for (const Pressure pressure : {Pressure::uniform, Pressure::hertz}) {
    const std::string name = pressure == Pressure::uniform ? "uniform" : "hertz";
    for (const std::string set : {"rings", "sunflower"}) {
      std::vector<double> sizes, errors;
      for (const int n : {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96}) {
        const auto points = set == "rings" ? rings(pressure, n) : sunflower(pressure, 4 * n * n);
        double worst = 0;
        for (const Eigen::Vector3d& gamma : directions) {
          const double exact =
              pressure == Pressure::uniform ? uniform.support(1, gamma) : hertz.support(1, gamma);
          worst = std::max(worst, std::abs(support(points, gamma) - exact));
        }
        table.add({name, set, 4.0 * n * n, worst});
        if (n < 4) continue;
        sizes.push_back(4.0 * n * n);
        errors.push_back(worst);
      }
      const double expected = set == "rings" ? 1.5 : 1;
      const double obtained = order(sizes, errors);
      std::printf("  %-7s %-9s ball off by %.1e at N = %.0f, order %.2f\n", name.c_str(), set.c_str(),
                  errors.back(), sizes.back(), obtained);
      record.add(Claim{
          "siconos.ball." + name + "." + set, "LG03 (2.19)",
          "the friction ball of N points (" + set + ", " + name + ") converges to ours, distance ~ N^-order",
          expected, obtained, std::abs(obtained - expected), 0.15, true});
    }
  }
  write_table(table, folder / "siconos_ball.tsv");
}

}  // namespace verify::siconos
