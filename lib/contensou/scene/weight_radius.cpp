#include "contensou/scene/weight_radius.hpp"

#include <algorithm>
#include <vector>

namespace contensou {
namespace {

/// A surface that can have a patch.
struct Round {
  std::size_t surface;
  double curvature;            ///< [1/m]; 0: a plane
  std::optional<double> mass;  ///< of its body [kg]
};

std::vector<Round> round_surfaces(const BodiesData& data) {
  std::vector<Round> surfaces;
  for (const BodyData& body : data.bodies) {
    for (const SphereData& sphere : body.spheres)
      surfaces.push_back({sphere.surface, 1 / sphere.radius, body.mass});
  }
  for (const PlaneData& plane : data.planes) surfaces.push_back({plane.surface, 0, {}});
  return surfaces;
}

}  // namespace

std::optional<double> radius_under_weight(const Scene& scene, std::size_t contact) {
  const auto* bodies = std::get_if<BodiesScene>(&scene.system);
  if (bodies == nullptr || !bodies->contacts[contact].modulus) return {};
  const BodiesData& data = bodies->data;
  const double g = data.gravity.norm();
  if (!(g > 0)) return {};
  const std::vector<Round> surfaces = round_surfaces(data);
  for (const Round& a : surfaces) {
    for (const Round& b : surfaces) {
      if (!a.mass || data.rule(static_cast<Eigen::Index>(a.surface), static_cast<Eigen::Index>(b.surface)) !=
                         static_cast<int>(contact))
        continue;
      const double mass = std::min(*a.mass, b.mass.value_or(*a.mass));
      const LoadRadius radius{.relative_radius = 1 / (a.curvature + b.curvature),
                              .modulus = *bodies->contacts[contact].modulus};
      return radius.at(mass * g);
    }
  }
  return {};
}

}  // namespace contensou
