#pragma once

#include <vector>

namespace verify {

/// Values of u = v/(|ω|R), ascending: ten a decade over 1e-6 .. 1e6 (121 values, u = 1 among them), and a
/// dense set around u = 1, down to its neighbours in double precision: 1 ± 2^-k and steps of 0.01 over 0.9
/// .. 1.1.
std::vector<double> slip_ratios();

/// A coarser set of the same kind, for laws that take longer.
std::vector<double> few_slip_ratios();

}  // namespace verify
