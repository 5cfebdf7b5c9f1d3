// Many bodies: against closed-form motions, the energy account, and starts that make no sense.

#include "contensou/granular/nscd.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "balls.hpp"
#include "contensou/system/ball_on_plane.hpp"

using namespace contensou;
using balls::add_ball;
using balls::add_plane;

namespace {

const AnyFriction none{NoFriction{}};
const AnyFriction coulomb{FrictionDisk{}};
const AnyFriction hertz{FrictionBall(SmoothPlate(HertzLaw{}))};

IntegratorOptions options(double step, double tolerance = 1e-10) {
  IntegratorOptions o;
  o.method = Method::nscd;
  o.step = step;
  o.solver_tolerance = tolerance;
  return o;
}

/// Height of a ball that falls from `height` above its resting place and bounces, before its impacts
/// accumulate.
double bouncing(double height, double restitution, double t) {
  const double g = 9.81;
  double fall = std::sqrt(2 * height / g);
  if (t < fall) return height - g * t * t / 2;
  double speed = restitution * g * fall;
  t -= fall;
  while (t > 2 * speed / g) {
    t -= 2 * speed / g;
    speed *= restitution;
  }
  return speed * t - g * t * t / 2;
}

double bounce_error(double step) {
  BodiesData data = balls::scene(none, 0, 0.8);
  add_plane(data, {0, 0, 1}, 0);
  add_ball(data, 0.1, 0.05, {0, 0, 0.05 + 0.5});
  const BodyLayout layout(data);
  State state = layout.start();
  const RunReport report = run_nscd(data, state, 1.3, options(step), 1);
  REQUIRE(report.status == RunStatus::finished);
  return std::abs(state.q[2] - 0.05 - bouncing(0.5, 0.8, 1.3));
}

}  // namespace

TEST_CASE("nscd: a ball falls and bounces as it should, to first order", "[granular]") {
  // Three impacts: each at most a step late, at a speed of at most 3.2 m/s before and 2.6 m/s behind.
  for (const double step : {1e-3, 1e-4, 1e-5}) CHECK(bounce_error(step) < 3 * 6 * step);
}

TEST_CASE("nscd: elastic impacts keep their height for ever", "[granular]") {
  BodiesData data = balls::scene(none, 0, 1);
  add_plane(data, {0, 0, 1}, 0);
  add_ball(data, 0.1, 0.05, {0, 0, 0.3});
  const BodyLayout layout(data);
  State state = layout.start();
  const double start = balls::energy(layout, state);
  const RunReport report = run_nscd(data, state, 20, options(1e-3), 1);
  CHECK(report.status == RunStatus::finished);
  CHECK(balls::energy(layout, state) == Approx(start).epsilon(1e-11));  // 20 000 steps' rounding
}

TEST_CASE("nscd: a sliding ball ends rolling at 5/7 of its speed", "[granular]") {
  for (const double step : {1e-3, 1e-4}) {
    BodiesData data = balls::scene(coulomb, 0.2, 0);
    add_plane(data, {0, 0, 1}, 0);
    add_ball(data, 0.2, 0.03, {0, 0, 0.03}).velocity = {1.4, 0, 0};
    const BodyLayout layout(data);
    State state = layout.start();
    const RunReport report = run_nscd(data, state, 1, options(step), 1);
    CHECK(report.status == RunStatus::finished);
    CHECK(state.u[0] == Approx(1.0).epsilon(1e-12));
    // Slides until v₀ − μgt = 5/7 v₀; velocity is exact but in the step where it begins to roll.
    const double slide = 2 * 1.4 / (7 * 0.2 * 9.81);
    const double x = 1.4 * slide - 0.2 * 9.81 * slide * slide / 2 + 1 - slide;
    CHECK(std::abs(state.q[0] - x) < 0.5 * 0.2 * 9.81 * step * step);
    CHECK(report.dissipated[0].sliding == Approx(0.5 * 0.2 * 1.4 * 1.4 * 2 / 7).epsilon(1e-10));
    CHECK(std::abs(report.dissipated[0].impact) < 1e-14);
  }
}

TEST_CASE("nscd: two balls collide", "[granular]") {
  BodiesData data = balls::scene(none, 0, 0.5);
  data.gravity.setZero();
  add_ball(data, 1, 0.1, {0, 0, 0}).velocity = {2, 0, 0};
  add_ball(data, 3, 0.1, {1, 0, 0});
  const BodyLayout layout(data);
  State state = layout.start();
  const RunReport report = run_nscd(data, state, 1, options(1e-3), 1);
  CHECK(state.u[0] == Approx(2 - 1.5 * 2 * 0.75).margin(1e-12));
  CHECK(state.u[6] == Approx(1.5 * 2 * 0.25).margin(1e-12));
  CHECK(report.dissipated[0].impact == Approx(0.5 * 0.75 * 4 * (1 - 0.25)).epsilon(1e-12));
}

