#include "methods.hpp"

namespace bench {

std::vector<SolverUnderTest> siconos_solvers() { return {}; }

}  // namespace bench
