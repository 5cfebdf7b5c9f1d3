#pragma once

#include <cstdint>
#include <vector>

#include "contensou/contact/contact_problem.hpp"

namespace verify::siconos {

/// A problem of Coulomb contacts alone, in the units of bench::in_natural_units.
struct CoulombProblem {
  contensou::ContactProblem problem;
  std::vector<double> mu;
  bool well_conditioned;  ///< of the second kind below
};

/// The first `count` of random_contact::random_problem that have Coulomb contacts alone and b ≠ 0: mass
/// ratios to 1e6, rank-deficient W, μ from 0 to 10; each has a solution.
std::vector<CoulombProblem> hard_problems(int count);

/// `count` problems with μ <= 0.1 and W = I + AAᵀ/2n, entries of A uniform in ±1, before the scaling; b
/// uniform in ±1, b_N of the first contact negative.
std::vector<CoulombProblem> easy_problems(int count, std::uint64_t seed);

}  // namespace verify::siconos
