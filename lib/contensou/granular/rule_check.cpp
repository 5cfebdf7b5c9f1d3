#include "contensou/granular/rule_check.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace contensou {
namespace {

constexpr double unit_tolerance = 1e-9;

/// Who has a surface: one of each kind, null where none has.
struct Owners {
  const SphereData* sphere = nullptr;
  const SphereData* unspun = nullptr;  ///< of a body that cannot spin
  const BaseData* base = nullptr;
  const BodyData* based = nullptr;  ///< the base's body
  const PlaneData* plane = nullptr;
};

[[noreturn]] void reject(const std::string& one, const std::string& other, const SystemContact& rule,
                         const char* expected) {
  throw std::invalid_argument(one + " touches " + other + " by rule " + rule.name + ", expected " + expected);
}

std::vector<Owners> owners(const BodiesData& data) {
  std::vector<Owners> all(static_cast<std::size_t>(data.rule.rows()));
  for (const PlaneData& plane : data.planes) all[plane.surface].plane = &plane;
  for (const BodyData& body : data.bodies) {
    for (const SphereData& sphere : body.spheres) {
      all[sphere.surface].sphere = &sphere;
      if (body.rotation == Rotation::none) all[sphere.surface].unspun = &sphere;
    }
    if (body.base) {
      all[body.base->surface].base = &*body.base;
      all[body.base->surface].based = &body;
    }
  }
  return all;
}

void check(const Owners& a, const Owners& b, const SystemContact& rule) {
  if (a.base && (b.sphere || b.base))
    reject("base " + a.base->name, b.sphere ? "sphere " + b.sphere->name : "base " + b.base->name, rule,
           "a base to touch planes only");
  if (a.base && b.plane && rule.load_radius)
    reject("base " + a.base->name, "plane " + b.plane->name, rule,
           "a contact radius that does not follow the load");
  if (rows(rule.friction) <= 3 || !a.unspun) return;
  const char* expected = "friction without drilling where no body can spin";
  if (b.plane) reject("sphere " + a.unspun->name, "plane " + b.plane->name, rule, expected);
  if (b.unspun && a.unspun != b.unspun)
    reject("sphere " + a.unspun->name, "sphere " + b.unspun->name, rule, expected);
}

}  // namespace

void require_valid_rules(const BodiesData& data) {
  const std::vector<Owners> all = owners(data);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < all.size(); ++j) {
      if (const SystemContact* rule = data.between(i, j)) check(all[i], all[j], *rule);
    }
  }
  for (const BodyData& body : data.bodies) {
    if (!body.base) continue;
    const Eigen::Vector3d axis = body.orientation * Eigen::Vector3d::UnitZ();
    for (const PlaneData& plane : data.planes) {
      const SystemContact* rule = data.between(body.base->surface, plane.surface);
      if (rule && (axis - plane.normal).norm() > unit_tolerance)
        reject("base " + body.base->name, "plane " + plane.name, *rule,
               "a plane across the third axis of the body");
    }
  }
}

}  // namespace contensou
