#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "contensou/contact/contact_problem.hpp"

namespace bench {

/// A contact problem and where the solvers start.
struct Case {
  contensou::ContactProblem problem;
  Eigen::VectorXd guess;
};

/// Problems of one kind. Cold: from zero. Warm: from the solution for a free velocity b that differs by up to
/// 1 % of the largest |b| in each row, as the step before in time-stepping.
struct Family {
  std::string name;
  bool coulomb;  ///< contacts with three rows alone
  bool one_contact;
  std::vector<Case> cold, warm;
};

/// coulomb_1, uniform_1, hertz_1: one contact, Coulomb's or Coulomb–Contensou friction of that pressure;
/// coulomb_n, contensou_n: 2 to 8. From random_contact::random_problem, in its natural units, without those
/// that open at once (all b_N >= 0).
std::vector<Family> families();

}  // namespace bench
