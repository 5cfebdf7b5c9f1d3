// Sliding and drilling friction apart, in one contact and in many.

#include "contensou/contact/cylinder_contact.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "contensou/contact/acceleration_level.hpp"
#include "contensou/contact/contact_solver.hpp"

using namespace contensou;
using Eigen::Matrix4d;
using Eigen::Vector4d;

namespace {

constexpr double eta = 3 * M_PI / 16;
const FrictionCylinder cylinder(eta);
const AnyFriction apart{cylinder};
const AnyFriction disk{FrictionDisk{}};
const AnyFriction hertz{FrictionBall(SmoothPlate(HertzLaw{}))};
const AnyFriction frictionless{NoFriction{}};

double number(std::mt19937_64& g) { return static_cast<double>(g() >> 11) * 0x1p-52 - 1; }

Matrix4d random_compliance(std::mt19937_64& g) {
  const Matrix4d j = Matrix4d::NullaryExpr([&] { return number(g); });
  return j * j.transpose() + 0.3 * Matrix4d::Identity();
}

auto solve(double mu, const Matrix4d& w, const Vector4d& b, const Vector4d& guess = Vector4d::Zero()) {
  return solve_one_contact(cylinder, mu, w, b, guess);
}

/// The natural map's residual of one contact, which shares no code with the search by states.
double residual(double mu, const Matrix4d& w, const Vector4d& b, const Vector4d& lambda) {
  return natural_map_residual(ContactProblem{{{&apart, {mu}}}, w, b}, lambda);
}

}  // namespace

TEST_CASE("Cylinder contact: each state by hand, on a body without coupling", "[contact]") {
  const Matrix4d w = Vector4d(1, 2, 2, 4).asDiagonal();
  const double mu = 0.25;  // Λ_N = 2, sliding at most 0.5, drilling at most 0.5 η
  const auto check = [&](const Vector4d& b, const Vector4d& expected, ContactState state) {
    const auto found = solve(mu, w, b);
    CAPTURE(b.transpose());
    CHECK(found.state == state);
    CHECK((found.impulse - expected).norm() <= 1e-15);
  };
  check({1, 1, 1, 1}, {0, 0, 0, 0}, ContactState::open);
  check({-2, 0.6, -0.8, 1}, {2, -0.3, 0.4, -0.25}, ContactState::stick);
  check({-2, 3, -4, 1}, {2, -0.3, 0.4, -0.25}, ContactState::slip);           // slides, spin held
  check({-2, 0.6, -0.8, -9}, {2, -0.3, 0.4, 0.5 * eta}, ContactState::slip);  // spins on the spot
  check({-2, 3, -4, 9}, {2, -0.3, 0.4, -0.5 * eta}, ContactState::slip);      // both
  check({-2, 0, 0, 0}, {2, 0, 0, 0}, ContactState::stick);
  // Without friction.
  const auto smooth = solve(0, w, {-2, 3, -4, 9});
  CHECK(smooth.state == ContactState::slip);
  CHECK((smooth.impulse - Vector4d(2, 0, 0, 0)).norm() == 0);
}

