#pragma once

#include <vector>

#include "contensou/output/table.hpp"
#include "costs.hpp"

namespace bench {

/// The aims of the contact solvers, measured once more in a run of their own with many rounds: one Coulomb
/// contact to 1e-12 against the best solver of Siconos, which `rows` tell; one Coulomb–Contensou contact in
/// seconds.
contensou::Table measure_solver_aims(const std::vector<Family>& families,
                                     const std::vector<SolverUnderTest>& solvers,
                                     const std::vector<CostRow>& rows);

}  // namespace bench
