#include "contensou/contact/impact_law.hpp"

#include <catch2/catch.hpp>

#include "contensou/contact/contact_solver.hpp"

using namespace contensou;

namespace {

const AnyFriction point{FrictionDisk{}};
const AnyFriction frictionless{NoFriction{}};

/// A point mass of 2 kg on a plane, coordinates (x, y, z), rows (z, x, y).
struct PointMass {
  ImpactStep step{0.5 * Eigen::MatrixXd::Identity(3, 3),
                  (Eigen::MatrixXd(3, 3) << 0, 1, 0, 0, 0, 1, 1, 0, 0).finished(),
                  Eigen::VectorXd::Zero(3),
                  Eigen::VectorXd::Zero(3),
                  Eigen::VectorXd::Zero(3),
                  Eigen::VectorXd::Zero(1)};
  ContactProblem problem{{{&point, {0.4}}}, {}, {}};
  Eigen::MatrixXd response;
  Eigen::VectorXd impulse;

  Eigen::VectorXd solve() {
    assemble_impact(step, response, problem);
    ContactSolver solver({.method = SolverMethod::gauss_seidel});
    REQUIRE(solver.solve(problem, impulse).status == SolverStatus::solved);
    return velocity_after(step, response, impulse);
  }
};

}  // namespace

TEST_CASE("Impact law: a block pushed with half the friction limit stays, with twice the limit slides",
          "[contact]") {
  // g = 10, Δt = 0.1: weight's impulse 2 N s, limit 0.8 N s.
  PointMass mass;
  mass.step.smooth_change << 0.2, 0, -1;  // pushed with 0.4 N s
  CHECK(mass.solve().norm() < 1e-15);
  CHECK((mass.impulse - Eigen::Vector3d(2, -0.4, 0)).norm() < 1e-15);
  mass.step.smooth_change << 0, 0.8, -1;  // with 1.6 N s
  CHECK((mass.solve() - Eigen::Vector3d(0, 0.4, 0)).norm() < 1e-15);
  CHECK((mass.impulse - Eigen::Vector3d(2, 0, -0.8)).norm() < 1e-15);
}

TEST_CASE("Impact law: Newton's restitution", "[contact]") {
  PointMass mass;
  mass.step.velocity << 3, 0, -2;
  mass.step.restitution[0] = 0.5;
  // Λ_N = m (1 + ε) 2 = 6, Λ_T = −2.4.
  CHECK((mass.solve() - Eigen::Vector3d(3 - 1.2, 0, 1)).norm() < 1e-15);
  // On a belt that runs with 3 m/s in x there is no friction.
  mass.step.drive << 0, -3, 0;
  CHECK((mass.solve() - Eigen::Vector3d(3, 0, 1)).norm() < 1e-15);
  // A floor that moves up with 1 m/s: γ_N⁻ = −3, γ_N⁺ = 1.5.
  mass.step.drive << -1, 0, 0;
  CHECK(std::abs(mass.solve()[2] - 2.5) < 1e-15);
}

TEST_CASE("Impact law: who is not hit does not take part", "[contact]") {
  // The contact opens already with 2 m/s: no impulse, whatever ε.
  PointMass mass;
  mass.step.velocity << 1, 0, 2;
  mass.step.restitution[0] = 1;
  CHECK(mass.solve() == Eigen::VectorXd(Eigen::Vector3d(1, 0, 2)));
}

TEST_CASE("Impact law: what does not fit is refused", "[contact]") {
  PointMass mass;
  mass.step.restitution[0] = 1.5;
  CHECK_THROWS_AS(assemble_impact(mass.step, mass.response, mass.problem), std::invalid_argument);
  mass.step.restitution.setZero(2);
  CHECK_THROWS_AS(assemble_impact(mass.step, mass.response, mass.problem), std::invalid_argument);
  mass.step.restitution.setZero(1);
  mass.step.directions.resize(3, 4);
  CHECK_THROWS_AS(assemble_impact(mass.step, mass.response, mass.problem), std::invalid_argument);
}

TEST_CASE("Impact law: a group without friction is refused, not looked into", "[contact]") {
  PointMass mass;
  mass.problem.groups[0].friction = nullptr;
  CHECK_THROWS_AS(assemble_impact(mass.step, mass.response, mass.problem), std::invalid_argument);
}
