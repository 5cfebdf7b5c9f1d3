// The default solver on problems made to be hard: each has a solution.

#include "contensou/contact/automatic.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "contensou/contact/contact_solver.hpp"
#include "contensou/contact/single_contact.hpp"

using namespace contensou;

namespace {

const AnyFriction disk = FrictionDisk{};
const AnyFriction ball = FrictionBall(SmoothPlate(HertzLaw{}));

constexpr double tolerance = 1e-10;

/// W and b from the directions of the contacts (columns, all masses 1) and the bodies' velocity, with
/// `opening` added to all normal rows.
ContactProblem problem_from(const Eigen::MatrixXd& directions, const Eigen::VectorXd& u,
                            std::vector<ContactGroup> groups, double opening = 0) {
  ContactProblem problem{std::move(groups), directions.transpose() * directions, directions.transpose() * u};
  const int rows = contensou::rows(*problem.groups[0].friction);
  for (Eigen::Index i = 0; i < problem.free_velocity.size(); i += rows) problem.free_velocity[i] += opening;
  return problem;
}

/// Columns N, T1, T2, τ of a contact of a unit body (mass and inertia 1) at `arm`.
Eigen::MatrixXd contact_columns(const Eigen::Vector3d& arm, const Eigen::Vector3d& normal, double radius) {
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(6, 4);
  const Eigen::Vector3d t1 = normal.unitOrthogonal();
  const Eigen::Vector3d t2 = normal.cross(t1);
  columns.col(0) << normal, arm.cross(normal);
  columns.col(1) << t1, arm.cross(t1);
  columns.col(2) << t2, arm.cross(t2);
  columns.col(3).tail<3>() = radius * normal;
  return columns;
}

/// A plate on 8 contacts in a circle, 32 rows on 6 degrees of freedom.
ContactProblem plate(double mu, double radius, const Eigen::VectorXd& u) {
  Eigen::MatrixXd directions(6, 32);
  for (int i = 0; i < 8; ++i) {
    const double angle = 0.7853981633974483 * i;
    directions.middleCols<4>(4 * i) =
        contact_columns({std::cos(angle), std::sin(angle), -0.2}, Eigen::Vector3d::UnitZ(), radius);
  }
  return problem_from(directions, u, {{&ball, std::vector<double>(8, mu)}});
}

SolverReport solve(const ContactProblem& problem, Eigen::VectorXd impulse = {}) {
  ContactSolver solver({.tolerance = tolerance});
  const SolverReport report = solver.solve(problem, impulse);
  CHECK(impulse.size() == problem.rows());
  // |W| times the impulses goes up to 1e5 V with the largest radius, rounded once more or less.
  CHECK(report.residual == Approx(natural_map_residual(problem, impulse)).margin(1e-11));
  return report;
}

Eigen::VectorXd velocity(double vx, double vz, double spin) {
  Eigen::VectorXd u(6);
  u << vx, 0.3 * vx, vz, 0.1 * spin, -0.2 * spin, spin;
  return u;
}

}  // namespace

TEST_CASE("automatic: a plate on eight contacts", "[automatic]") {
  for (const double mu : {0.0, 0.3, 10.0}) {
    for (const double radius : {0.0, 1e-9, 0.1, 100.0}) {
      for (const double spin : {0.0, 1.0, 1e6}) {
        CAPTURE(mu, radius, spin);
        const SolverReport report = solve(plate(mu, radius, velocity(1, -1, spin)));
        CHECK(report.status == SolverStatus::solved);
      }
    }
  }
}

TEST_CASE("automatic: a wedge with opposite normals", "[automatic]") {
  const Eigen::Vector3d n = Eigen::Vector3d(1, 0, 0.2).normalized();
  const Eigen::Vector3d m = Eigen::Vector3d(-1, 0, 0.2).normalized();
  Eigen::MatrixXd directions(6, 8);
  directions << contact_columns(-n, n, 0.1), contact_columns(-m, m, 0.1);
  for (const double mu : {0.1, 1.0, 10.0}) {
    for (const double opening : {0.0, 1e-3}) {
      CAPTURE(mu, opening);
      const auto problem = problem_from(directions, velocity(0.1, -1, 1), {{&ball, {mu, mu}}}, opening);
      CHECK(solve(problem).status == SolverStatus::solved);
    }
  }
}

