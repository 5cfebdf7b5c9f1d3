#include "contensou/contact/modified_newton.hpp"

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "contensou/contact/contact_solver.hpp"

using namespace contensou;

namespace {

const AnyFriction frictionless{NoFriction{}};
const AnyFriction point{FrictionDisk{}};
const AnyFriction hertz{FrictionBall(SmoothPlate(HertzLaw{}))};

ContactProblem one_contact(const AnyFriction& friction, double mu, const Eigen::MatrixXd& w,
                           const Eigen::VectorXd& b) {
  return {{{&friction, {mu}}}, w, b};
}

/// Modified Newton to 1e-12, r as given or chosen.
ContactSolver modified_newton(std::optional<double> r = {}, int max_iterations = 0) {
  return ContactSolver({.method = SolverMethod::modified_newton,
                        .tolerance = 1e-12,
                        .max_iterations = max_iterations,
                        .r = r});
}

Eigen::MatrixXd random_delassus(std::mt19937_64& g, Eigen::Index rows, Eigen::Index dof) {
  return [&] {
    const Eigen::MatrixXd j = Eigen::MatrixXd::NullaryExpr(
        rows, dof, [&](Eigen::Index, Eigen::Index) { return static_cast<double>(g() >> 11) * 0x1p-52 - 1; });
    return Eigen::MatrixXd(j * j.transpose());
  }();
}

}  // namespace

TEST_CASE("modified Newton: stick, slip and opening in closed form", "[modified_newton]") {
  const Eigen::Vector4d w(2.0, 3.0, 3.0, 0.5);
  for (const std::optional<double> r : {std::optional<double>{}, std::optional<double>{0.3}}) {
    ContactSolver solver = modified_newton(r);
    Eigen::VectorXd impulse;

    // The free velocity is stopped: Λ = −b/w, well inside the ball.
    const Eigen::Vector4d held(-1, 0.05, -0.02, 0.01);
    SolverReport report = solver.solve(one_contact(hertz, 0.8, w.asDiagonal(), held), impulse);
    CHECK(report.status == SolverStatus::solved);
    CHECK((impulse + held.cwiseQuotient(w)).norm() < 1e-11);

    // Sliding without spin: Λ_T = −μΛ_N along γ_T.
    const Eigen::Vector4d sliding(-1, 3, 4, 0);
    impulse.resize(0);
    report = solver.solve(one_contact(hertz, 0.8, w.asDiagonal(), sliding), impulse);
    CHECK(report.status == SolverStatus::solved);
    CHECK((impulse - Eigen::Vector4d(0.5, -0.24, -0.32, 0)).norm() < 1e-11);

    const Eigen::Vector4d leaving(1, 3, 4, 1);
    report = solver.solve(one_contact(hertz, 0.8, w.asDiagonal(), leaving), impulse);
    CHECK(report.status == SolverStatus::solved);
    CHECK(impulse.isZero(0));
  }
}

TEST_CASE(
    "modified Newton: a given r converges below 2/lambda_max at the rate predicted, and above it cycles",
    "[modified_newton]") {
  // One frictionless contact, w = 2: the error shrinks by |1 − rw| each time.
  const ContactProblem problem =
      one_contact(frictionless, 0, Eigen::MatrixXd::Constant(1, 1, 2), Eigen::VectorXd::Constant(1, -1));
  for (const double r : {0.05, 0.3, 0.95}) {
    Eigen::VectorXd impulse;
    const SolverReport report = modified_newton(r).solve(problem, impulse);
    CHECK(report.status == SolverStatus::solved);
    CHECK(report.residual <= 1e-12);
    const double predicted = std::log(1e-12) / std::log(std::abs(1 - 2 * r));
    CHECK(std::abs(report.iterations - predicted) <= 1.5);
  }
  Eigen::VectorXd impulse;
  const SolverReport cycle = modified_newton(1.05).solve(problem, impulse);
  CHECK(cycle.status == SolverStatus::stalled);
  CHECK(cycle.residual == natural_map_residual(problem, impulse));
}

