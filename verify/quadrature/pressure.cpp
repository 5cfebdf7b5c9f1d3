#include "pressure.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "contensou/output/table.hpp"

namespace verify {

Pressure power_pressure(double n) {
  const double scale = (n + 1) / std::numbers::pi;
  const std::string name = n == 0 ? "uniform" : n == 0.5 ? "hertz" : "power:" + contensou::to_text(n);
  return {name, [n, scale](double, double complement) { return scale * std::pow(complement, n); }, {}, false};
}

Pressure tabulated(std::string name, std::vector<double> rho, std::vector<double> sigma) {
  double total = 0;  // 2π ∫ σ ρ dρ, piece by piece
  for (std::size_t i = 0; i + 1 < rho.size(); ++i) {
    const double width = rho[i + 1] - rho[i];
    total += 2 * std::numbers::pi * width / 6 *
             (sigma[i] * (2 * rho[i] + rho[i + 1]) + sigma[i + 1] * (rho[i] + 2 * rho[i + 1]));
  }
  std::vector<double> breaks(rho.begin() + 1, rho.end() - 1);
  const bool cone = sigma[0] != sigma[1];
  auto interpolate = [rho = std::move(rho), sigma = std::move(sigma), total](double r, double) {
    const auto above = std::upper_bound(rho.begin() + 1, rho.end() - 1, r);
    const auto i = static_cast<std::size_t>(above - rho.begin());
    const double t = (r - rho[i - 1]) / (rho[i] - rho[i - 1]);
    return ((1 - t) * sigma[i - 1] + t * sigma[i]) / total;
  };
  return {std::move(name), std::move(interpolate), std::move(breaks), cone};
}

}  // namespace verify
