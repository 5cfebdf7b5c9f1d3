// Contact radii that follow the load: against runs with the radius put in by hand, Hertz's impact integrated
// in time, and motions whose forces are put in by hand.

#include <catch2/catch.hpp>
#include <cmath>

#include "contensou/integrate/mechanical_system.hpp"
#include "stepping_problems.hpp"

using namespace contensou;
using namespace stepping_problems;

namespace {

constexpr LoadRadius soft{.relative_radius = 0.3, .modulus = 2e3};  // R(20 N) = 0.131 m
constexpr Method methods[] = {Method::moreau, Method::moreau_implicit, Method::moreau_adaptive};

SystemContact floor_of(double radius, double mu = 0.3, double restitution = 0) {
  return {"floor", system_test::hertz, mu, radius, restitution};
}

/// The rows written in `radius`, the contact's own radius that of the load.
SystemContact loaded_floor(double radius, double mu = 0.3, double restitution = 0) {
  SystemContact floor = floor_of(radius, mu, restitution);
  floor.load_radius = soft;
  return floor;
}

double third_root_radius(double load) {
  return std::pow(3 * soft.relative_radius * load / (4 * soft.modulus), 1.0 / 3);
}

/// y(t) of y' = f(t, y) by the classic method with equal steps.
template <class Vector, class Function>
Vector by_rk4(const Function& f, double t, double t_end, Vector y, int steps) {
  const double h = (t_end - t) / steps;
  for (int k = 0; k < steps; ++k, t += h) {
    const Vector a = f(t, y);
    const Vector b = f(t + h / 2, Vector(y + h / 2 * a));
    const Vector c = f(t + h / 2, Vector(y + h / 2 * b));
    const Vector d = f(t + h, Vector(y + h * c));
    y += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return y;
}

}  // namespace

TEST_CASE("Load radius: by Hertz, and none without load", "[integrate][load_radius]") {
  CHECK(soft.at(20) == Approx(third_root_radius(20)).epsilon(1e-15));
  CHECK(soft.at(0) == 0);
  CHECK(soft.at(-1) == 0);
  CHECK(soft.impact_load(2, 0) == 0);
  CHECK(soft.impact_load(2, -1) == 0);
}

TEST_CASE("Load radius: the largest load of Hertz's impact", "[integrate][load_radius]") {
  // δ'' = −K δ^{3/2}/m until δ' = 0, (δ, δ') by RK4.
  const double mass = 2, speed = 3;
  const double stiffness = 4.0 / 3 * soft.modulus * std::sqrt(soft.relative_radius);
  const auto rate = [&](double, const Eigen::Vector2d& y) {
    return Eigen::Vector2d(y[1], -stiffness * std::pow(std::max(y[0], 0.0), 1.5) / mass);
  };
  Eigen::Vector2d y(0, speed);
  double deepest = 0;
  const double h = 1e-5;
  for (double t = 0; y[1] > 0; t += h) {
    deepest = y[0] + y[1] * y[1] * mass /
                         (2 * stiffness * std::pow(std::max(y[0], 1e-9), 1.5));  // ahead of the turn
    y = by_rk4(rate, 0, h, y, 1);
  }
  // At the turn the parabola ahead is off by the fourth order of a step of h: far below 1e-8.
  CHECK(soft.impact_load(mass, speed) == Approx(stiffness * std::pow(deepest, 1.5)).epsilon(1e-8));
  CHECK(soft.at(soft.impact_load(mass, speed)) ==
        Approx(std::sqrt(soft.relative_radius * deepest)).epsilon(1e-8));
}

TEST_CASE("Load radius: a constant load is a constant radius", "[integrate][load_radius]") {
  for (const double extra : {0.0, 100.0}) {  // a heavier disc
    const Slab::Push push = [&](double) { return Eigen::Vector4d(0, 0, -extra, 0); };
    const double radius = third_root_radius(Slab::m * Slab::g + extra);
    const Slab by_hand(floor_of(radius), push);
    for (const double rows_in : {radius, 0.7}) {
      const Slab loaded(loaded_floor(rows_in), push);
      for (const Method method : methods) {
        for (const double t_end : {0.05, 0.5}) {  // slipping; at rest
          const State start = Slab::at(0, {0.6, -0.3, 0, 4});
          RunReport one, other;
          const State a = end_of(by_hand, start, t_end, method, 1e-3, &one, {.tolerance = 1e-6});
          const State b = end_of(loaded, start, t_end, method, 1e-3, &other, {.tolerance = 1e-6});
          CAPTURE(extra, rows_in, name(method), t_end);
          REQUIRE(other.status == RunStatus::finished);
          CHECK(one.steps == other.steps);
          // Rounding of R, 1e-16, in 500 steps, and of step sizes.
          CHECK((a.u - b.u).norm() <= 1e-12);
          CHECK((a.q - b.q).norm() <= 1e-12);
          CHECK(one.dissipated[0].drilling == Approx(other.dissipated[0].drilling).epsilon(1e-11));
          CHECK(one.dissipated[0].sliding == Approx(other.dissipated[0].sliding).epsilon(1e-11));
        }
      }
    }
  }
}

TEST_CASE("Load radius: order in slip under a load that varies", "[integrate][load_radius]") {
  const auto lift = [](double t) { return 15 * std::sin(40 * t); };
  const Slab slab(loaded_floor(0.4), [&](double t) { return Eigen::Vector4d(0, 0, lift(t), 0); });
  const double t_end = 0.1;
  const State start = Slab::at(0, {1, 0.5, 0, 9});
  // (v_x, v_y, ω): λ_N = mg − F_z, friction by Hertz's law with γ_τ = R(λ_N) ω.
  const HertzLaw law;
  const auto rate = [&](double t, const Eigen::Vector3d& y) -> Eigen::Vector3d {
    const double load = Slab::m * Slab::g - lift(t);
    const double radius = third_root_radius(load);
    const double v = std::hypot(y[0], y[1]);
    const Friction f = law.at(v, radius * std::abs(y[2]));
    const double size = 0.3 * load;
    return {-size * f.xi * y[0] / v / Slab::m, -size * f.xi * y[1] / v / Slab::m,
            -std::copysign(size * f.eta * radius, y[2]) / Slab::j};
  };
  const Eigen::Vector3d exact = by_rk4(rate, 0, t_end, Eigen::Vector3d(1, 0.5, 9), 4000);
  CHECK((exact - by_rk4(rate, 0, t_end, Eigen::Vector3d(1, 0.5, 9), 2000)).norm() < 1e-11);
  const auto error = [&](Method method, double step, double tolerance = 1e-6) {
    RunReport report;
    const State end = end_of(slab, start, t_end, method, step, &report, {.tolerance = tolerance});
    REQUIRE(report.status == RunStatus::finished);
    return (Eigen::Vector3d(end.u[0], end.u[1], end.u[3]) - exact).norm();
  };
  const auto order = [&](Method method, double step) {
    return std::log2(error(method, step) / error(method, step / 2));
  };
  CHECK(order(Method::moreau, 1e-3) == Approx(2).margin(0.1));
  CHECK(order(Method::moreau_implicit, 1e-3) == Approx(1).margin(0.1));
  // The error goes like tolerance^⅔ once steps are shorter than the first one.
  const double ratio =
      std::log10(error(Method::moreau_adaptive, 1e-3, 1e-6) / error(Method::moreau_adaptive, 1e-3, 1e-9)) / 3;
  CHECK(ratio > 0.5);
  CHECK(ratio < 5.0 / 6);
}

TEST_CASE("Load radius: energy is balanced", "[integrate][load_radius]") {
  const auto lift = [](double t) { return Eigen::Vector4d(0, 0, 15 * std::sin(40 * t), 0); };
  const Slab slab(loaded_floor(0.4), lift);
  const State start = Slab::at(0, {1, 0.5, 0, 9});
  RunReport report;
  const State end = end_of(slab, start, 0.1, Method::moreau_implicit, 1e-3, &report);
  const double lost = slab.kinetic_energy(start.q, start.u) - slab.kinetic_energy(end.q, end.u);
  CHECK(report.dissipated[0].drilling > 0.01 * lost);
  // By rounding of 100 steps, and the tolerance of their inclusions.
  CHECK(report.dissipated[0].total() == Approx(lost).epsilon(1e-11));
}

TEST_CASE("Load radius: order where friction bears on the load", "[integrate][load_radius]") {
  auto contacts = tippe_top_contacts(system_test::hertz);
  const LoadRadius load{.relative_radius = 0.015, .modulus = 1e5};
  contacts[0].load_radius = load;
  const TippeTopAxis top(TippeTopData{}, contacts);
  const State start = top.start(0.1, 180);
  const double t_end = 0.01;
  ContactRows rows(6);
  const Eigen::Index n = top.coordinates();
  const auto rate = [&](double t, const Eigen::VectorXd& y) -> Eigen::VectorXd {
    const Eigen::VectorXd q = y.head(n), u = y.tail(6);
    Eigen::VectorXd dq(n), a(6);
    top.coordinate_rates(q, u, dq);
    top.free_acceleration(t, q, u, a);
    top.contact_rows(0, t, q, u, rows);
    double lambda = 0.01;
    Eigen::VectorXd per_newton(6);
    for (int k = 0; k < 40; ++k) {
      const double factor = load.at(lambda) / contacts[0].radius;
      Eigen::Vector3d gamma = rows.velocity.tail<3>();
      gamma[2] *= factor;
      Eigen::Vector3d friction = -contacts[0].mu * hertz_border(gamma);
      friction[2] *= factor;
      per_newton = rows.response.col(0) + rows.response.rightCols(3) * friction;
      lambda = -(rows.directions.col(0).dot(a) + rows.drift[0]) / rows.directions.col(0).dot(per_newton);
    }
    Eigen::VectorXd dy(n + 6);
    dy << dq, a + lambda * per_newton;
    return dy;
  };
  Eigen::VectorXd y(n + 6);
  y << start.q, start.u;
  y = by_rk4(rate, 0, t_end, y, 1000);
  const State reference{t_end, y.head(n), y.tail(6)};
  const auto error = [&](Method method, double step) {
    RunReport report;
    const State end = end_of(top, start, t_end, method, step, &report);
    REQUIRE(report.status == RunStatus::finished);
    return difference(top, end, reference);
  };
  CHECK(std::log2(error(Method::moreau, 1e-4) / error(Method::moreau, 5e-5)) == Approx(2).margin(0.1));
  CHECK(std::log2(error(Method::moreau_implicit, 1e-4) / error(Method::moreau_implicit, 5e-5)) ==
        Approx(1).margin(0.1));
}

TEST_CASE("Load radius: impacts have that of Hertz's largest load", "[integrate][load_radius]") {
  constexpr double mu = 0.1, height = 0.05;
  const double v = std::sqrt(2 * Slab::g * height), landing = v / Slab::g;
  const double eta = HertzLaw{}.extent().eta;
  const auto spin_lost = [&](double impulse, double radius) { return mu * eta * impulse * radius / Slab::j; };
  const double stiffness = 4.0 / 3 * soft.modulus * std::sqrt(soft.relative_radius);
  const double depth = std::pow(5 * Slab::m * v * v / (4 * stiffness), 0.4);
  const double radius = std::sqrt(soft.relative_radius * depth);
  for (const Method method : methods) {
    CAPTURE(name(method));
    // Backward Euler falls by gΔt/2 too fast, and so v is off by 1e-4.
    const double margin = method == Method::moreau_implicit ? 1e-3 : 1e-5;
    const Slab bouncing(loaded_floor(0.4, mu, 0.5));
    const State up = end_of(bouncing, Slab::at(height, {0, 0, 0, 50}), landing + 0.01, method, 1e-4, nullptr,
                            {.tolerance = 1e-7});
    CHECK(50 - up.u[3] == Approx(spin_lost(1.5 * Slab::m * v, radius)).epsilon(margin));
    // Inelastic: then it lies under its weight.
    const Slab landed(loaded_floor(0.4, mu));
    const State down = end_of(landed, Slab::at(height, {0, 0, 0, 50}), landing + 0.1, method, 1e-4, nullptr,
                              {.tolerance = 1e-7});
    const double rest = spin_lost(0.1 * Slab::m * Slab::g, third_root_radius(Slab::m * Slab::g));
    CHECK(50 - down.u[3] == Approx(spin_lost(Slab::m * v, radius) + rest).epsilon(margin));
  }
}

TEST_CASE("Load radius: a contact that has none is as if others had none", "[integrate][load_radius]") {
  const State start = paper_top().start(0.1, 180);
  auto contacts = tippe_top_contacts(system_test::hertz);
  contacts[1].load_radius = soft;  // the tip, which stays in the air
  for (const Method method : methods) {
    const State a = end_of(paper_top(), start, 0.02, method, 1e-4);
    const State b = end_of(TippeTopAxis(TippeTopData{}, contacts), start, 0.02, method, 1e-4);
    CHECK(a.q == b.q);
    CHECK(a.u == b.u);
  }
}
