#include "contensou/contact/gauss_seidel.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "contensou/contact/contact_solver.hpp"

using namespace contensou;

namespace {

const AnyFriction frictionless{NoFriction{}};
const AnyFriction point{FrictionDisk{}};
const AnyFriction hertz{FrictionBall(SmoothPlate(HertzLaw{}))};

ContactSolver gauss_seidel(int sweeps = 0) {
  return ContactSolver({.method = SolverMethod::gauss_seidel, .tolerance = 1e-12, .max_iterations = sweeps});
}

}  // namespace

TEST_CASE("Gauss-Seidel: contacts on bodies of their own take one sweep", "[contact]") {
  Eigen::VectorXd b(8);
  b << -2, -1, 3, 4, -1, 0, 0, -5;
  const ContactProblem problem{
      {{&frictionless, {0}}, {&point, {0.5}}, {&hertz, {0.2}}}, Eigen::MatrixXd::Identity(8, 8), b};
  Eigen::VectorXd impulse;
  const SolverReport report = gauss_seidel().solve(problem, impulse);
  CHECK(report.status == SolverStatus::solved);
  CHECK(report.iterations == 1);
  Eigen::VectorXd expected(8);
  expected << 2, 1, -0.3, -0.4, 1, 0, 0, 0.2 * 3 * M_PI / 16;
  CHECK((impulse - expected).norm() < 1e-15);
}

TEST_CASE("Gauss-Seidel: a bar on two supports, impulses by its statics", "[contact]") {
  // Mass 1, inertia 1, supports at x = −1 and x = 2 of the centre of mass, falling with 3 m/s and not
  // turning: both stop, Λ_1 + Λ_2 = 3, −Λ_1 + 2Λ_2 = 0.
  const Eigen::MatrixXd w = (Eigen::MatrixXd(2, 2) << 2, -1, -1, 5).finished();
  const ContactProblem problem{{{&frictionless, {0, 0}}}, w, Eigen::Vector2d(-3, -3)};
  Eigen::VectorXd impulse;
  CHECK(gauss_seidel().solve(problem, impulse).status == SolverStatus::solved);
  CHECK((impulse - Eigen::Vector2d(2, 1)).norm() < 1e-11);
}

TEST_CASE("Gauss-Seidel: the same contact twice", "[contact]") {
  // Redundant: only the sum of the impulses is determined.
  Eigen::MatrixXd w(6, 6);
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) w.block<3, 3>(3 * i, 3 * j) = 0.5 * Eigen::Matrix3d::Identity();
  }
  const Eigen::Vector3d b(-1, 3, 4);
  Eigen::VectorXd both(6);
  both << b, b;
  const ContactProblem problem{{{&point, {0.5, 0.5}}}, w, both};
  Eigen::VectorXd impulse;
  CHECK(gauss_seidel().solve(problem, impulse).status == SolverStatus::solved);
  CHECK((impulse.head<3>() + impulse.tail<3>() - 2 * Eigen::Vector3d(1, -0.3, -0.4)).norm() < 1e-11);
}

TEST_CASE("Gauss-Seidel: warm start, limits, and what has no solution", "[contact]") {
  Eigen::MatrixXd w = (Eigen::MatrixXd(2, 2) << 2, -1.9, -1.9, 2).finished();
  ContactProblem problem{{{&frictionless, {0, 0}}}, w, Eigen::Vector2d(-1, -2)};
  Eigen::VectorXd impulse;
  ContactSolver one_sweep = gauss_seidel(1);
  const SolverReport limited = one_sweep.solve(problem, impulse);
  CHECK(limited.status == SolverStatus::iteration_limit);
  CHECK(limited.iterations == 1);
  CHECK(limited.residual == natural_map_residual(problem, impulse));
  CHECK(gauss_seidel().solve(problem, impulse).status == SolverStatus::solved);
  const SolverReport warm = gauss_seidel().solve(problem, impulse);
  CHECK(warm.status == SolverStatus::solved);
  CHECK(warm.iterations == 0);

  problem.delassus.setZero();
  CHECK(gauss_seidel().solve(problem, impulse).status == SolverStatus::stalled);
}

TEST_CASE("Contact solver: options and problems at the door", "[contact]") {
  CHECK_THROWS_AS(ContactSolver({.tolerance = 0}), std::invalid_argument);
  CHECK_THROWS_AS(ContactSolver({.tolerance = std::nan("")}), std::invalid_argument);
  CHECK_THROWS_AS(ContactSolver({.max_iterations = -1}), std::invalid_argument);
  CHECK_THROWS_AS(ContactSolver({.method = SolverMethod::modified_newton, .r = -1.0}), std::invalid_argument);
  CHECK_THROWS_AS(ContactSolver({.method = SolverMethod::gauss_seidel, .r = 1.0}), std::invalid_argument);

  ContactProblem problem{{{&frictionless, {0}}}, Eigen::MatrixXd::Ones(1, 1), Eigen::VectorXd::Zero(1)};
  Eigen::VectorXd impulse = Eigen::VectorXd::Constant(5, 7);  // wrong size: counts as none
  const SolverReport report = gauss_seidel().solve(problem, impulse);
  CHECK(report.status == SolverStatus::solved);
  CHECK(impulse == Eigen::VectorXd::Zero(1));
  problem.free_velocity[0] = std::nan("");
  CHECK_THROWS_AS(gauss_seidel().solve(problem, impulse), std::invalid_argument);
}

TEST_CASE("Gauss-Seidel: a sweep that overflows diverges, and says so", "[contact]") {
  // Each contact presses the other 1e30 times as hard: beyond the doubles between two looks at the residual.
  const AnyFriction hertz{FrictionBall(SmoothPlate(HertzLaw{}))};
  for (const AnyFriction* kind : {&frictionless, &point, &hertz}) {
    const Eigen::Index n = rows(*kind);
    ContactProblem problem{{{kind, {0.3, 0.3}}}, Eigen::MatrixXd::Identity(2 * n, 2 * n), {}};
    problem.delassus(0, n) = problem.delassus(n, 0) = -1e30;
    problem.free_velocity = Eigen::VectorXd::Constant(2 * n, -1);
    Eigen::VectorXd impulse;
    CAPTURE(n);
    CHECK(gauss_seidel().solve(problem, impulse).status == SolverStatus::diverged);
    CHECK(impulse.allFinite());
  }
}
