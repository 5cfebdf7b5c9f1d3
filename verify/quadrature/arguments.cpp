#include "arguments.hpp"

#include <algorithm>
#include <cmath>

namespace verify {
namespace {

std::vector<double> around_one(int a_decade, int k_step, int linear_steps) {
  std::vector<double> u;
  for (int i = -6 * a_decade; i <= 6 * a_decade; ++i)
    u.push_back(std::pow(10.0, static_cast<double>(i) / a_decade));
  for (int k = 1; k <= 53; k += k_step) {
    u.push_back(1 - std::ldexp(1.0, -k));
    if (k <= 52) u.push_back(1 + std::ldexp(1.0, -k));
  }
  u.push_back(1 - 0x1p-53);
  u.push_back(1 + 0x1p-52);
  for (int i = -linear_steps; i <= linear_steps; ++i) u.push_back(1 + 0.1 * i / linear_steps);
  std::sort(u.begin(), u.end());
  u.erase(std::unique(u.begin(), u.end()), u.end());
  return u;
}

}  // namespace

std::vector<double> slip_ratios() { return around_one(10, 3, 10); }
std::vector<double> few_slip_ratios() { return around_one(2, 9, 2); }

}  // namespace verify
