#include "contensou/granular/contact_account.hpp"

#include <algorithm>
#include <cmath>

namespace contensou {
namespace {

using Touch = BodyMotion::Touch;
using Eigen::Vector3d;

/// What a step with mean velocities may add to a penetration, in parts of what counts as none.
constexpr double slack = 0.1;

/// Something to share by where a dragged body has no impulse [N s].
constexpr double least = 1e-200;

Twist mean(const Twist& a, const Twist& b) { return {(a.v + b.v) / 2, (a.omega + b.omega) / 2}; }

}  // namespace

void decide_touch(ContactSet& set, const std::vector<Approach>& approach, const std::vector<Twist>& before,
                  const std::vector<Twist>& after, double dt, std::vector<Touch>& touch) {
  const std::size_t still = touch.size();
  std::fill(touch.begin(), touch.end(), Touch::untouched);
  set.for_each_run([&](const auto&, const ContactSet::Run&, auto blocks) {
    for (const auto& c : blocks) {
      if (c.impulse.isZero(0)) continue;
      touch[c.first] = Touch::touched;
      if (c.second < still) touch[c.second] = Touch::touched;
    }
  });
  const auto dragged = [&](std::uint32_t body) { return body == still || touch[body] == Touch::dragged; };
  const auto moves = [&](std::uint32_t body) {
    return dragged(body) ? after[body] : mean(before[body], after[body]);
  };
  bool more = true;
  while (more) {
    more = false;
    set.for_each_run([&](const auto&, const ContactSet::Run&, auto blocks) {
      for (const auto& c : blocks) {
        if (dragged(c.first) && dragged(c.second)) continue;
        const Approach& a = approach[c.pair];
        if (a.gap + dt * a.velocity(moves(c.first), moves(c.second)) >= -slack * a.touching) continue;
        touch[c.first] = Touch::dragged;
        if (c.second < still) touch[c.second] = Touch::dragged;
        more = true;
      }
    });
  }
}

void add_dissipation(const BodiesData& data, ContactSet& set, const std::vector<Approach>& approach,
                     const std::vector<Twist>& before, const std::vector<Twist>& after,
                     const std::vector<double>& excess, std::vector<double>& load,
                     std::vector<Dissipation>& dissipated) {
  load.assign(before.size(), 0);
  set.for_each_run([&](const auto&, const ContactSet::Run&, auto blocks) {
    for (const auto& c : blocks) {
      load[c.first] += c.impulse[0] + least;
      load[c.second] += c.impulse[0] + least;
    }
  });
  const auto share = [&](std::uint32_t body, double impulse) {
    return body < excess.size() ? excess[body] * ((impulse + least) / load[body]) : 0;
  };
  const auto is_driven = [&](std::uint32_t body) {
    return body < data.bodies.size() && data.bodies[body].rotation == Rotation::driven;
  };
  set.for_each_run([&]<class Domain>(const Domain&, const ContactSet::Run& run, auto blocks) {
    Dissipation& d = dissipated[run.rule];
    for (const auto& c : blocks) {
      const auto work = (-0.5 * c.impulse.cwiseProduct(c.velocity(before) + c.velocity(after))).eval();
      const double moved = share(c.first, c.impulse[0]) + share(c.second, c.impulse[0]);
      d.impact += work[0];
      if constexpr (Domain::dimension == 0) {
        d.impact += moved;
      } else if (is_impact(approach[c.pair])) {
        d.impact += work.template tail<Domain::dimension>().sum() + moved;
      } else {
        d.sliding += work[1] + work[2] + moved;
        if constexpr (Domain::dimension == 3) d.drilling += work[3];
      }
      const Vector3d force = c.axes * c.impulse.template head<std::decay_t<decltype(c)>::directions>();
      Vector3d turning = Vector3d::Zero();
      if constexpr (Domain::dimension == 3) turning = c.radius * c.impulse[3] * c.axes.col(0);
      if (is_driven(c.first)) d.driven -= before[c.first].omega.dot(c.arm.cross(force) + turning);
      if (is_driven(c.second)) d.driven += before[c.second].omega.dot(c.other.cross(force) + turning);
    }
  });
}

}  // namespace contensou