TEST_CASE("modified Newton: growth without bound is called divergence", "[modified_newton]") {
  // Two contacts that press on each other; with r c > 1 the swing grows.
  Eigen::Matrix2d w;
  w << 1, -0.9, -0.9, 1;
  const ContactProblem problem{{{&frictionless, {0, 0}}}, w, Eigen::Vector2d(-1, -0.5)};
  Eigen::VectorXd impulse;
  CHECK(modified_newton(5.0).solve(problem, impulse).status == SolverStatus::diverged);
  CHECK(impulse.allFinite());
  CHECK(modified_newton(1.0).solve(problem, impulse).status == SolverStatus::solved);
  CHECK((w * impulse + problem.free_velocity).norm() < 1e-11);
}

TEST_CASE("modified Newton: ends in bounds, with the best impulses and a true residual",
          "[modified_newton]") {
  std::mt19937_64 g(11);
  const ContactProblem problem{
      {{&hertz, {0.5, 0.5}}}, random_delassus(g, 8, 10), Eigen::VectorXd::Constant(8, -1)};
  Eigen::VectorXd impulse;
  const SolverReport cut = modified_newton({}, 3).solve(problem, impulse);
  CHECK(cut.status == SolverStatus::iteration_limit);
  CHECK(cut.iterations == 3);
  CHECK(cut.residual == natural_map_residual(problem, impulse));
  const SolverReport full = modified_newton().solve(problem, impulse);
  REQUIRE(full.status == SolverStatus::solved);
  CHECK(modified_newton().solve(problem, impulse).iterations == 0);  // warm
}

TEST_CASE("modified Newton: the safe steps are safe", "[modified_newton]") {
  std::mt19937_64 g(12);
  for (int k = 0; k < 200; ++k) {
    const Eigen::Index dof = 2 + k % 14;
    const ContactProblem problem{
        {{&hertz, {1, 1}}, {&point, {1}}}, random_delassus(g, 11, dof), Eigen::VectorXd::Zero(11)};
    Eigen::VectorXd s;
    safe_steps(problem, s);
    REQUIRE(s.size() == 3);
    Eigen::VectorXd root(11);
    root << Eigen::VectorXd::Constant(4, std::sqrt(s[0])), Eigen::VectorXd::Constant(4, std::sqrt(s[1])),
        Eigen::VectorXd::Constant(3, std::sqrt(s[2]));
    const Eigen::MatrixXd scaled = root.asDiagonal() * problem.delassus * root.asDiagonal();
    const double largest = scaled.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff();
    CHECK(largest <= 1 + 1e-12);
    CHECK(largest >= 1.0 / 11);  // not needlessly small: λ_max(W) >= max |W_ij| >= (largest row sum)/11
  }
}

TEST_CASE("modified Newton: the chosen r solves frictionless and weakly rubbing contacts",
          "[modified_newton]") {
  std::mt19937_64 g(13);
  for (int k = 0; k < 100; ++k) {
    const bool rubbing = k % 2 == 1;
    const int rows = rubbing ? 12 : 3;
    const Eigen::MatrixXd w = random_delassus(g, rows, rows + 3);
    const Eigen::VectorXd b =
        w * Eigen::VectorXd::NullaryExpr(rows, [&] { return static_cast<double>(g() >> 11) * 0x1p-52 - 1; });
    const ContactProblem problem{{{rubbing ? &hertz : &frictionless, {0.05, 0.05, 0.05}}}, w, b};
    Eigen::VectorXd impulse;
    const SolverReport report = modified_newton().solve(problem, impulse);
    CHECK(report.status == SolverStatus::solved);
    CHECK(natural_map_residual(problem, impulse) <= 1e-12);
  }
}

TEST_CASE("modified Newton: units do not matter", "[modified_newton]") {
  std::mt19937_64 g(14);
  const Eigen::MatrixXd w = random_delassus(g, 4, 6);
  const Eigen::Vector4d b(-1, 2, 0.5, 0.7);
  Eigen::VectorXd impulse;
  const SolverReport report = modified_newton().solve(one_contact(hertz, 0.3, w, b), impulse);
  REQUIRE(report.status == SolverStatus::solved);
  for (const int power : {-60, 60}) {
    const double mass = std::ldexp(1.0, power);
    Eigen::VectorXd scaled;
    const SolverReport again = modified_newton().solve(one_contact(hertz, 0.3, w / mass, b), scaled);
    CHECK(again.iterations == report.iterations);
    CHECK((scaled / mass - impulse).norm() <= 1e-11 * impulse.norm());
  }
}
