#include "contensou/contact/contact_problem.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "contensou/contact/blocks.hpp"

using namespace contensou;

namespace {

const AnyFriction frictionless{NoFriction{}};
const AnyFriction point{FrictionDisk{}};
const AnyFriction hertz{FrictionBall(SmoothPlate(HertzLaw{}))};

/// Contacts of 1, 3, 3 and 4 rows on bodies of their own.
ContactProblem mixed() {
  return {{{&frictionless, {0}}, {&point, {0.5, 1}}, {&hertz, {0.3}}},
          Eigen::MatrixXd::Identity(11, 11),
          Eigen::VectorXd::Constant(11, -1)};
}

}  // namespace

TEST_CASE("Contact problem: rows and contacts", "[contact]") {
  CHECK(rows(frictionless) == 1);
  CHECK(rows(point) == 3);
  CHECK(rows(hertz) == 4);
  CHECK(mixed().contacts() == 4);
  CHECK(mixed().rows() == 11);
  CHECK_NOTHROW(require_valid(mixed()));
}

TEST_CASE("Contact problem: groups are visited once, contacts in order of their rows", "[contact]") {
  int groups = 0;
  std::vector<Eigen::Index> rows;
  const ContactProblem problem = mixed();
  for_each_group(problem, [&](const auto& group) {
    ++groups;
    for (Eigen::Index i = 0; i < group.count; ++i) rows.push_back(group.row(i));
  });
  CHECK(groups == 3);
  CHECK(rows == std::vector<Eigen::Index>{0, 1, 4, 7});
}

