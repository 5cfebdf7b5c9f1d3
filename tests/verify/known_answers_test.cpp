// What the integrators make of motions that are known.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>

#include "../system/small_contacts.hpp"
#include "contensou/law/uniform.hpp"
#include "contensou/system/ball_on_plane.hpp"
#include "contensou/system/free_body.hpp"
#include "contensou/system/harmonic_oscillator.hpp"
#include "contensou/system/point_mass.hpp"
#include "contensou/system/sliding_disc.hpp"
#include "motions/ball_slide.hpp"
#include "motions/bounces.hpp"
#include "motions/free_rotation.hpp"
#include "motions/point_slide.hpp"
#include "motions/slide_and_spin.hpp"

using namespace contensou;
using namespace known_motions;
using namespace system_test;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double gravity = 2;
constexpr double mu = 0.9;
constexpr double tilt = 0.4;

IntegratorOptions tight(double tolerance) {
  IntegratorOptions options;
  options.method = Method::event_driven;
  options.tolerance = tolerance;
  return options;
}

IntegratorOptions moreau(double step) {
  IntegratorOptions options;
  options.method = Method::moreau;
  options.step = step;
  return options;
}

/// Lengths, velocities and rates are of order one and none of these motions amplifies errors: what each step
/// and each event may add, twice.
double allowed(const RunReport& report, double tolerance) {
  return 2 * tolerance * static_cast<double>(report.steps + std::int64_t(report.events.size()) + 1);
}

State state_of(std::initializer_list<double> q, std::initializer_list<double> u) {
  State s{0, Eigen::VectorXd(Eigen::Index(q.size())), Eigen::VectorXd(Eigen::Index(u.size()))};
  std::copy(q.begin(), q.end(), s.q.begin());
  std::copy(u.begin(), u.end(), s.u.begin());
  return s;
}

/// What rounding of the balance of forces, of the size of gravity, may add up to at rest in the time t: a few
/// of its terms.
double resting_speed(double t) { return 8 * 0x1p-53 * gravity * t; }

/// Runs to t; reports must say that it was reached.
RunReport run(const MechanicalSystem& system, State& state, double t, const IntegratorOptions& options) {
  RunReport report = integrate(system, state, t, options);
  INFO(report.message);
  CHECK(report.status == RunStatus::finished);
  CHECK(state.t == t);
  return report;
}

double time_of(const RunReport& report, EventKind kind) {
  for (const Event& e : report.events) {
    if (e.kind == kind) return e.t;
  }
  return NAN;
}

}  // namespace

TEST_CASE("Known answers, event_driven: oscillator and free body", "[known]") {
  for (const double tolerance : {1e-7, 1e-10}) {
    const HarmonicOscillator oscillator({.m = 1, .k = 1.7});
    State s = state_of({0.8}, {0});
    const RunReport swings = run(oscillator, s, 20, tight(tolerance));
    const double phase = 20 * std::sqrt(1.7);
    // an error in the phase grows with the time it has to act: one factor of √k
    CHECK(std::abs(s.q[0] - 0.8 * std::cos(phase)) <= 2 * allowed(swings, tolerance));
    CHECK(std::abs(s.u[0] + 0.8 * std::sqrt(1.7) * std::sin(phase)) <= 2 * allowed(swings, tolerance));

    const Vector3d inertia(0.7, 1.1, 1.5), omega(0.3, -0.2, 0.9);
    const FreeBody body({inertia[0], inertia[1], inertia[2]});
    State turning = state_of({1, 0, 0, 0}, {omega[0], omega[1], omega[2]});
    const RunReport turns = run(body, turning, 20, tight(tolerance));
    const FreeRotation known(inertia, omega);
    // an error in ω turns the attitude by up to 20 s of it
    CHECK((turning.u - known.omega(20)).norm() <= 20 * allowed(turns, tolerance));
    CHECK((body.attitude(turning.q) - known.attitude(20)).norm() <= 20 * allowed(turns, tolerance));
  }
}

