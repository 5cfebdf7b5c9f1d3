#include "contensou/contact/semismooth_newton.hpp"

#include <stdexcept>

namespace contensou {

SolverReport solve_semismooth_newton(const ContactProblem&, Eigen::VectorXd&, const SolverOptions&,
                                     SemismoothNewtonMemory&) {
  throw std::logic_error("solve_semismooth_newton: not written yet");
}

}  // namespace contensou
