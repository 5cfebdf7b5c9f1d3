#include "contensou/contact/automatic.hpp"

#include <stdexcept>

namespace contensou {

SolverReport solve_automatic(const ContactProblem&, Eigen::VectorXd&, const SolverOptions&,
                             AutomaticMemory&) {
  throw std::logic_error("solve_automatic: not written yet");
}

}  // namespace contensou