TEST_CASE("nscd: the account of energy closes", "[granular]") {
  BodiesData data = balls::scene(hertz, 0.3, 0.4);
  add_plane(data, {0, 0, 1}, 0);
  add_plane(data, {1, 0, 0}, 0);
  add_plane(data, {-1, 0, 0}, -0.1);
  add_plane(data, {0, 1, 0}, 0);
  add_plane(data, {0, -1, 0}, -0.1);
  for (int i = 0; i < 12; ++i) {
    const double x = 0.025 + 0.05 * (i % 2), y = 0.025 + 0.05 * (i / 2 % 2);
    BodyData& ball = add_ball(data, 0.01, 0.02, {x, y + 1e-3 * (i % 3), 0.03 + 0.045 * (i / 4)});
    ball.spin = {3.0 * i, -20, 40};
    if (i == 3) ball.drag = {0.02, 1e-6};
    if (i == 4) ball.inertia = {2e-6, 1.8e-6, 1.2e-6};
    if (i == 5) ball.rotation = Rotation::driven;
  }
  data.loads.push_back({"push", 2, {0.01, 0, 0}, {0, 1e-5, 0}, {{}, {}, 3, 0}});
  const BodyLayout layout(data);
  State state = layout.start();
  const double start = balls::energy(layout, state);
  NscdCounts counts;
  const RunReport report = run_nscd(data, state, 1, options(1e-3, 1e-6), 1, {}, &counts);
  CHECK(report.status == RunStatus::finished);
  REQUIRE(report.work.size() == 2);
  const double gained = report.work[0] + report.work[1] + report.dissipated[0].driven;
  const double expected = start + gained - report.dissipated[0].total();
  CHECK(balls::energy(layout, state) == Approx(expected).margin(1e-12 * start));
  CHECK(report.work[0] < 0);
  CHECK(counts.deepest < 0.02 * 1e-2);
}

namespace {

/// A ball of 0.2 kg, r = 3 cm, that slides and spins on a plane by Coulomb–Contensou friction.
State spun(double step, std::optional<double> fidelity, double spin, RunReport& report) {
  BodiesData data = balls::scene(hertz, 0.3, 0, 5e-3);
  add_plane(data, {0, 0, 1}, 0);
  BodyData& ball = add_ball(data, 0.2, 0.03, {0, 0, 0.03});
  ball.velocity = {1, 0.2, 0};
  ball.spin = {0, 0, spin};
  const BodyLayout layout(data);
  State state = layout.start();
  IntegratorOptions o = options(step, 1e-12);
  o.fidelity = fidelity;
  report = run_nscd(data, state, 0.05, o, 1);
  REQUIRE(report.status == RunStatus::finished);
  return state;
}

}  // namespace

TEST_CASE("nscd: converges with order one to what moreau has for one ball", "[granular]") {
  const BallOnPlaneData ball{.m = 0.2, .r = 0.03};
  const BallOnPlane system(ball, {"touch", hertz, 0.3, 5e-3, 0});
  State exact{0, Eigen::Vector3d(0, 0, 0.03), Eigen::VectorXd::Zero(6)};
  exact.u << 1, 0.2, 0, 0, 0, 300;
  IntegratorOptions fine;
  fine.method = Method::moreau;
  fine.step = 2e-5;  // second order: its error is some 1e-4 of what is compared
  REQUIRE(integrate(system, exact, 0.05, fine).status == RunStatus::finished);
  std::vector<double> errors;
  for (const double step : {2e-3, 1e-3, 5e-4}) {
    RunReport report;
    const State state = spun(step, {}, 300, report);
    errors.push_back((state.u.head<3>() - exact.u.head<3>()).norm());
  }
  for (std::size_t k = 1; k < errors.size(); ++k) {
    const double order = std::log2(errors[k - 1] / errors[k]);
    CHECK(order > 0.8);
    CHECK(order < 1.2);
  }
}

TEST_CASE("nscd: what fidelity leaves out is counted and bounded", "[granular]") {
  RunReport full, less;
  const State exact = spun(1e-3, {}, 2, full);
  const State state = spun(1e-3, 0.02, 2, less);
  CHECK(full.left_out.as_coulomb == 0);
  CHECK(less.left_out.as_coulomb > 0);
  CHECK(less.left_out.friction > 0);
  CHECK(less.left_out.friction <= 0.02);
  CHECK((state.u.head<3>() - exact.u.head<3>()).norm() <= less.left_out.impulse / 0.2);
  RunReport none_left;
  const State spinning = spun(1e-3, 0.02, 3000, none_left);  // u = 0.07 and less
  CHECK(none_left.left_out.as_coulomb == 0);
  CHECK(spinning.u.allFinite());
}

TEST_CASE("nscd: what rests does not drift", "[granular]") {
  BodiesData data = balls::scene(coulomb, 0.5, 0);
  add_plane(data, {0, 0, 1}, 0);
  const double r = 0.01, d = 2 * r;
  add_ball(data, 0.01, r, {0, 0, r});
  add_ball(data, 0.01, r, {d, 0, r});
  add_ball(data, 0.01, r, {d / 2, d * std::sqrt(3.0) / 2, r});
  add_ball(data, 0.01, r, {d / 2, d / std::sqrt(12.0), r + d * std::sqrt(2.0 / 3) + 1e-9});
  const BodyLayout layout(data);
  State state = layout.start();
  const Eigen::VectorXd start = state.q;
  NscdCounts counts;
  const RunReport report = run_nscd(data, state, 20, options(2e-3, 1e-8), 1, {}, &counts);
  CHECK(report.status == RunStatus::finished);
  // The size of gaps that count as none, from the landing of the top ball, and nothing more in 10 000 steps.
  for (int i = 0; i < 4; ++i)
    CHECK((state.q - start).segment<3>(layout.first_coordinate(i)).norm() < 10 * 1e-4 * r);
  CHECK(counts.deepest < 2 * 1e-4 * r);
}

TEST_CASE("nscd: starts that make no sense are refused", "[granular]") {
  BodiesData data = balls::scene(coulomb, 0.3, 0);
  add_ball(data, 1, 0.01, {0, 0, 0});
  add_ball(data, 1, 0.01, {0, 0, 0});
  const BodyLayout layout(data);
  State state = layout.start();
  CHECK_THROWS_AS(run_nscd(data, state, 1, options(1e-3), 1), std::invalid_argument);
  CHECK_THROWS_AS(run_nscd(data, state, 1, options(1e-3), 0), std::invalid_argument);
  CHECK_THROWS_AS(run_nscd(data, state, 1, options(0), 1), std::invalid_argument);
}
