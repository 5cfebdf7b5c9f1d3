#include "contensou/contact/acceleration_level.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "contensou/contact/contact_solver.hpp"

using namespace contensou;

namespace {

const AnyFriction point{FrictionDisk{}};
const AnyFriction uniform{FrictionBall(SmoothPlate(UniformLaw{}))};

SolverReport solve(const AccelerationLevel& level, Eigen::VectorXd& reduced) {
  return ContactSolver({.method = SolverMethod::gauss_seidel}).solve(level.problem(), reduced);
}

/// Painlevé's rod of mass 1 and length 2 at tan θ = 2, its lower end sliding on the floor; the second
/// tangential direction is out of its plane. I = 1/3, arms cos θ and sin θ.
ContactProblem rod(double mu, double free_acceleration) {
  const double cos2 = 0.2;
  const double cos_sin = 0.4;
  const double sin2 = 0.8;
  Eigen::MatrixXd w(3, 3);
  w << 1 + 3 * cos2, -3 * cos_sin, 0, -3 * cos_sin, 1 + 3 * sin2, 0, 0, 0, 1;
  return {{{&point, {mu}}}, w, Eigen::Vector3d(free_acceleration, 0, 0)};
}

}  // namespace

TEST_CASE("Acceleration level: a block that slides and one that sticks", "[contact]") {
  // Unit masses under g = 10 on μ = 0.5; the first slides along (3, 4), the second rests and is pushed by 3.
  Eigen::VectorXd b(6);
  b << -10, 0, 0, -10, 3, 0;
  const ContactProblem full{{{&point, {0.5, 0.5}}}, Eigen::MatrixXd::Identity(6, 6), b};
  Eigen::VectorXd gamma = Eigen::VectorXd::Zero(6);
  gamma.segment<2>(1) << 3, 4;
  const AccelerationLevel level(full, gamma);
  CHECK(level.problem().rows() == 4);  // three of the one that sticks, one of the other
  CHECK_FALSE(level.paradox());
  Eigen::VectorXd reduced;
  REQUIRE(solve(level, reduced).status == SolverStatus::solved);
  Eigen::VectorXd expected(6);
  expected << 10, -3, -4, 10, -3, 0;
  CHECK((level.forces(reduced) - expected).norm() < 1e-14);
  CHECK((level.reduced(level.forces(reduced)) - reduced).norm() == 0);
}

TEST_CASE("Acceleration level: a disc that spins on the spot is braked by 2/3 μλ_N R", "[contact]") {
  const ContactProblem full{
      {{&uniform, {0.3}}}, Eigen::MatrixXd::Identity(4, 4), Eigen::Vector4d(-10, 0, 0, 0)};
  const AccelerationLevel level(full, Eigen::Vector4d(0, 0, 0, -7));
  Eigen::VectorXd reduced;
  REQUIRE(solve(level, reduced).status == SolverStatus::solved);
  CHECK((level.forces(reduced) - Eigen::Vector4d(10, 0, 0, 2)).norm() < 1e-14);
}

TEST_CASE("Acceleration level: Painlevé's rod", "[contact]") {
  // Sliding backward, W_NN − μ W_NF x̂ = 8/5 − 6/5 μ: zero at μ = 4/3.
  const Eigen::Vector3d backward(0, -1, 0);
  Eigen::VectorXd reduced;
  const AccelerationLevel below(rod(1.3, -10), backward);
  CHECK_FALSE(below.paradox());
  REQUIRE(solve(below, reduced).status == SolverStatus::solved);
  CHECK(reduced[0] == Approx(10 / (1.6 - 1.2 * 1.3)).epsilon(1e-13));
  CHECK(below.forces(reduced)[1] == Approx(1.3 * reduced[0]).epsilon(1e-15));

  const AccelerationLevel above(rod(1.4, -10), backward);
  CHECK(above.paradox());
  reduced.resize(0);
  CHECK(solve(above, reduced).status != SolverStatus::solved);  // there is no force
  const AccelerationLevel lifting(rod(1.4, 10), backward);      // and here two, of which zero is one
  CHECK(solve(lifting, reduced).status == SolverStatus::solved);

  const AccelerationLevel forward(rod(1.4, -10), Eigen::Vector3d(0, 1, 0));
  CHECK_FALSE(forward.paradox());
  REQUIRE(solve(forward, reduced).status == SolverStatus::solved);
  CHECK(reduced[0] == Approx(10 / (1.6 + 1.2 * 1.4)).epsilon(1e-13));
}

TEST_CASE("Acceleration level: velocities are checked", "[contact]") {
  CHECK_THROWS_AS(AccelerationLevel(rod(1, -10), Eigen::Vector2d(0, 0)), std::invalid_argument);
  CHECK_THROWS_AS(AccelerationLevel(rod(1, -10), Eigen::Vector3d(0, std::nan(""), 0)), std::invalid_argument);
}
