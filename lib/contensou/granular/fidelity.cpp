#include "contensou/granular/fidelity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace contensou {
namespace {

/// Calls function(rule, contact) for each contact that is solved as a point contact.
template <class Function>
void for_each_point(const BodiesData& data, ContactSet& set, Function&& function) {
  set.for_each_run([&](const auto&, const ContactSet::Run& run, auto blocks) {
    if constexpr (std::is_same_v<typename decltype(blocks)::value_type, ContactBlock<3>>) {
      if (!run.as_point) return;
      for (const auto& c : blocks) function(data.rules[run.rule], c);
    }
  });
}

}  // namespace

double point_error(const AnyFriction& friction, double v, double s) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(v > 0)) return infinity;
  if (s == 0) return 0;
  return std::visit(
      [&](const auto& domain) {
        if constexpr (requires { domain.boundary_point(1.0, Eigen::Vector3d()); }) {
          const Eigen::Vector3d border = domain.boundary_point(1, Eigen::Vector3d(v, 0, s));
          return std::max(1 - border[0], border[2]);
        } else {
          return infinity;
        }
      },
      friction);
}

double point_error(const AnyFriction& friction, double radius, const ContactBlock<3>& c,
                   const std::vector<Twist>& twists) {
  const double v = c.velocity(twists).tail<2>().norm();
  const double spin = c.axes.col(0).dot(twists[c.first].omega - twists[c.second].omega);
  return point_error(friction, v, radius * std::abs(spin));
}

bool refuse_points(const BodiesData& data, ContactSet& set, const std::vector<Twist>& after, double fidelity,
                   PairList& list) {
  bool any = false;
  for_each_point(data, set, [&](const SystemContact& rule, const ContactBlock<3>& c) {
    if (c.impulse[0] == 0 || point_error(rule.friction, rule.radius, c, after) <= fidelity) return;
    list.pairs()[c.pair].exact = true;
    any = true;
  });
  return any;
}

void add_left_out(const BodiesData& data, ContactSet& set, const std::vector<Twist>& before,
                  const std::vector<Twist>& after, LeftOut& left_out) {
  for_each_point(data, set, [&](const SystemContact& rule, const ContactBlock<3>& c) {
    if (c.impulse[0] == 0) return;
    const double error = std::max(point_error(rule.friction, rule.radius, c, before),
                                  point_error(rule.friction, rule.radius, c, after));
    ++left_out.as_coulomb;
    left_out.friction = std::max(left_out.friction, error);
    left_out.impulse += error * rule.mu * c.impulse[0];
  });
}

}  // namespace contensou
