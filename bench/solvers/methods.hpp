#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "families.hpp"

namespace bench {

/// A solver with the problems it is to solve, all ready: a pass solves each from its guess.
class Runner {
 public:
  virtual ~Runner() = default;
  virtual void pass() = 0;
  const std::vector<Eigen::VectorXd>& impulses() const { return impulses_; }

 protected:
  std::vector<Eigen::VectorXd> impulses_;
};

/// A way to solve contact problems.
struct SolverUnderTest {
  std::string origin;  ///< "contensou" or "siconos"
  std::string name;
  double tolerance;  ///< of the method's own measure
  bool coulomb_only;
  bool one_contact_only;
  std::function<std::unique_ptr<Runner>(const std::vector<Case>&)> prepare;
};

/// Ours: every method of ContactSolver, and solve_one_contact called directly, as by a program that knows its
/// law at compile time.
std::vector<SolverUnderTest> our_solvers();

/// Siconos's, through fc3d_driver, with what can be made ready before; none where it is not installed.
std::vector<SolverUnderTest> siconos_solvers();

}  // namespace bench
