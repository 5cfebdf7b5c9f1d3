#pragma once

#include <vector>

#include "reference.hpp"

namespace accuracy {

/// The law of σ ∝ (1 − ρ²/R²)ⁿ away from the seam, u <= 1/2 or u >= 2, from Gauss's
/// hypergeometric series summed in 113 bits: an oracle for as many u as one likes.
/// Every argument is at most 1/4, so each term is smaller than the last by a factor
/// of about 4 and 60 terms are enough. Itself held against the stored tables.
ReferenceRow series_oracle(double n, double u);

/// The oracle from u = 2 out to 1e9, or from 1/2 in to 1e-9: 200 values of u a decade, from the seam
/// outwards.
std::vector<ReferenceRow> series_scan(double n, bool outwards);

}  // namespace accuracy
