#include "contensou/contact/semismooth_newton.hpp"

#include <catch2/catch.hpp>

#include "contensou/contact/contact_solver.hpp"

using namespace contensou;

namespace {

const AnyFriction disk = FrictionDisk{};
const AnyFriction ball = FrictionBall(SmoothPlate(UniformLaw{}));

/// Two contacts, coupled: one with torque, one without.
ContactProblem two_contacts() {
  ContactProblem problem{{{&ball, {0.4}}, {&disk, {0.3}}}, Eigen::MatrixXd::Zero(7, 7), Eigen::VectorXd(7)};
  const Eigen::MatrixXd half = Eigen::MatrixXd::NullaryExpr(7, 7, [](Eigen::Index i, Eigen::Index j) {
    return i == j ? 1.0 : 0.2 / static_cast<double>(1 + i + 2 * j);
  });
  problem.delassus = half.transpose() * half;
  problem.free_velocity << -1, 0.5, 0.2, 0.7, -0.8, 0.1, -2;
  return problem;
}

}  // namespace

TEST_CASE("natural map: its Jacobian is its derivative", "[semismooth_newton]") {
  const ContactProblem problem = two_contacts();
  ScaledProblem scaled;
  scaled.set(problem);
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(7, 0.4, 0.9);
  Eigen::VectorXd g;
  Eigen::VectorXd h(7);
  Eigen::MatrixXd jacobian(7, 8);
  scaled.velocity(x, g);
  scaled.natural_map(x, g, h, jacobian);
  // Central differences with d = 1e-6: error d² times third derivatives of order 1, and 1e-16/d of rounding.
  constexpr double d = 1e-6;
  for (Eigen::Index j = 0; j < 8; ++j) {
    Eigen::VectorXd side[2] = {h, h};
    for (const int k : {0, 1}) {
      Eigen::VectorXd moved = x;
      const double by = k == 0 ? d : -d;
      if (j < 7) moved[j] += by;
      scaled.velocity(moved, g);
      if (j == 7) g += by * scaled.cover;
      scaled.natural_map(moved, g, side[k]);
    }
    const Eigen::VectorXd difference = (side[0] - side[1]) / (2 * d);
    CAPTURE(j);
    CHECK((difference - jacobian.col(j)).norm() < 1e-8);
  }
}

TEST_CASE("semismooth Newton: quadratic convergence", "[semismooth_newton]") {
  const ContactProblem problem = two_contacts();
  ContactSolver solver({.method = SolverMethod::semismooth_newton, .tolerance = 1e-13});
  Eigen::VectorXd impulse;
  const SolverReport report = solver.solve(problem, impulse);
  CHECK(report.status == SolverStatus::solved);
  CHECK(report.iterations <= 10);
  CHECK(natural_map_residual(problem, impulse) <= 1e-13);
}

TEST_CASE("semismooth Newton: the residual of the scaled problem is that of the problem",
          "[semismooth_newton]") {
  const ContactProblem problem = two_contacts();
  ScaledProblem scaled;
  scaled.set(problem);
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(7, -0.4, 0.9);
  Eigen::VectorXd g;
  scaled.velocity(x, g);
  CHECK(scaled.residual(x, g) ==
        Approx(natural_map_residual(problem, x.cwiseProduct(scaled.unit))).epsilon(1e-12));
}

TEST_CASE("semismooth Newton: the limit holds", "[semismooth_newton]") {
  ContactSolver solver({.method = SolverMethod::semismooth_newton, .max_iterations = 1});
  Eigen::VectorXd impulse;
  const SolverReport report = solver.solve(two_contacts(), impulse);
  CHECK(report.iterations == 1);
  CHECK(report.status == SolverStatus::iteration_limit);
}

TEST_CASE("semismooth Newton: without a solution it has not diverged but stands still",
          "[semismooth_newton]") {
  const AnyFriction none = NoFriction{};
  const ContactProblem walls{{{&none, {0, 0}}}, Eigen::Matrix2d{{1, -1}, {-1, 1}}, Eigen::Vector2d(-1, -1)};
  ContactSolver solver({.method = SolverMethod::semismooth_newton});
  Eigen::VectorXd impulse;
  const SolverReport report = solver.solve(walls, impulse);
  CHECK(report.status != SolverStatus::solved);
  CHECK(report.status != SolverStatus::diverged);
  CHECK(report.residual >= 0.1);
}
