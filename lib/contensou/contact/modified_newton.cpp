#include "contensou/contact/modified_newton.hpp"

#include <stdexcept>

namespace contensou {

SolverReport solve_modified_newton(const ContactProblem&, Eigen::VectorXd&, const SolverOptions&,
                                   ModifiedNewtonMemory&) {
  throw std::logic_error("solve_modified_newton: not written yet");
}

}  // namespace contensou
