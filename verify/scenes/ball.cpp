#include "ball.hpp"

#include <numbers>

namespace verify::answers {

double groove_about_vertical(const Patch& patch, double r, double patch_radius, double mu, double g) {
  const auto [xi, eta] = patch.at(r, patch_radius);
  return mu * g * (r * xi + patch_radius * eta) / (0.4 * r * r);
}

double groove_about_its_axis(double r, double mu, double g) {
  return std::numbers::sqrt2 * mu * g / ((1 + mu * mu) * 0.4 * r);
}

}  // namespace verify::answers
