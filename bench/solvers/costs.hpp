#pragma once

#include <string>
#include <vector>

#include "families.hpp"
#include "methods.hpp"

namespace bench {

/// What the aims ask for, of natural_map_residual.
constexpr double aimed_residual = 1e-12;

/// What one solver costs on one family.
struct CostRow {
  const Family* family;
  const SolverUnderTest* solver;
  bool warm;
  double error;    ///< largest natural-map residual of the problems solved
  int failures;    ///< problems not solved
  int above_aim;   ///< problems with a residual above aimed_residual, solved or not
  double seconds;  ///< per problem; not a number where not timed

  const std::vector<Case>& cases() const { return warm ? family->warm : family->cold; }
};

/// Every solver on every family that it can take. Solved is what has a residual of at most 1000 times the
/// tolerance asked for, or 1e-10 where none is asked for. Solvers that leave more than half unsolved are not
/// timed.
std::vector<CostRow> measure_solvers(const std::vector<Family>& families,
                                     const std::vector<SolverUnderTest>& solvers);

}  // namespace bench
