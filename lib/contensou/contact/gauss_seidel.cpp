#include "contensou/contact/gauss_seidel.hpp"

#include <stdexcept>

namespace contensou {

SolverReport solve_gauss_seidel(const ContactProblem&, Eigen::VectorXd&, const SolverOptions&,
                                GaussSeidelMemory&) {
  throw std::logic_error("solve_gauss_seidel: not written yet");
}

}  // namespace contensou
