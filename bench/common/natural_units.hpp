#pragma once

#include "contensou/contact/contact_problem.hpp"

namespace bench {

/// The same problem in units in which every contact's own block of W has norm 1 (its largest sum of |entries|
/// in a row; a block that is zero stays so) and the largest |b| is 1. Λ_i = s_i Λ'_i, γ_i = γ'_i/s_i leaves
/// every friction law of one contact as it is, and measures of error that add velocities to impulses, as
/// other people's do, get a meaning.
contensou::ContactProblem in_natural_units(const contensou::ContactProblem& problem);

}  // namespace bench
