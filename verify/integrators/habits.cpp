// What a scheme does where nothing should happen: a body that fell inelastically, a block at rest, energy;
// and to the nutation of the top, in the air and on the floor.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "checks.hpp"
#include "contensou/output/table.hpp"
#include "contensou/system/point_mass.hpp"
#include "contensou/system/tippe_top_axis.hpp"
#include "contensou/system/tippe_top_euler.hpp"
#include "measure.hpp"
#include "motions.hpp"
#include "nutation.hpp"

namespace verify::integrators {
namespace {

using namespace contensou;
using Eigen::Vector3d;

constexpr double mass = 2, gravity = 9.81;

/// One habit of one scheme.
struct Habits {
  Table& table;
  Record& record;
  Findings& found;

  void note(const std::string& what, Method method, const std::string& formulation, double setting,
            const std::string& quantity, double value) {
    table.add({what, std::string(name(method)), formulation, setting, quantity, value});
    found[what + "." + quantity + "." + name(method) + (formulation == "euler" ? ".euler" : "") + "." +
          text(setting)] = value;
  }
  void claim(const std::string& what, Method method, double setting, const std::string& words, double value,
             double bound, bool should_hold = true) {
    record.add(Claim{"integrators." + what + "." + name(method) + "." + text(setting), "integrators",
                     std::string(name(method)) + ", " + text(setting) + ": " + words, 0, value, value, bound,
                     should_hold});
  }
};

std::vector<double> settings(Method method) {
  if (has_fixed_step(method)) return {1e-3, 1e-4};
  return {1e-6, 1e-9};
}

// --- a body dropped with ε = 0 ---

void drop(Method method, double setting, Habits& habits) {
  const PointMass point{{.m = mass, .g = gravity}, {"floor", AnyFriction{NoFriction{}}, 0, 0, 0}};
  const double sampled = has_fixed_step(method) ? setting : 1e-3;
  double up = 0, height = 0, depth = 0, landed = 0, resting = 0;
  for (int k = 0; k < 20; ++k) {
    const double z = 0.1 + 7.3e-5 * k;
    const double speed = std::sqrt(2 * gravity * z), landing = speed / gravity;
    const Run r = run(
        point, {0, Vector3d(0, 0, z), Vector3d::Zero()}, 2, method, setting,
        [&](const Sample& s) {
          depth = std::max(depth, -s.q[2]);
          // One step to land in, and one for what is late by less.
          if (s.t > landing + 2 * sampled) {
            up = std::max(up, s.u[2] / speed);
            height = std::max(height, s.q[2]);
          }
        },
        sampled);
    if (std::abs(r.end.q[2]) > std::abs(resting)) resting = r.end.q[2];
    if (!r.finished()) up = height = depth = landed = resting = NAN;
    for (const Event& event : r.report.events) {
      if (event.kind != EventKind::close) continue;
      landed = std::max(landed, std::abs(event.t - landing));
      break;
    }
  }
  habits.note("drop", method, "", setting, "rebound_velocity", up);
  habits.note("drop", method, "", setting, "rebound_height", height);
  habits.note("drop", method, "", setting, "penetration", depth);
  habits.note("drop", method, "", setting, "resting_height", resting);
  habits.note("drop", method, "", setting, "landing_error", landed);
  const bool rebounds = method == Method::rk4_printed;
  habits.claim("drop.rebound", method, setting,
               "an inelastic impact leaves no velocity upwards: largest, over the impact's", up, 1e-9,
               !rebounds);
  // One step at the impact's speed, 1.42 m/s; of the others a step's own curvature, gΔt², or rounding.
  const bool printed = method == Method::moreau_printed || rebounds;
  const double deep = printed ? 1.5 * setting : has_fixed_step(method) ? gravity * setting * setting : 1e-9;
  habits.claim("drop.penetration", method, setting, "depth in the floor [m]", depth, deep);
}

// --- a block at rest pushed with half the limit of friction ---

void push(Method method, double setting, Habits& habits) {
  const double mu = 0.5, rest = 1, end = 11;
  const PointMass block{{.m = mass, .g = gravity, .force_x = mu * mass * gravity / 2},
                        {"floor", AnyFriction{FrictionDisk{}}, mu, 0, 0}};
  // From rest on the floor; and set down from a millimetre, when it slides a little before it rests.
  for (const double height : {0.0, 1e-3}) {
    double from = NAN;
    const Run r = run(
        block, {0, Vector3d(0, 0, height), Vector3d::Zero()}, end, method, setting,
        [&](const Sample& s) {
          if (s.t >= rest && std::isnan(from)) from = s.q[0];
        },
        rest);
    const double creep = r.finished() ? std::abs(r.end.q[0] - from) : NAN;
    const bool laid = height == 0;
    habits.note("push", method, "", setting, laid ? "creep_laid" : "creep_set_down", creep);
    habits.claim(laid ? "push.laid" : "push.set_down", method, setting,
                 std::string("a block pushed with half the limit of friction, ") +
                     (laid ? "laid" : "set down") + " on the floor, stays for 10 s: how far it went [m]",
                 creep, 1e-12);
  }
}

// --- the top: nutation and energy ---

constexpr double tight = 1e-12;
constexpr double nutation_steps[] = {1e-3, 5e-4, 2e-4, 1e-4};
constexpr double nutation_tolerances[] = {1e-6, 1e-8, 1e-10};
constexpr double fitted = 0.4;  ///< rates are of this time [s]: on the floor, while all is small

/// The top in the air, or at the start of LG03 5.4, in both formulations.
struct Place {
  const char* name;
  double duration;
  State in_axis, in_euler;
};

State thrown(State s, const Vector3d& nodal) {
  s.u.tail<3>() += nodal;
  return s;
}

/// What theory says the scheme adds to the rate of growth of a nutation of frequency ω; nothing where it is
/// left to be measured.
struct Rate {
  double expected;
  double bound;  ///< of the difference
};

std::optional<Rate> numerical_rate(Method method, bool axis, double omega, double dt) {
  const double y = omega * dt;
  // |R(iy)| of backward Euler; |R(iy)| <= 1 of the SDIRK method, 1 − |R| < y⁴; |R(iy)|² = 1 − y⁶/72 + y⁸/576.
  if (method == Method::moreau_implicit)
    return Rate{-std::log1p(y * y) / (2 * dt), 0.05 * std::log1p(y * y) / (2 * dt)};
  if (method == Method::moreau) return Rate{0, y * y * y * omega};
  if (method == Method::rk4) return Rate{-std::pow(y, 5) / 144 * omega, std::pow(y, 5) / 144 * omega};
  // h taken at the old velocity is forward Euler for the gyroscopic forces of Euler's angles.
  if (method == Method::moreau_printed && !axis && y < 0.02) return Rate{y * omega / 2, 0.1 * y * omega / 2};
  return std::nullopt;
}

/// ln(amplitude) per second from the first window to the fourth.
double growth(const Nutation& n) {
  constexpr std::size_t last = 3;
  return n.finished ? std::log(n.amplitude[last] / n.amplitude[0]) / (n.middle[last] - n.middle[0]) : NAN;
}

void nutate(const std::filesystem::path& folder, Habits& habits) {
  const std::array<SystemContact, 2> contacts =
      tippe_top_contacts(AnyFriction{FrictionBall(SmoothPlate(HertzLaw{}))});
  const TippeTopAxis axis{TippeTopData{}, contacts};
  const TippeTopEuler euler{TippeTopData{}, contacts};
  // 20 rad/s about the line of nodes, e_1 at the start.
  const Place places[] = {{"flight", fitted, thrown(axis.start(0.7, 180, 1), Vector3d(20, 0, 0)),
                           thrown(euler.start(0.7, 180, 1), Vector3d(20, 0, 0))},
                          {"floor", 1.2, axis.start(0.1, 180), euler.start(0.1, 180)}};
  Table curves{
      {"Amplitude of the nutation [rad/s], root of the mean square of |d e/dt| of the axis e in windows of "
       "0.05 s about t [s], beside the reference's (event_driven, 1e-12).",
       "where: flight (free, 20 rad/s across the axis), floor (the start of LG03 5.4, Hertz). formulation: "
       "axis, or the Euler angles of LG03. setting: step [s] or tolerance.",
       "A curve that ends early is a run that did."},
      {"where", "scheme", "formulation", "setting", "t", "amplitude", "reference"},
      {}};
  for (const Place& place : places) {
    const Nutation reference = nutation(axis, place.in_axis, place.duration, Method::event_driven, tight);
    const double omega = nutation_frequency(axis, place.in_axis, fitted);
    const std::string where = place.name;
    habits.found["nutation.frequency." + where] = omega;
    habits.found["nutation.growth." + where] = growth(reference);
    const double start = energy(axis, place.in_axis);
    for (const Method method : schemes) {
      for (const bool in_axis : {true, false}) {
        const auto settings =
            has_fixed_step(method)
                ? std::vector<double>(std::begin(nutation_steps), std::end(nutation_steps))
                : std::vector<double>(std::begin(nutation_tolerances), std::end(nutation_tolerances));
        for (const double setting : settings) {
          const TippeTopModel& top = in_axis ? static_cast<const TippeTopModel&>(axis) : euler;
          const Nutation n =
              nutation(top, in_axis ? place.in_axis : place.in_euler, place.duration, method, setting);
          const std::string formulation = in_axis ? "axis" : "euler";
          const auto note = [&](const char* quantity, double value) {
            habits.note("nutation_" + where, method, formulation, setting, quantity, value);
          };
          const double rate = n.finished ? rate_beside(n, reference, fitted) : NAN;
          note("finished_until", n.finished ? place.duration : n.end.t);
          note("numerical_rate", rate);
          note("amplitude_ratio", n.finished ? n.amplitude.back() / reference.amplitude.back() : NAN);
          const double balance = n.finished ? (energy(top, n.end) + dissipated(n.report)) / start - 1 : NAN;
          note("energy_balance", balance);
          note("energy_error", n.finished ? (energy(top, n.end) - energy(axis, reference.end)) / start : NAN);
          for (std::size_t k = 0; k < n.amplitude.size() && std::isfinite(n.amplitude[k]); ++k) {
            curves.add({where, std::string(name(method)), formulation, setting, n.middle[k], n.amplitude[k],
                        reference.amplitude[k]});
          }
          const std::string id = "nutation." + where + "." + formulation;
          if (const auto forecast = numerical_rate(method, in_axis, omega, setting);
              forecast && where == "flight") {
            habits.record.add(
                Claim{"integrators." + id + "." + name(method) + "." + text(setting), "integrators",
                      std::string(name(method)) + ", " + text(setting) +
                          " s: numerical growth of the nutation in flight [1/s]",
                      forecast->expected, rate, std::abs(rate - forecast->expected), forecast->bound, true});
          }
          const bool finest = setting == settings.back();
          if (where == "floor" && in_axis && finest &&
              (method == Method::rk4 || method == Method::event_driven)) {
            habits.claim("energy.slip", method, setting,
                         "kinetic, potential and dissipated energy of 1.2 s of slip add up, relative",
                         std::abs(balance), 1e-9);
          }
        }
      }
    }
  }
  write_table(curves, folder / "integrator_nutation.tsv");
  // The same on its tip, nearly upright: nutation that the contact damps.
  constexpr double tip_time = 0.25;
  const State upright = axis.start(std::numbers::pi - 0.1, -180);
  const Nutation on_tip = nutation(axis, upright, tip_time, Method::event_driven, tight);
  habits.found["nutation.growth.tip"] = growth(on_tip);
  habits.found["nutation.frequency.tip"] = nutation_frequency(axis, upright, Nutation::window);
}

}  // namespace

void check_habits(const std::filesystem::path& folder, Record& record, Findings& found) {
  Table table{
      {"What the integrators do where little should happen; SI units. setting: step [s] or tolerance.",
       "drop: a point from 0.1 m (20 heights, worst), inelastic. rebound_velocity over the impact's; "
       "rebound_height, penetration, resting_height after 2 s [m]; landing_error [s]: of the time of the "
       "event.",
       "push: a block on the floor pushed with half the limit of friction: how far it went in 10 s [m], laid "
       "there or set down from 1 mm.",
       "nutation_flight, nutation_floor: the top, LG03 5.4. numerical_rate [1/s]: growth of the nutation's "
       "amplitude beside the exact motion's, over 0.4 s; amplitude_ratio at the end (0.4 s, 1.2 s); "
       "energy_balance: what is missing or too much, energy_error: difference to the exact motion's, both "
       "over "
       "the energy at the start.",
       "finished_until: the run's end [s], early where it broke down."},
      {"what", "scheme", "formulation", "setting", "quantity", "value"},
      {}};
  Habits habits{table, record, found};
  for (const Method method : schemes) {
    for (const double setting : settings(method)) {
      drop(method, setting, habits);
      push(method, setting, habits);
    }
  }
  nutate(folder, habits);
  write_table(table, folder / "integrator_habits.tsv");
}

}  // namespace verify::integrators
