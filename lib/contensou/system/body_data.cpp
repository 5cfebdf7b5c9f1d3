#include "contensou/system/body_data.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "contensou/system/body_limits.hpp"
#include "contensou/system/require.hpp"

namespace contensou {
namespace {

/// A body that does not turn has no spin; one that stays flat has it about its third axis.
void require_possible_spin(const char* name, const BodyData& body) {
  if (body.rotation == Rotation::none)
    require(name, body.spin.isZero(0), "spin", body.spin.norm(), "0 where it does not turn");
  if (body.rotation != Rotation::upright && !(body.rotation == Rotation::driven && body.base)) return;
  const Eigen::Vector3d axis = body.orientation * Eigen::Vector3d::UnitZ();
  const double across = axis.cross(body.spin).norm();
  require(name, across <= unit_tolerance * body.spin.norm(), "spin across the third axis", across,
          "0 where it stays upright");
}

void require_valid(const BodyData& body) {
  const std::string title = "body " + body.name;
  const char* name = title.c_str();
  const auto finite = [&](const Eigen::Vector3d& x, const char* what) {
    for (const double value : x) require(name, true, what, value, finite_number);
  };
  require(name, body.mass > 0, "mass", body.mass, positive_number);
  if (body.rotation == Rotation::free || body.rotation == Rotation::upright) {
    const Eigen::Vector3d& i = body.inertia;
    const int first = body.rotation == Rotation::free ? 0 : 2;
    for (int k = first; k < 3; ++k) require(name, i[k] > 0, "inertia", i[k], positive_number);
    for (int k = 0; k < 3 && first == 0; ++k)
      require(name, at_most_sum(i[k], i[(k + 1) % 3], i[(k + 2) % 3]), "inertia", i[k],
              "at most the sum of the other two moments");
  }
  require(name, body.drag.linear >= 0, "linear drag", body.drag.linear, nonnegative_number);
  require(name, body.drag.angular >= 0, "angular drag", body.drag.angular, nonnegative_number);
  finite(body.position, "position");
  finite(body.velocity, "velocity");
  finite(body.spin, "spin");
  const double length = body.orientation.norm();
  require(name, std::abs(length - 1) <= unit_tolerance, "orientation of length", length, "length 1");
  require_possible_spin(name, body);
  for (const SphereData& sphere : body.spheres) {
    finite(sphere.centre, "centre of a sphere");
    require(name, sphere.radius > 0, "radius of a sphere", sphere.radius, positive_number);
  }
  if (!body.base) return;
  require(name, body.base->height >= 0, "height of the base", body.base->height, nonnegative_number);
  if (body.rotation == Rotation::free || body.rotation == Rotation::none)
    throw std::invalid_argument(title + ": has a base, expected rotation upright or driven");
}

void require_valid(const PlaneData& plane) {
  const std::string title = "plane " + plane.name;
  const double length = plane.normal.norm();
  require(title.c_str(), std::abs(length - 1) <= unit_tolerance, "normal of length", length, "length 1");
  require(title.c_str(), true, "offset", plane.offset, finite_number);
}

void require_valid(const LoadData& load, const std::vector<BodyData>& bodies) {
  const std::string title = "load " + load.name;
  const char* name = title.c_str();
  require(name, load.body < bodies.size(), "body", static_cast<double>(load.body), "the index of a body");
  for (const double value : load.force) require(name, true, "force", value, finite_number);
  for (const double value : load.torque) require(name, true, "torque", value, finite_number);
  const Rotation rotation = bodies[load.body].rotation;
  require(name, load.torque.isZero(0) || rotation == Rotation::free || rotation == Rotation::upright,
          "torque", load.torque.norm(), "0 on a body that does not turn, or as it is told");
  const CourseData& course = load.course;
  require(name, course.frequency >= 0, "frequency", course.frequency, nonnegative_number);
  require(name, true, "phase", course.phase, finite_number);
  require(name, course.times.size() == course.factors.size(), "number of factors",
          static_cast<double>(course.factors.size()), "as many as times");
  for (std::size_t i = 0; i < course.times.size(); ++i) {
    require(name, i == 0 || course.times[i] > course.times[i - 1], "time", course.times[i],
            "increasing times");
    require(name, true, "factor", course.factors[i], finite_number);
  }
}

}  // namespace

double CourseData::at(double t) const {
  double factor = 1;
  if (!times.empty()) {
    const auto after = std::upper_bound(times.begin(), times.end(), t);
    const auto k = static_cast<std::size_t>(after - times.begin());
    if (k == 0) {
      factor = factors.front();
    } else if (k == times.size()) {
      factor = factors.back();
    } else {
      const double part = (t - times[k - 1]) / (times[k] - times[k - 1]);
      factor = factors[k - 1] + part * (factors[k] - factors[k - 1]);
    }
  }
  if (frequency == 0 && phase == 0) return factor;
  return factor * std::cos(2 * std::numbers::pi * frequency * t + phase);
}

void require_valid(const BodiesData& data) {
  for (const double value : data.gravity) require("bodies", true, "gravity", value, finite_number);
  for (const BodyData& body : data.bodies) require_valid(body);
  for (const PlaneData& plane : data.planes) require_valid(plane);
  for (const LoadData& load : data.loads) require_valid(load, data.bodies);
  const auto surfaces = data.rule.rows();
  const auto known = [&](std::size_t surface) {
    require("bodies", static_cast<Eigen::Index>(surface) < surfaces, "surface", static_cast<double>(surface),
            "an index of the table of rules");
  };
  require("bodies", data.rule.cols() == surfaces, "columns of the table of rules",
          static_cast<double>(data.rule.cols()), "as many as rows");
  for (Eigen::Index i = 0; i < surfaces; ++i) {
    for (Eigen::Index j = 0; j < surfaces; ++j) {
      const int rule = data.rule(i, j);
      require("bodies",
              rule == data.rule(j, i) && rule >= BodiesData::no_rule &&
                  rule < static_cast<int>(data.rules.size()),
              "rule", rule, "a symmetric table of indices of rules, or no_rule");
    }
  }
  for (const BodyData& body : data.bodies) {
    for (const SphereData& sphere : body.spheres) known(sphere.surface);
    if (body.base) known(body.base->surface);
  }
  for (const PlaneData& plane : data.planes) known(plane.surface);
}

}  // namespace contensou