TEST_CASE("automatic: normal and tangential rows strongly coupled, mu = 10", "[automatic]") {
  // Long thin bodies struck at their ends: W_NF as large as W_NN.
  Eigen::MatrixXd directions(6, 6);
  directions << contact_columns({3, 0, -3}, Eigen::Vector3d::UnitZ(), 0).leftCols<3>(),
      contact_columns({-2, 1, -3}, Eigen::Vector3d::UnitZ(), 0).leftCols<3>();
  for (const double vx : {-5.0, -0.1, 0.1, 5.0}) {
    CAPTURE(vx);
    CHECK(solve(problem_from(directions, velocity(vx, -1, 0.5), {{&disk, {10, 10}}})).status ==
          SolverStatus::solved);
  }
}

TEST_CASE("automatic: units do not matter", "[automatic]") {
  const ContactProblem problem = plate(0.3, 0.1, velocity(1, -1, 2));
  for (const double scale_w : {1e-100, 1.0, 1e100}) {
    for (const double scale_b : {1e-100, 1e-12, 1.0, 1e100}) {
      CAPTURE(scale_w, scale_b);
      ContactProblem scaled = problem;
      scaled.delassus *= scale_w;
      scaled.free_velocity *= scale_b;
      CHECK(solve(scaled).status == SolverStatus::solved);
    }
  }
}

TEST_CASE("automatic: one entry of b tiny beside the others", "[automatic]") {
  ContactProblem problem = plate(0.3, 0.1, velocity(1, -1, 2));
  for (Eigen::Index i = 0; i < 32; i += 4) problem.free_velocity[i] = -1e-12;
  CHECK(solve(problem).status == SolverStatus::solved);
}

TEST_CASE("automatic: useless warm starts do no harm", "[automatic]") {
  const ContactProblem problem = plate(0.3, 0.1, velocity(1, -1, 2));
  for (const double value : {1e20, -1e20, 1e300, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
    CAPTURE(value);
    CHECK(solve(problem, Eigen::VectorXd::Constant(32, value)).status == SolverStatus::solved);
  }
}

TEST_CASE("automatic: a good warm start needs no iteration", "[automatic]") {
  const ContactProblem problem = plate(0.3, 0.1, velocity(1, -1, 2));
  ContactSolver solver({.tolerance = tolerance});
  Eigen::VectorXd impulse;
  REQUIRE(solver.solve(problem, impulse).status == SolverStatus::solved);
  CHECK(solver.solve(problem, impulse).iterations == 0);
}

TEST_CASE("automatic: without a solution it ends and says so", "[automatic]") {
  // Pressed into two opposite walls at once: no impulse can stop it.
  ContactProblem problem{{{&disk, {0.1, 0.1}}}, Eigen::MatrixXd::Zero(6, 6), Eigen::VectorXd::Zero(6)};
  for (const int sign : {1, -1}) {
    for (int i = 0; i < 6; i += 3) problem.delassus(i, sign == 1 ? i : 3 - i) = sign;  // N N, minus across
  }
  problem.free_velocity[0] = problem.free_velocity[3] = -1;
  const SolverReport report = solve(problem);
  CHECK(report.status != SolverStatus::solved);
  CHECK(report.residual > tolerance);
}

TEST_CASE("automatic: the caller's limit holds", "[automatic]") {
  const ContactProblem problem = plate(0.3, 0.1, velocity(1, -1, 2));
  ContactSolver solver({.tolerance = 1e-300, .max_iterations = 50});
  Eigen::VectorXd impulse;
  const SolverReport report = solver.solve(problem, impulse);
  CHECK(report.iterations <= 50);
  CHECK(report.status != SolverStatus::solved);
}

TEST_CASE("automatic: one contact without a solution keeps the better impulse, and counts all",
          "[automatic]") {
  // W_NN < 0: no solution, LG03 4 (Painlevé); Λ = 0 leaves γ_N = −1.
  ContactProblem problem{{{&disk, {0.5}}}, Eigen::Matrix3d::Identity(), Eigen::Vector3d(-1, 0.5, 0)};
  problem.delassus(0, 0) = -1;
  const Eigen::Vector3d start(0.25, -0.125, 0);
  Eigen::VectorXd impulse = start;
  const SolverReport direct = solve_single_contact(problem, impulse, {});
  CHECK(direct.status == SolverStatus::stalled);
  CHECK(direct.residual == natural_map_residual(problem, impulse));
  CHECK(direct.residual <= natural_map_residual(problem, start));

  ContactSolver solver({.max_iterations = 3});
  impulse = start;
  const SolverReport report = solver.solve(problem, impulse);
  CHECK(report.status != SolverStatus::solved);
  CHECK(report.iterations >= direct.iterations);
  CHECK(report.iterations <= direct.iterations + 3);
  CHECK(report.residual <= natural_map_residual(problem, start));
}
