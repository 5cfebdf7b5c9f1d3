#include "patch.hpp"

#include <gsl/gsl_sf_gamma.h>

#include <cmath>
#include <numbers>

namespace verify::answers {
namespace {

constexpr double relative = 1e-13;
constexpr double quarter = std::numbers::pi / 2;

}  // namespace

Patch::Patch(double n)
    : n_(n),
      force_(2 * (n + 1) / std::numbers::pi * gsl_sf_beta(0.5, n + 1)),
      torque_(2 * (n + 1) / std::numbers::pi * gsl_sf_beta(1.5, n + 1)),
      rule_(relative) {}

Patch::Friction Patch::at(double v, double s) const { return v <= s ? turning(v / s) : sliding(s / v); }

double Patch::torque_at_rest() const { return torque_ * quarter; }
double Patch::slope_at_rest() const { return force_ * quarter / 2; }

// x = π/2 − θ; c has its branch points at tan x = ±i√(1 − u²).
Patch::Friction Patch::turning(double u) const {
  const double rest = (1 - u) * (1 + u);
  const auto chord = [rest](double x) {
    const double sine = std::sin(x), cosine = std::cos(x);
    return std::sqrt(sine * sine + rest * cosine * cosine);
  };
  const auto along = [&](double x) {
    const double sine = std::sin(x);
    return sine * sine * std::pow(chord(x), 2 * n_ + 1);
  };
  const auto about = [&](double x) { return std::pow(chord(x), 2 * n_ + 3); };
  const double width = std::sqrt(rest);
  return {force_ * u * rule_.integrate_near_pole(along, quarter, width).value,
          torque_ * rule_.integrate_near_pole(about, quarter, width).value};
}

// x = π/2 − φ
Patch::Friction Patch::sliding(double k) const {
  const double rest = (1 - k) * (1 + k);
  const auto root = [k, rest](double x) {
    const double sine = k * std::sin(x);
    return std::sqrt(rest + sine * sine);
  };
  const auto along = [&](double x) { return root(x) * std::pow(std::sin(x), 2 * n_ + 2); };
  const auto about = [&](double x) { return std::pow(std::sin(x), 2 * n_ + 4) / root(x); };
  const double width = std::sqrt(rest);
  return {force_ * rule_.integrate_near_pole(along, quarter, width).value,
          torque_ * k * rule_.integrate_near_pole(about, quarter, width).value};
}

}  // namespace verify::answers
