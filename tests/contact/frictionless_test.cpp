// A contact without friction takes one row and runs no friction code.

#include <catch2/catch.hpp>
#include <limits>
#include <type_traits>

#include "contensou/contact/blocks.hpp"
#include "contensou/contact/contact_solver.hpp"

using namespace contensou;

namespace {

/// A friction disk that counts what is asked of it.
struct CountingDisk {
  static constexpr int dimension = 2;
  FrictionDisk disk{};
  mutable int calls = 0;

  Projection<2> project(const Eigen::Vector2d& force, double size) const {
    ++calls;
    return disk.project(force, size);
  }
  ProjectionDerivative<2> derivative(const Projection<2>& q, const Eigen::Vector2d& force,
                                     double size) const {
    ++calls;
    return disk.derivative(q, force, size);
  }
};

// Nothing to call, nothing to store, one row: the compiler leaves no room for friction.
static_assert(!FrictionDomain<NoFriction> && std::is_empty_v<NoFriction>);
static_assert(ContactVector<NoFriction>::SizeAtCompileTime == 1);
static_assert(ContactMatrix<NoFriction>::SizeAtCompileTime == 1);

}  // namespace

TEST_CASE("Frictionless: friction is asked where a contact presses, and only there", "[contact]") {
  const CountingDisk disk;
  Eigen::Matrix3d jacobian;
  static_cast<void>(project_contact(disk, 0.5, Eigen::Vector3d(-1, 2, 3)));
  static_cast<void>(project_contact(disk, 0.5, Eigen::Vector3d(0, 2, 3), jacobian));
  CHECK(disk.calls == 0);
  static_cast<void>(project_contact(disk, 0.5, Eigen::Vector3d(1, 2, 3)));
  CHECK(disk.calls == 1);
  static_cast<void>(project_contact(disk, 0.5, Eigen::Vector3d(1, 2, 3), jacobian));
  CHECK(disk.calls == 3);
}

TEST_CASE("Frictionless: mu is read by nobody", "[contact]") {
  // Any friction code would throw for the size NaN Λ_N, or hand on the NaN. A bar on two supports: see
  // gauss_seidel_test.cpp.
  const AnyFriction frictionless{NoFriction{}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const ContactProblem bar{{{&frictionless, {nan, nan}}},
                           (Eigen::MatrixXd(2, 2) << 2, -1, -1, 5).finished(),
                           Eigen::Vector2d(-3, -3)};
  const ContactProblem one{
      {{&frictionless, {nan}}}, Eigen::MatrixXd::Constant(1, 1, 0.5), Eigen::VectorXd::Constant(1, -3)};
  for (const SolverMethod method : {SolverMethod::modified_newton, SolverMethod::gauss_seidel,
                                    SolverMethod::semismooth_newton, SolverMethod::automatic}) {
    CAPTURE(static_cast<int>(method));
    ContactSolver solver({.method = method});
    Eigen::VectorXd impulse;
    CHECK(solver.solve(bar, impulse).status == SolverStatus::solved);
    CHECK((impulse - Eigen::Vector2d(2, 1)).norm() < 1e-11);
    CHECK(solver.solve(one, impulse).status == SolverStatus::solved);
    CHECK(std::abs(impulse[0] - 6) < 1e-11);
  }
}
