// Tables 1 and 2 in one contact that is closed, or about to be: PointMass, by integrate().

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "checks.hpp"
#include "contensou/integrate/motion.hpp"
#include "contensou/system/point_mass.hpp"
#include "measure.hpp"

namespace verify::integrators {
namespace {

using namespace contensou;
using Eigen::Vector3d;

constexpr double mass = 2, gravity = 9.81, friction = 0.5;

PointMass point_on_floor(double mu) {
  return {PointMassData{.m = mass, .g = gravity},
          SystemContact{"floor", AnyFriction{FrictionDisk{}}, mu, 0, 0}};
}

/// R(z) of Runge, Kutta's method of order 4.
double amplification(double z) { return 1 + z * (1 + z / 2 * (1 + z / 3 * (1 + z / 4))); }

struct Growth {
  double factor;  ///< the velocity after a step over that before
  double spread;  ///< largest less smallest of them
};

/// In the floor by what integrate() takes for rounding, and sinking by far less in all steps together, so
/// that all stages touch; so slow that friction's bounds are far.
Growth growth(Method method, int steps) {
  const PointMass point = point_on_floor(friction);
  const double dt = 1e-9;
  State state{0, Vector3d(0, 0, -1e-13), Vector3d(1e-16, 0, 0)};
  IntegratorOptions options;
  options.method = method;
  options.step = dt;
  options.solver_tolerance = 1e-26;  // a rounding of the smallest impulse, 2 kg · 1e-16 m/s
  double least = INFINITY, most = -INFINITY;
  for (int k = 0; k < steps; ++k) {
    const double before = state.u[0];
    const RunReport report = integrate(point, state, state.t + dt, options);
    if (report.status != RunStatus::finished) return {NAN, NAN};
    const double factor = state.u[0] / before;
    least = std::min(least, factor), most = std::max(most, factor);
    if (state.u[0] == 0) break;
  }
  return {most, most - least};
}

/// How fast a block at rest in the floor moves, steps or more after a nudge of 1e-9 m/s, at the most, in
/// units of μgΔt.
double ringing(Method method, double dt) {
  const PointMass point = point_on_floor(friction);
  // As deep in the floor as the sums of steps of g·Δt²/2 do not lift it.
  State state{0, Vector3d(0, 0, -1e-13), Vector3d(1e-9, 0, 0)};
  IntegratorOptions options;
  options.method = method;
  options.step = options.output_interval = dt;
  double fastest = 0;
  const RunReport report = integrate(point, state, 100 * dt, options, [&](const Sample& s) {
    if (s.t > 50 * dt) fastest = std::max(fastest, std::abs(s.u[0]));
  });
  return report.status == RunStatus::finished ? fastest / (friction * gravity * dt) : NAN;
}

struct Rebounds {
  double least = INFINITY, most = 0;  ///< upwards after the impact, over the impact's speed
};

/// The first velocity upwards after an impact with v ≫ gΔt, over where in its step the impact falls.
Rebounds rebounds(Method method, double dt) {
  const PointMass point = point_on_floor(0);
  const double v = 10;
  Rebounds all;
  for (int k = 0; k < 400; ++k) {
    State state{0, Vector3d(0, 0, (k + 0.5) / 400 * v * dt), Vector3d(0, 0, -v)};
    IntegratorOptions options;
    options.method = method;
    options.step = options.output_interval = dt;
    double up = 0;
    const RunReport report = integrate(point, state, 4 * dt, options, [&](const Sample& s) {
      if (up == 0 && s.u[2] > 1e-3 * v) up = s.u[2] / v;
    });
    if (report.status != RunStatus::finished) up = NAN;
    all.least = std::min(all.least, up), all.most = std::max(all.most, up);
  }
  return all;
}

}  // namespace

void check_printed_contact(Record& record, Findings& found) {
  const double predicted = amplification(-4);
  const Growth two = growth(Method::rk4_printed, 8), one = growth(Method::moreau_printed, 8);
  record.add(
      Claim{"integrators.printed.growth.rk4_printed", "LG03 Table 2",
            "a contact that sticks in all stages multiplies a small sliding velocity by R(-4) of the method "
            "of order 4 (a_m = -4 gamma/dt) in each of 8 steps",
            predicted, two.factor, std::max(std::abs(two.factor / predicted - 1), two.spread / predicted),
            1e-6, true});
  record.add(Claim{"integrators.printed.stable.rk4_printed", "LG03 Table 2",
                   "a contact that sticks is linearly stable: the factor is at most 1", 1, two.factor,
                   two.factor - 1, 0, false});
  record.add(Claim{"integrators.printed.growth.moreau_printed", "LG03 Table 1",
                   "a contact that sticks ends a small sliding velocity in one step: factor", 0, one.factor,
                   std::abs(one.factor), 1e-9, true});
  found["growth.rk4_printed"] = two.factor;
  found["growth.moreau_printed"] = one.factor;

  // What it grows to: stages of -mu g and +mu g in turn, over a step of dt, so some part of mu g dt; and not
  // less than where the linear law ends, |4 gamma| = mu g dt.
  for (const double dt : {1e-3, 1e-4}) {
    const double large = ringing(Method::rk4_printed, dt);
    record.add(Claim{"integrators.printed.ringing.rk4_printed." + text(dt), "LG03 Table 2",
                     "a nudge of 1e-9 m/s to a block at rest dies out within 50 steps of " + text(dt) +
                         " s: what is left of it, in mu g dt",
                     0, large, large, 1e-6, false});
    found["ringing.rk4_printed." + text(dt)] = large;
    const double none = ringing(Method::moreau_printed, dt);
    record.add(Claim{"integrators.printed.ringing.moreau_printed." + text(dt), "LG03 Table 1",
                     "a nudge of 1e-9 m/s to a block at rest dies out within 50 steps of " + text(dt) +
                         " s: what is left of it, in mu g dt",
                     0, none, none, 1e-6, true});
  }

  const Rebounds coarse = rebounds(Method::rk4_printed, 1e-5), fine = rebounds(Method::rk4_printed, 1e-7);
  // From (1/9) v to (1/3) v; gravity adds some g dt each step.
  const double off = std::max(std::abs(fine.least - 1.0 / 9), std::abs(fine.most - 1.0 / 3));
  record.add(Claim{"integrators.printed.rebound.rk4_printed", "LG03 Table 2",
                   "an inelastic impact throws back with 1/9 to 1/3 of its speed, dt = 1e-7 s: largest",
                   1.0 / 3, fine.most, off, 1e-6, true});
  record.add(Claim{"integrators.printed.inelastic.rk4_printed", "LG03 Table 2",
                   "an inelastic impact leaves no velocity upwards, dt = 1e-7 s: largest, over the impact's",
                   0, fine.most, fine.most, 1e-6, false});
  const Rebounds moreau = rebounds(Method::moreau_printed, 1e-7);
  record.add(Claim{"integrators.printed.inelastic.moreau_printed", "LG03 Table 1",
                   "an inelastic impact leaves no velocity upwards, dt = 1e-7 s: largest, over the impact's",
                   0, moreau.most, moreau.most, 1e-6, true});
  found["rebound.least.rk4_printed"] = fine.least;
  found["rebound.most.rk4_printed"] = fine.most;
  found["rebound.coarse.rk4_printed"] = coarse.most;
}

}  // namespace verify::integrators
