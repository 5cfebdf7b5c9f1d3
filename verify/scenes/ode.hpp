#pragma once

#include <functional>
#include <vector>

namespace verify::answers {

/// y' = f(t, y) from one t to a later one by GSL's Runge-Kutta-Prince-Dormand method of order 8 with errors
/// of a step of at most `accuracy` (1 + |y|): unknowns of order one. Throws std::runtime_error where GSL
/// gives up.
using OdeRight = std::function<void(double t, const double* y, double* rate)>;
inline constexpr double accuracy = 1e-13;
void solve(const OdeRight& right, double from, double to, std::vector<double>& y);

}  // namespace verify::answers