TEST_CASE("Cylinder contact: impulses made from the law are found again, from any guess", "[contact]") {
  std::mt19937_64 g(21);
  std::array<int, 4> met{};
  for (int k = 0; k < 4000; ++k) {
    const Matrix4d w = random_compliance(g);
    // So small that Λ is unique: μ times what couples N and F stays below the least eigenvalue of W.
    const double mu = 0.3 / w.norm() * std::abs(number(g));
    const bool slides = number(g) > 0;
    const bool spins = number(g) > 0;
    ++met[static_cast<std::size_t>(2 * slides + spins)];
    const double normal = 0.1 + std::abs(number(g));
    const Eigen::Vector2d direction = Eigen::Vector2d(number(g), number(g)).normalized();
    const double drilling = mu * normal * eta * (spins ? std::copysign(1, number(g)) : 0.99 * number(g));
    Vector4d lambda;
    lambda << normal, -mu * normal * (slides ? 1 : 0.99 * std::abs(number(g))) * direction, drilling;
    Vector4d gamma = Vector4d::Zero();
    if (slides) gamma.segment<2>(1) = std::pow(10, 3 * number(g)) * direction;
    if (spins) gamma[3] = -std::copysign(std::pow(10, 3 * number(g)), drilling);
    const Vector4d b = gamma - w * lambda;
    if (b[0] >= 0) continue;
    const Vector4d off = Vector4d(0, number(g), number(g), number(g)) + lambda;
    for (const Vector4d& guess : {Vector4d(Vector4d::Zero()), lambda, off}) {
      const auto found = solve(mu, w, b, guess);
      REQUIRE(found.state == (slides || spins ? ContactState::slip : ContactState::stick));
      // The problem's condition, about 10, times its tolerance: 1e-13 of the largest velocity.
      REQUIRE((found.impulse - lambda).norm() < 1e-12 * std::max(1.0, b.norm()));
      REQUIRE(residual(mu, w, b, found.impulse) < 1e-12);
    }
  }
  for (const int count : met) CHECK(count > 500);
}

TEST_CASE("Cylinder contact: any friction, all rows coupled", "[contact]") {
  std::mt19937_64 g(22);
  for (int k = 0; k < 4000; ++k) {
    const Matrix4d w = random_compliance(g);
    Vector4d b = Vector4d::NullaryExpr([&] { return number(g); });
    b[0] = -std::abs(b[0]);
    const double mu = std::pow(10, 2 * number(g) - 1);  // 1e-3 to 10
    const auto found = solve(mu, w, b);
    CAPTURE(k, mu);
    REQUIRE(found.state != ContactState::unsolved);
    REQUIRE(residual(mu, w, b, found.impulse) < 1e-12);
    // Friction takes energy, at the rate of the support function.
    const Vector4d gamma = w * found.impulse + b;
    const double power = found.impulse.tail<3>().dot(gamma.tail<3>());
    const double most = mu * found.impulse[0] * (gamma.segment<2>(1).norm() + eta * std::abs(gamma[3]));
    REQUIRE(std::abs(power + most) <= 1e-12 * (1 + mu) * found.impulse.norm() * (1 + gamma.norm()));
  }
}

TEST_CASE("Cylinder contact: singular compliance, in the range of which b lies", "[contact]") {
  std::mt19937_64 g(23);
  int bad = 0;
  for (int k = 0; k < 2000; ++k) {
    const int rank = 1 + k % 3;
    const Matrix4d all = Matrix4d::NullaryExpr([&] { return number(g); });
    const Eigen::MatrixXd j = all.leftCols(rank);
    const Matrix4d w = j * j.transpose();
    Vector4d b = j * Vector4d::NullaryExpr([&] { return number(g); }).head(rank);
    if (b[0] > 0) b = -b;
    if (!(solve(0.5, w, b).residual < 1e-12)) ++bad;
  }
  CHECK(bad == 0);
}

TEST_CASE("Cylinder contact: without a radius, and with a huge one", "[contact]") {
  const Eigen::Vector3d coulomb =
      solve_one_contact(FrictionDisk{}, 0.3, Eigen::Matrix3d::Identity(), {-1, 3, 4}, {0, 0, 0}).impulse;
  for (const double radius : {0.0, 1e-150, 1e-9, 1e9, 1e150}) {
    Matrix4d w = Matrix4d::Identity();
    w(3, 3) = radius * radius;
    const auto found = solve(0.3, w, {-1, 3, 4, radius});
    CAPTURE(radius);
    CHECK(found.state == ContactState::slip);
    CHECK((found.impulse.head<3>() - coulomb).norm() < 1e-15);
    // Beyond R = 1/(0.3 η) drilling friction holds it: Λ_τ = −γ_τ/R².
    if (radius > 1) CHECK(found.impulse[3] == Approx(-1 / radius));
    if (radius < 1 && radius > 0) CHECK(found.impulse[3] == Approx(-0.3 * eta));
  }
}

