#include "contensou/integrate/constraint_solver.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "../allocation_counter.hpp"

using namespace contensou;

namespace {

Eigen::VectorXd solve(ConstraintSolver& solver, const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  solver.resize(b.size());
  solver.matrix = a;
  solver.side = b;
  return solver.solve();
}

/// M⁻¹ in coordinates of size one: any positive definite matrix of order one that has no structure.
Eigen::MatrixXd generic(Eigen::Index m) {
  Eigen::MatrixXd a(m, m);
  for (Eigen::Index i = 0; i < m; ++i) {
    for (Eigen::Index j = 0; j < m; ++j)
      a(i, j) = std::sin(1.3 * double(i) + 2.1 * double(j * j) + 0.4 * double(i * j));
  }
  return a * a.transpose() + Eigen::MatrixXd::Identity(m, m);
}

}  // namespace

TEST_CASE("ConstraintSolver: forces of any size, alone and together", "[integrate]") {
  ConstraintSolver solver;
  CHECK(solve(solver, Eigen::MatrixXd::Constant(1, 1, 4e-12), Eigen::VectorXd::Constant(1, 2))[0] == 5e11);
  for (Eigen::Index m = 2; m <= 8; ++m) {
    // Rows and columns from 1 to 10^-12, mixed; the size of x_i is that of 1/d_i.
    Eigen::VectorXd d(m), x(m);
    for (Eigen::Index i = 0; i < m; ++i) {
      d[i] = std::pow(10, -6 - 6 * std::sin(double(3 * i)));
      x[i] = std::cos(double(i)) + 2;
    }
    Eigen::MatrixXd a = generic(m);
    a(0, m - 1) *= 1.1;  // nearly symmetric only
    const Eigen::VectorXd b = d.cwiseProduct(a * x);
    a = d.asDiagonal() * a * d.asDiagonal();
    const Eigen::VectorXd found = solve(solver, a, b);
    CAPTURE(m);
    // The condition of generic() is below 100.
    CHECK((found.cwiseProduct(d) - x).cwiseAbs().maxCoeff() < 100 * 3e-16 * double(m));
  }
}

TEST_CASE("ConstraintSolver: constraints that repeat each other share the force", "[integrate]") {
  ConstraintSolver solver;
  // w and 10w: of the forces (f₁, f₂) with f₁ + 10 f₂ = 1 the least is (1, 10)/101.
  const Eigen::VectorXd two = solve(solver, Eigen::MatrixXd{{1, 10}, {10, 100}}, Eigen::VectorXd{{1, 10}});
  CHECK(two[0] == Approx(1 / 101.0).epsilon(1e-14));
  CHECK(two[1] == Approx(10 / 101.0).epsilon(1e-14));
  // Three directions in a plane, symmetric: w₃ = (w₁ + w₂)/√2. For b = WᵀW f of f = (1, 1, 0) the least norm
  // is that without the part along (1, 1, −√2).
  const double r = std::sqrt(0.5);
  const Eigen::MatrixXd w{{1, 0, r}, {0, 1, r}};
  const Eigen::MatrixXd a = w.transpose() * w;
  const Eigen::VectorXd three = solve(solver, a, a * Eigen::Vector3d(1, 1, 0));
  CHECK((three - Eigen::Vector3d(0.5, 0.5, r)).cwiseAbs().maxCoeff() < 1e-14);
  // Regular again: nothing is left of the former.
  const Eigen::VectorXd regular =
      solve(solver, Eigen::Vector3d(1, 2, 4).asDiagonal(), Eigen::Vector3d(1, 2, 4));
  CHECK((regular - Eigen::Vector3d::Ones()).cwiseAbs().maxCoeff() < 1e-15);
}

TEST_CASE("ConstraintSolver: no allocation, and an end for numbers that are none", "[integrate]") {
  ConstraintSolver solver;
  const Eigen::MatrixXd a = generic(6);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(6);
  solve(solver, a, b);
  allocation_counter::reset();
  allocation_counter::start();
  solver.matrix = a;
  solver.side = b;
  solver.solve();
  allocation_counter::stop();
  if (allocation_counter::available()) CHECK(allocation_counter::count() == 0);
  Eigen::MatrixXd broken = a;
  broken(2, 3) = std::nan("");
  CHECK(!solve(solver, broken, b).allFinite());
}