TEST_CASE("Known answers, event_driven: bounces and their accumulation", "[known]") {
  constexpr double tolerance = 1e-10;
  SystemContact floor = smooth_floor();
  floor.restitution = 0.6;
  const PointMass ball({.m = 1.3, .g = gravity}, floor);
  const Bounces known(1.2, 0.7, gravity, 0.6);

  State s = state_of({0, 0, 1.2}, {0.3, 0, 0.7});
  const double between = (known.impact_time(2) + known.impact_time(3)) / 2 + 0.01;
  const RunReport flying = run(ball, s, between, tight(tolerance));
  CHECK(std::abs(s.q[2] - known.at(between).z) <= allowed(flying, tolerance));
  CHECK(std::abs(s.u[2] - known.at(between).velocity) <= allowed(flying, tolerance));

  const RunReport resting = run(ball, s, known.accumulation_time() + 1, tight(tolerance));
  CHECK(std::abs(s.q[2]) <= tolerance);
  CHECK(std::abs(s.u[2]) <= tolerance);
  CHECK(std::abs(s.q[0] - 0.3 * s.t) <= allowed(resting, tolerance));

  // Gaps are zero to 1e-12 of the length. A landing so far off the floor at the speed v is δ/v early or late
  // and g δ/v fast or slow, and what follows is 2ε/(1 − ε) δ/v off; all of them, in geometric progression, up
  // to the last that was located.
  constexpr double gap = 1e-12;
  const double spread = (1 + 2 * 0.6 / (1 - 0.6)) / (1 - 0.6) * gap;
  const auto impacts = [&](std::size_t k) { return known.impact_time(static_cast<int>(k)); };
  std::size_t k = 0;
  double speed = 0;
  const double end = time_of(resting, EventKind::accumulation);
  for (const auto* part : {&flying, &resting}) {
    for (const Event& e : part->events) {
      if (e.kind == EventKind::accumulation) {
        CHECK(std::abs(e.t - known.accumulation_time()) <= spread / speed + allowed(resting, tolerance));
        break;
      }
      if (e.kind != EventKind::close || e.t == end) continue;  // where it closes for good
      speed = std::sqrt(0.7 * 0.7 + 2 * gravity * 1.2) * std::pow(0.6, k);
      CHECK(std::abs(e.t - impacts(k)) <= spread / speed + 1e-14);
      ++k;
    }
  }
  CHECK(k > 18);
  CHECK(!std::isnan(time_of(resting, EventKind::accumulation)));
  // all kinetic energy but that of sliding went in impacts
  REQUIRE(flying.dissipated.size() == 1);
  CHECK(std::abs(flying.dissipated[0].impact + resting.dissipated[0].impact -
                 1.3 * (gravity * 1.2 + 0.7 * 0.7 / 2)) <= 1.3 * gravity * allowed(resting, tolerance));
}

TEST_CASE("Known answers, event_driven: a block sticks under half the friction limit", "[known]") {
  const PointMass block({.m = 1.3, .g = gravity, .force_x = mu * 1.3 * gravity / 2}, coulomb_floor(mu));
  State s = state_of({0.1, 0.2, 0}, {0, 0, 0});
  const RunReport report = run(block, s, 10, tight(1e-10));
  CHECK(s.u.norm() <= resting_speed(10));
  CHECK((s.q - Vector3d(0.1, 0.2, 0)).norm() <= 10 * resting_speed(10) + 1e-16);
  CHECK(report.events.empty());
  CHECK(std::abs(report.dissipated[0].total()) <= 1e-14);
}

TEST_CASE("Known answers, event_driven: a block slides to rest on an incline", "[known]") {
  const PointMass block({.m = 1.3, .g = gravity, .tilt = tilt}, coulomb_floor(mu));
  const Vector2d start(0.8, 1.1);
  const PointSlide known(start, gravity * std::sin(tilt), mu * gravity * std::cos(tilt));
  for (const double tolerance : {1e-7, 1e-10}) {
    State s = state_of({0, 0, 0}, {start[0], start[1], 0});
    const double middle = 0.6 * known.stopping_time();
    const RunReport sliding = run(block, s, middle, tight(tolerance));
    CHECK((s.u.head<2>() - known.at(middle).velocity).norm() <= allowed(sliding, tolerance));
    CHECK((s.q.head<2>() - known.at(middle).displacement).norm() <= allowed(sliding, tolerance));
    const RunReport report = run(block, s, known.stopping_time() + 1, tight(tolerance));
    // both runs' errors; that of the time is one of velocity by the deceleration, at least d − f
    const double error = allowed(sliding, tolerance) + allowed(report, tolerance);
    CHECK((s.q.head<2>() - known.at(s.t).displacement).norm() <= 2 * error);
    CHECK(s.u.norm() <= tolerance);
    CHECK(std::abs(time_of(report, EventKind::stick) - known.stopping_time()) <=
          error / (mu * gravity * std::cos(tilt) - gravity * std::sin(tilt)));
  }
}

TEST_CASE("Known answers, event_driven: a ball slides, then rolls down", "[known]") {
  constexpr double tolerance = 1e-10;
  const BallOnPlaneData data{.m = 1.3, .r = 0.7, .g = gravity, .tilt = tilt};
  const BallOnPlane ball(data, coulomb_floor(mu));
  const double pull = gravity * std::sin(tilt);
  const Vector2d contact(1.1, 0.8), velocity(0.4, -0.6);
  const PointSlide gamma(contact, pull, 3.5 * mu * gravity * std::cos(tilt));
  const BallSlide known{velocity, contact, pull};
  const Vector2d spin = BallSlide::spin(velocity, contact, data.r);
  State s = state_of({0, 0, data.r}, {velocity[0], velocity[1], 0, spin[0], spin[1], 0.9});
  const double end = gamma.stopping_time() + 1;
  const RunReport report = run(ball, s, end, tight(tolerance));
  const Vector2d rolling = known.velocity(end, {0, 0});
  const Vector2d turning = BallSlide::spin(rolling, {0, 0}, data.r);
  const double error = 2 * allowed(report, tolerance);
  CHECK((s.u - Eigen::VectorXd{{rolling[0], rolling[1], 0, turning[0], turning[1], 0.9}}).norm() <=
        error / data.r);
  CHECK((s.q.head<2>() - known.displacement(end, gamma.at(end).displacement)).norm() <= error);
  CHECK(std::abs(time_of(report, EventKind::stick) - gamma.stopping_time()) <= error);
}