TEST_CASE("Cylinder contact: finite numbers whose products overflow are no reason to throw", "[contact]") {
  Matrix4d w = Matrix4d::Identity();
  w(0, 0) = 1e-300;
  w(0, 1) = w(1, 0) = 1e20;
  const auto found = solve(0.3, w, {-1, 0, 0, 0});
  CHECK(found.state == ContactState::unsolved);
  CHECK(found.impulse.allFinite());
}

TEST_CASE("Cylinder contacts: all methods, beside contacts of other kinds", "[contact]") {
  std::mt19937_64 g(24);
  const std::vector<ContactGroup> groups{
      {&frictionless, {0}}, {&apart, {0.2, 0.05}}, {&disk, {0.3}}, {&hertz, {0.1}}};
  const Eigen::Index rows = ContactProblem{groups, {}, {}}.rows();
  for (int k = 0; k < 40; ++k) {
    // A lift opens all contacts without sliding, so there is a solution; with few coordinates W is singular.
    const Eigen::Index freedom = k % 2 == 0 ? rows + 1 : rows - 4;
    Eigen::MatrixXd h = Eigen::MatrixXd::NullaryExpr(freedom, rows, [&] { return number(g); });
    h.row(0).setZero();
    for (const Eigen::Index normal : {0, 1, 5, 9, 12}) h(0, normal) = 2;
    const Eigen::VectorXd u = Eigen::VectorXd::NullaryExpr(freedom, [&] { return number(g); });
    const ContactProblem problem{groups, h.transpose() * h, h.transpose() * u};
    for (const SolverMethod method : {SolverMethod::automatic, SolverMethod::semismooth_newton,
                                      SolverMethod::gauss_seidel, SolverMethod::modified_newton}) {
      ContactSolver solver({.method = method, .tolerance = 1e-10});
      Eigen::VectorXd impulse;
      const SolverReport report = solver.solve(problem, impulse);
      CAPTURE(k, static_cast<int>(method), report.iterations, report.residual);
      if (method == SolverMethod::automatic || k % 2 == 0) CHECK(report.status == SolverStatus::solved);
      CHECK(report.residual == Approx(natural_map_residual(problem, impulse)).margin(1e-12));
    }
  }
}

TEST_CASE("Cylinder contacts: the default solver, whatever the friction, redundant or not", "[contact]") {
  std::mt19937_64 g(25);
  for (const double typical : {0.1, 1.0, 10.0}) {
    for (const int missing : {-1, 4, 8}) {
      for (int k = 0; k < 30; ++k) {
        const double mu = typical * std::pow(10, number(g) / 2);
        const std::vector<ContactGroup> groups{
            {&frictionless, {0}}, {&apart, {mu, mu / 3, mu / 2}}, {&disk, {mu}}};
        const Eigen::Index rows = ContactProblem{groups, {}, {}}.rows();
        Eigen::MatrixXd h = Eigen::MatrixXd::NullaryExpr(rows - missing, rows, [&] { return number(g); });
        h.row(0).setZero();
        for (const Eigen::Index normal : {0, 1, 5, 9, 13}) h(0, normal) = 2;  // a lift opens all
        const Eigen::VectorXd u = Eigen::VectorXd::NullaryExpr(rows - missing, [&] { return number(g); });
        const ContactProblem problem{groups, h.transpose() * h, h.transpose() * u};
        ContactSolver solver({.tolerance = 1e-10});
        Eigen::VectorXd impulse;
        CAPTURE(mu, missing, k);
        CHECK(solver.solve(problem, impulse).status == SolverStatus::solved);
      }
    }
  }
}

TEST_CASE("Cylinder contact: not on acceleration level", "[contact]") {
  const ContactProblem problem{{{&apart, {0.5}}}, Matrix4d::Identity(), Vector4d(-1, 1, 1, 1)};
  CHECK_THROWS_AS(AccelerationLevel(problem, Vector4d(0, 1, 0, 0)), std::invalid_argument);
}
