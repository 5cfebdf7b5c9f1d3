// A pressure from a table in a contact: ball, solvers and runs, against the laws the tables are made from.

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "contensou/contact/contact_solver.hpp"
#include "contensou/contact/one_contact.hpp"
#include "contensou/law/power.hpp"
#include "contensou/law/radial.hpp"
#include "stepping_problems.hpp"

using namespace contensou;
using namespace stepping_problems;
using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Ball = FrictionBall<SmoothPlate<CompiledLaw>>;

namespace {

constexpr double tolerance = 1e-9;

Ball from_table(const std::vector<double>& rho, const std::vector<double>& sigma) {
  return Ball(SmoothPlate(RadialLaw(tabulated_pressure(rho, sigma)).compile(tolerance)));
}

const Ball& uniform_table() {
  static const Ball ball = from_table({0, 1}, {3, 3});
  return ball;
}

/// 1 − ρ² with `cells` pieces of equal length.
Ball paraboloid_table(int cells) {
  std::vector<double> rho, sigma;
  for (int i = 0; i <= cells; ++i) {
    rho.push_back(static_cast<double>(i) / cells);
    sigma.push_back((1 - rho.back()) * (1 + rho.back()));
  }
  return from_table(rho, sigma);
}

double number(std::mt19937_64& g) { return static_cast<double>(g() >> 11) * 0x1p-52 - 1; }
Vector3d vector(std::mt19937_64& g) {
  return Vector3d::NullaryExpr([&] { return number(g); });
}

/// Largest difference of border points, over slip ratios from 1e-4 to 1e4.
template <class Other>
double border_difference(const Ball& ball, const Other& other) {
  double largest = 0;
  for (int k = -80; k <= 80; ++k) {
    const Vector3d normal(std::pow(10, k / 20.0), 0, 1);
    largest = std::max(largest, (ball.boundary_point(1, normal) - other.boundary_point(1, normal)).norm());
  }
  return largest;
}

/// Largest difference of projections, and of impulses relative to V/‖W‖, W well conditioned.
template <class Other>
std::pair<double, double> solver_difference(const Ball& ball, const Other& other) {
  std::mt19937_64 g(31);
  double projection = 0;
  double impulse = 0;
  const AnyFriction friction{ball};
  for (int k = 0; k < 300; ++k) {
    const Vector3d force = 2 * vector(g);
    projection = std::max(projection, (ball.project(force, 1).point - other.project(force, 1).point).norm());
    const Matrix4d j = Matrix4d::NullaryExpr([&] { return number(g); });
    const Matrix4d w = j * j.transpose() + Matrix4d::Identity();
    const Vector4d b(-std::abs(number(g)), number(g), number(g), number(g));
    const auto a = solve_one_contact(ball, 0.1, w, b, Vector4d(Vector4d::Zero()));
    const auto c = solve_one_contact(other, 0.1, w, b, Vector4d(Vector4d::Zero()));
    CHECK(a.residual < 1e-12);
    impulse = std::max(impulse, (a.impulse - c.impulse).norm());
    const ContactProblem problem{{{&friction, {0.1}}}, w, b};
    for (const SolverMethod method : {SolverMethod::automatic, SolverMethod::semismooth_newton,
                                      SolverMethod::gauss_seidel, SolverMethod::modified_newton}) {
      ContactSolver solver({.method = method, .tolerance = 1e-10});
      Eigen::VectorXd found;
      CHECK(solver.solve(problem, found).status == SolverStatus::solved);
      CHECK((found - a.impulse).norm() < 1e-9);
    }
  }
  return {projection, impulse};
}

/// Slides and spins to rest and stays there: the end of the run and when it stuck.
std::pair<State, double> stops(const AnyFriction& friction) {
  const Slab slab({"floor", friction, 0.3, 0.5, 0});
  State state = Slab::at(0, {0.6, -0.2, 0, 3});
  const RunReport report = integrate(slab, state, 1, {.method = Method::event_driven, .tolerance = 1e-10});
  CHECK(report.status == RunStatus::finished);
  REQUIRE(report.events.size() == 1);
  CHECK(report.events[0].kind == EventKind::stick);
  return {state, report.events[0].t};
}

}  // namespace

TEST_CASE("Tabulated pressure: the table of a uniform pressure", "[integrate][tabulated_pressure]") {
  const FrictionBall exact{SmoothPlate(UniformLaw{})};
  CHECK(border_difference(uniform_table(), exact) <= tolerance);
  const auto [projection, impulse] = solver_difference(uniform_table(), exact);
  CHECK(projection <= 2 * tolerance);
  CHECK(impulse <= 2 * tolerance);
  const auto [end, when] = stops(uniform_table());
  const auto [exact_end, exact_when] = stops(exact);
  // Those of the law, of the integration and of where it is at rest.
  CHECK((end.q - exact_end.q).norm() <= 1e-8);
  CHECK(std::abs(when - exact_when) <= 1e-8);
}

TEST_CASE("Tabulated pressure: the table of a paraboloid, finer and finer",
          "[integrate][tabulated_pressure]") {
  const FrictionBall exact{SmoothPlate(static_cast<CompiledLaw>(PowerLaw(1)))};
  // Chords lie below the parabola by x (h − x), the h²/3 part of the load: so much of the force is elsewhere,
  // by at most the semi-axes.
  const auto bound = [](int cells) { return 2.0 / 3 / (cells * cells); };
  const Ball coarse = paraboloid_table(8), fine = paraboloid_table(16);
  const double at_8 = border_difference(coarse, exact), at_16 = border_difference(fine, exact);
  CHECK(at_16 <= bound(16));
  CHECK(at_8 / at_16 == Approx(4).margin(0.3));
  const auto [projection, impulse] = solver_difference(fine, exact);
  CHECK(projection <= bound(16));
  CHECK(impulse <= bound(16));
  const auto [coarse_end, coarse_when] = stops(coarse);
  const auto [fine_end, fine_when] = stops(fine);
  const auto [exact_end, exact_when] = stops(exact);
  CHECK(std::abs(fine_when - exact_when) <= 2 * bound(16) * exact_when);
  CHECK((coarse_when - exact_when) / (fine_when - exact_when) == Approx(4).margin(0.4));
  CHECK((fine_end.q - exact_end.q).norm() <= 2 * bound(16));
}

TEST_CASE("Tabulated pressure: an annulus with a step, in a run", "[integrate][tabulated_pressure]") {
  // Nothing presses inside half the radius, but for a ramp of 1e-3: η_max = ∫ρ²/∫ρ = (2/3)(7/8)/(3/4) = 7/9.
  const Ball annulus = from_table({0, 0.4995, 0.5005, 1}, {0, 0, 1, 1});
  CHECK(annulus.boundary_point(1, Vector3d(0, 0, 1))[2] == Approx(7.0 / 9).epsilon(1e-6));
  const auto [end, when] = stops(annulus);
  // v/(μg) falls at the rate ξ <= 1, jω/(μmg η_max R) at η/η_max <= 1, both together at least at 1 (a convex
  // plate): the time is between the longer one and the sum.
  const double slides = std::hypot(0.6, 0.2) / (0.3 * Slab::g);
  const double spins = Slab::j * 3 / (0.3 * Slab::m * Slab::g * 7.0 / 9 * 0.5);
  CHECK(when >= std::max(slides, spins));
  CHECK(when <= slides + spins);
  CHECK(end.u.isZero(0));
}