TEST_CASE("Known answers, event_driven: a disc slides and spins to rest", "[known]") {
  const double radius = 0.8;
  const double i = 1.3 * radius * radius / 2;
  const SlidingDisc disc({.m = 1.3, .i = i, .g = gravity}, uniform_floor(mu, radius));
  const double a = mu * gravity;
  const SlideAndSpin known(UniformLaw{}, a, 2 * a, 1.6, 1.2 * radius);
  for (const double tolerance : {1e-7, 1e-10}) {
    State s = state_of({0, 0, 0, 0}, {1.6, 0, 0, -1.2});
    RunReport report;
    double error = 0;
    for (const double part : {0.3, 0.9}) {  // past u = 1 between them
      const double t = part * known.stopping_time();
      report = run(disc, s, t, tight(tolerance));
      error += allowed(report, tolerance) / radius;
      const auto p = known.at(t);
      CHECK(std::abs(s.u[0] - p.v) <= error);
      CHECK(std::abs(s.u[3] + p.s / radius) <= error);
      CHECK(std::abs(s.q[0] - p.slid) <= error);
      CHECK(std::abs(s.q[3] + p.turned / radius) <= error);
    }
    report = run(disc, s, known.stopping_time() + 1, tight(tolerance));
    error += 2 * allowed(report, tolerance) / radius;
    const auto p = known.at(s.t);
    CHECK(std::abs(s.q[0] - p.slid) <= error);
    CHECK(std::abs(s.q[3] + p.turned / radius) <= error);
    CHECK(s.u.norm() <= resting_speed(s.t));
    CHECK(std::abs(time_of(report, EventKind::stick) - known.stopping_time()) <= error);
  }
}

TEST_CASE("Known answers, moreau: order 2 where the motion is smooth, sticks in stick", "[known]") {
  const auto error = [](const MechanicalSystem& system, State s, double t, double step, const auto& known) {
    const RunReport report = run(system, s, t, moreau(step));
    CHECK(report.events.empty());
    return (s.u - known(t)).norm();
  };
  const auto check_order = [&](const MechanicalSystem& system, const State& s, const auto& known) {
    const double coarse = error(system, s, 0.5, 0.005, known);
    const double fine = error(system, s, 0.5, 0.0025, known);
    INFO(coarse << " " << fine);
    CHECK(std::log2(coarse / fine) > 1.8);
    CHECK(std::log2(coarse / fine) < 2.2);
  };
  check_order(HarmonicOscillator({.m = 1, .k = 1.7}), state_of({0.8}, {0}), [](double t) -> Eigen::VectorXd {
    return Eigen::VectorXd{{-0.8 * std::sqrt(1.7) * std::sin(std::sqrt(1.7) * t)}};
  });
  const Vector3d omega(0.3, -0.2, 0.9);
  check_order(FreeBody({0.7, 1.1, 1.5}), state_of({1, 0, 0, 0}, {omega[0], omega[1], omega[2]}),
              [&](double t) -> Eigen::VectorXd {
                return FreeRotation({0.7, 1.1, 1.5}, omega).omega(t);
              });
  const PointSlide slide({0.8, 1.1}, gravity * std::sin(tilt), mu * gravity * std::cos(tilt));
  check_order(PointMass({.m = 1.3, .g = gravity, .tilt = tilt}, coulomb_floor(mu)),
              state_of({0, 0, 0}, {0.8, 1.1, 0}), [&](double t) -> Eigen::VectorXd {
                const Vector2d w = slide.at(t).velocity;
                return Vector3d(w[0], w[1], 0);
              });
  const double radius = 0.8;
  const double i = 1.3 * radius * radius / 2;
  const SlideAndSpin spins(UniformLaw{}, mu * gravity, 2 * mu * gravity, 1.6, 1.2 * radius);
  check_order(SlidingDisc({.m = 1.3, .i = i, .g = gravity}, uniform_floor(mu, radius)),
              state_of({0, 0, 0, 0}, {1.6, 0, 0, 1.2}), [&](double t) -> Eigen::VectorXd {
                const auto p = spins.at(t);
                return Eigen::Vector4d(p.v, 0, 0, p.s / radius);
              });

  const PointMass block({.m = 1.3, .g = gravity, .force_x = mu * 1.3 * gravity / 2}, coulomb_floor(mu));
  State s = state_of({0.1, 0.2, 0}, {0, 0, 0});
  const RunReport report = run(block, s, 10, moreau(0.01));
  CHECK(report.events.empty());
  // forces balance to the solver's tolerance, 1e-12 of what gravity does in a step; nothing adds up but that
  CHECK(s.u.norm() <= 1e-12 * gravity * 0.01);
  CHECK((s.q - Vector3d(0.1, 0.2, 0)).norm() <= 1e-12 * gravity * 0.01 * 10);
}