TEST_CASE("Contact problem: what is wrong is named", "[contact]") {
  const auto message = [](const ContactProblem& problem) -> std::string {
    try {
      require_valid(problem);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  ContactProblem problem = mixed();
  problem.groups[1].mu[1] = -0.5;
  CHECK(message(problem) == "contact problem: group 1, contact 1: mu = -0.5, expected a finite number >= 0");
  problem = mixed();
  problem.groups[0].mu[0] = std::numeric_limits<double>::quiet_NaN();  // frictionless: any number
  CHECK(message(problem).empty());
  problem.groups[0].friction = nullptr;
  CHECK(message(problem) == "contact problem: group 0 has no friction, not even NoFriction");
  problem = mixed();
  problem.delassus(2, 3) = std::numeric_limits<double>::infinity();
  CHECK(message(problem) == "contact problem: delassus(2, 3) = inf, expected a finite number");
  problem = mixed();
  problem.free_velocity[10] = -std::numeric_limits<double>::infinity();
  CHECK(message(problem) == "contact problem: free_velocity[10] = -inf, expected a finite number");
  problem = mixed();
  problem.free_velocity.resize(10);
  CHECK(message(problem) == "contact problem: free_velocity has 10 rows, expected 11");
  problem = mixed();
  problem.delassus.resize(11, 10);
  CHECK(message(problem) == "contact problem: delassus is 11 x 10, expected 11 x 11");
}

TEST_CASE("Natural map's residual: a velocity relative to the largest of b", "[contact]") {
  // A unit mass that falls with 2 m/s on a frictionless plane: Λ = 2 stops it. With Λ = 1.5, γ = −0.5.
  ContactProblem problem{
      {{&frictionless, {0}}}, Eigen::MatrixXd::Ones(1, 1), Eigen::VectorXd::Constant(1, -2)};
  CHECK(natural_map_residual(problem, Eigen::VectorXd::Constant(1, 2)) == 0);
  CHECK(natural_map_residual(problem, Eigen::VectorXd::Constant(1, 1.5)) == 0.25);
  CHECK(std::isinf(natural_map_residual(problem, Eigen::VectorXd::Constant(1, std::nan("")))));
  // The same in other units.
  problem.delassus *= 0x1p-500;
  problem.free_velocity *= 0x1p-400;
  CHECK(natural_map_residual(problem, Eigen::VectorXd::Constant(1, 1.5 * 0x1p100)) == 0.25);
}

TEST_CASE("Natural map's residual: friction on the ball of the projected normal impulse", "[contact]") {
  // Unit mass, b = (−1, 3, 4): Λ_N = 1, slip with γ_T along (3, 4), Λ_T = −μ (0.6, 0.8).
  const ContactProblem problem{{{&point, {0.5}}}, Eigen::MatrixXd::Identity(3, 3), Eigen::Vector3d(-1, 3, 4)};
  CHECK(natural_map_residual(problem, Eigen::Vector3d(1, -0.3, -0.4)) < 1e-16);
  // Λ = 0: Λ_N − rγ_N = 1, Λ_T − rγ_T = −(3, 4), projected on the disk of 0.5: ‖(1, 0.3, 0.4)‖ = √1.25, V
  // = 4.
  CHECK(natural_map_residual(problem, Eigen::Vector3d::Zero()) == Approx(std::sqrt(1.25) / 4).epsilon(1e-15));
}

TEST_CASE("Natural map's residual: b = 0, W_ii = 0", "[contact]") {
  ContactProblem problem{{{&frictionless, {0, 0}}}, Eigen::MatrixXd::Zero(2, 2), Eigen::Vector2d::Zero()};
  CHECK(natural_map_residual(problem, Eigen::Vector2d::Zero()) == 0);
  problem.delassus(0, 0) = 4;
  Eigen::VectorXd step;
  natural_steps(problem, step);
  CHECK(step[0] == 0.25);
  CHECK(step[1] == 0.25);
  CHECK(std::isinf(natural_map_residual(problem, Eigen::Vector2d(1, 0))));

  // W Λ = 0: a solution for b = 0, which rounding says nothing against.
  const Eigen::Matrix2d walls{{1, -1}, {-1, 1}};
  problem.delassus = walls;
  CHECK(natural_map_residual(problem, Eigen::Vector2d(1, 1)) == 0);
  CHECK(std::isinf(natural_map_residual(problem, Eigen::Vector2d(1, 2))));
  ContactProblem rough{{{&point, {0.5}}}, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()};
  CHECK(std::isinf(natural_map_residual(rough, Eigen::Vector3d(1, 0, 0))));
}

TEST_CASE("Natural map's residual: not fooled by impulses beside which velocities are rounding",
          "[contact]") {
  // Two opposite walls that press at once: γ_N = ±(Λ_1 − Λ_2) − 1 has no solution, yet Λ = 1e17 absorbs it.
  const AnyFriction none = NoFriction{};
  ContactProblem problem{{{&none, {0, 0}}}, Eigen::Matrix2d{{1, -1}, {-1, 1}}, Eigen::Vector2d(-1, -1)};
  CHECK(natural_map_residual(problem, Eigen::Vector2d(0, 0)) == Approx(1));
  CHECK(natural_map_residual(problem, Eigen::Vector2d(1e6, 1e6)) == Approx(1));
  CHECK(natural_map_residual(problem, Eigen::Vector2d(1e17, 1e17)) > 1);
}

TEST_CASE("Projection on the cone of one contact and its derivative", "[contact]") {
  const auto& ball = std::get<FrictionBall<SmoothPlate<HertzLaw>>>(hertz);
  // Inside, outside, and above a contact that opens; against central differences of the projection.
  for (const Eigen::Vector4d& x : {Eigen::Vector4d(2, 0.1, 0.2, 0.1), Eigen::Vector4d(1, 3, -2, 0.7),
                                   Eigen::Vector4d(1, 0.4, 0, -6), Eigen::Vector4d(-1, 1, 1, 1)}) {
    Eigen::Matrix4d jacobian;
    const Eigen::Vector4d p = project_contact(ball, 0.5, x, jacobian);
    CHECK((p - project_contact(ball, 0.5, x)).norm() == 0);
    constexpr double h = 1e-5;  // error h² times third derivatives of order one, and 1e-16/h
    for (int k = 0; k < 4; ++k) {
      const Eigen::Vector4d e = h * Eigen::Vector4d::Unit(k);
      const Eigen::Vector4d difference = (project_contact<std::decay_t<decltype(ball)>>(ball, 0.5, x + e) -
                                          project_contact<std::decay_t<decltype(ball)>>(ball, 0.5, x - e)) /
                                         (2 * h);
      CHECK((difference - jacobian.col(k)).norm() < 1e-8);
    }
  }
}
