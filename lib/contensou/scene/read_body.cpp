#include "contensou/scene/read_body.hpp"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "contensou/scene/unit_length.hpp"
#include "contensou/system/body_limits.hpp"

namespace contensou {
namespace {

using Eigen::Vector3d;

Rotation rotation_named(const std::string& name) {
  return name == "free"      ? Rotation::free
         : name == "upright" ? Rotation::upright
         : name == "driven"  ? Rotation::driven
                             : Rotation::none;
}

/// The triangle inequality.
void require_possible(const SceneReader& read, const std::string& key, const Vector3d& inertia) {
  for (int k = 0; k < 3; ++k) {
    if (!at_most_sum(inertia[k], inertia[(k + 1) % 3], inertia[(k + 2) % 3]))
      read.refuse(key, "is of no body", "moments each at most the sum of the others");
  }
}

Vector3d read_inertia(SceneReader& read, const std::string& key, Rotation rotation) {
  constexpr Range moment{.least = 0, .least_too = false, .expected = "a number > 0 [kg m^2]"};
  if (rotation == Rotation::upright) return {0, 0, read.number(key, moment)};
  constexpr Length moments{.least = 3, .most = 3, .expected = "three numbers > 0 [kg m^2], or one for all"};
  if (!read.is_array(key)) {
    constexpr Range one{.least = 0, .least_too = false, .expected = moments.expected};
    return Vector3d::Constant(read.number(key, one));
  }
  const std::vector<double> values = read.numbers(key, moments, moment);
  const Vector3d inertia(values[0], values[1], values[2]);
  require_possible(read, key, inertia);
  return inertia;
}

Eigen::Quaterniond read_orientation(SceneReader& read, const std::string& key) {
  constexpr Length four{.least = 4, .most = 4, .expected = "a quaternion [w, x, y, z] of length 1"};
  const auto q = read.optional_numbers(key, four);
  if (!q) return Eigen::Quaterniond::Identity();
  Eigen::Quaterniond orientation((*q)[0], (*q)[1], (*q)[2], (*q)[3]);
  require_unit_length(read, key, orientation.coeffs().stableNorm(), four.expected);
  orientation.normalize();
  return orientation;
}

/// Refuses the keys of what the body's rotation leaves out.
void refuse_unused(SceneReader& read, const std::string& table, Rotation rotation) {
  const std::string by = std::string("rotation ") + (rotation == Rotation::none ? "none" : "driven");
  for (const char* key : {"inertia", "angular_drag"}) read.unused(table + key, by);
  if (rotation == Rotation::none) read.unused(table + "spin", by);
}

void read_turning(SceneReader& read, const std::string& table, BodyData& body) {
  if (body.rotation == Rotation::none || body.rotation == Rotation::driven) {
    refuse_unused(read, table, body.rotation);
  } else {
    body.inertia = read_inertia(read, table + "inertia", body.rotation);
    body.drag.angular = read.optional_number(table + "angular_drag", not_negative).value_or(0);
  }
  if (body.rotation == Rotation::free)
    body.spin = read.optional_vector(table + "spin").value_or(Vector3d::Zero());
  if (body.rotation == Rotation::driven) body.spin = read.vector(table + "spin");
  if (body.rotation == Rotation::upright) {
    constexpr Range about_axis{.expected = "a number [rad/s], about the body's third axis"};
    const double spin = read.optional_number(table + "spin", about_axis).value_or(0);
    body.spin = body.orientation * Vector3d(0, 0, spin);
  }
}

std::vector<SphereData> read_spheres(SceneReader& read, const std::string& body) {
  std::vector<SphereData> spheres;
  for (const std::string& name : read.tables("body." + body + ".sphere")) {
    const std::string table = "body." + body + ".sphere." + name + '.';
    SphereData sphere;
    sphere.name = body + '.' + name;
    sphere.centre = read.optional_vector(table + "centre").value_or(Vector3d::Zero());
    sphere.radius = read.number(table + "radius", positive);
    spheres.push_back(std::move(sphere));
  }
  return spheres;
}

std::optional<BaseData> read_base(SceneReader& read, const BodyData& body) {
  const std::string table = "body." + body.name + ".base";
  if (!read.has_table(table)) return {};
  if (body.rotation == Rotation::free || body.rotation == Rotation::none)
    read.refuse_table(table, "is not of a body that is free or does not turn",
                      "rotation = \"upright\" or \"driven\"");
  for (const SphereData& sphere : body.spheres) {
    if (sphere.name == body.name + ".base")
      read.refuse_table("body." + body.name + ".sphere.base", "has the base's name", "another name");
  }
  // A driven body keeps its base in its plane only if it turns about the base's axis.
  const Vector3d axis = body.orientation * Vector3d::UnitZ();
  if (body.rotation == Rotation::driven &&
      axis.cross(body.spin).stableNorm() > unit_tolerance * body.spin.stableNorm())
    read.refuse("body." + body.name + ".spin", "would tilt the base", "a spin along the body's third axis");
  return BaseData{.name = body.name + ".base", .height = read.number(table + ".height", not_negative)};
}

}  // namespace

void read_motion(SceneReader& read, const std::string& table, BodyData& body) {
  body.velocity = read.optional_vector(table + "velocity").value_or(Vector3d::Zero());
  body.drag.linear = read.optional_number(table + "linear_drag", not_negative).value_or(0);
}

BodyData read_body(SceneReader& read, const std::string& name) {
  const std::string table = "body." + name + '.';
  BodyData body;
  body.name = name;
  body.rotation = rotation_named(read.choice(table + "rotation", {"free", "upright", "driven", "none"}));
  body.mass = read.number(table + "mass", positive);
  body.position = read.vector(table + "position");
  body.orientation = read_orientation(read, table + "orientation");
  read_motion(read, table, body);
  read_turning(read, table, body);
  body.spheres = read_spheres(read, name);
  body.base = read_base(read, body);
  return body;
}

}  // namespace contensou
