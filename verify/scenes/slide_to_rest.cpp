#include "slide_to_rest.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "ode.hpp"

namespace verify::answers {

Limits limits(double n) { return {2 / (3 + 2 * n), 1 / (3 + 2 * n), 1 / (4 + 2 * n)}; }

double ratio(const Patch& patch, double u) {
  const auto [xi, eta] = patch.at(u, 1);
  return u * eta / xi;
}

double final_ratio(const Patch& patch, double kappa) {
  const Limits border = limits(patch.n());
  if (kappa >= border.spins_only) return 0;
  if (kappa <= border.slides_only) return std::numeric_limits<double>::infinity();
  double low = 0, high = 1;
  while (ratio(patch, high) > kappa) low = high, high *= 2;
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    (ratio(patch, middle) > kappa ? low : high) = middle;
  }
  return (low + high) / 2;
}

double final_ratio_hertz(double kappa) {
  const double half = 1 - kappa / 2, last = 1 - 2 * kappa;
  return std::sqrt(2 * last / (half + std::sqrt(half * half - 1.5 * last)));
}

double late_ratio(const Patch& patch, double kappa, double start, double folds) {
  std::vector<double> angle{std::atan(start)};
  const auto right = [&](double, const double* at, double* rate) {
    const double sine = std::sin(at[0]), cosine = std::cos(at[0]);
    const auto [xi, eta] = patch.at(sine, cosine);
    *rate = (sine * eta / kappa - cosine * xi) / (sine * xi + cosine * eta / kappa);
  };
  solve(right, 0, folds, angle);
  return std::tan(angle[0]);
}

SlideToRest::SlideToRest(const Patch& patch, double a, double kappa, double v, double s)
    : patch_(patch.n()), a_(a), kappa_(kappa), v_(v), s_(s) {
  const double r = std::hypot(v, s);
  // ψ, and t, slid, turned in units of r/a, r²/a
  std::vector<double> y{std::atan2(v, s), 0, 0, 0};
  const auto right = [this](double l, const double* at, double* rate) {
    const double sine = std::sin(at[0]), cosine = std::cos(at[0]);
    const auto [xi, eta] = patch_.at(sine, cosine);
    const double slower = sine * xi + cosine * eta / kappa_;  // −ṙ/a
    const double left = std::exp(-l);
    rate[0] = (sine * eta / kappa_ - cosine * xi) / slower;
    rate[1] = left / slower;
    rate[2] = left * left * sine / slower;
    rate[3] = left * left * cosine / slower;
  };
  constexpr double far = 37;  // e^−37 < 2^−53: what is left of r no double would see
  solve(right, 0, far, y);
  stop_ = y[1] * r / a;
  slid_ = y[2] * r * r / a;
  turned_ = y[3] * r * r / a;
}

std::vector<SlideToRest::Point> SlideToRest::at(const std::vector<double>& times) const {
  const double r = std::hypot(v_, s_);
  std::vector<double> y{v_ / r, s_ / r, 0, 0};
  const auto right = [this](double, const double* at, double* rate) {
    const auto [xi, eta] = patch_.at(std::abs(at[0]), std::abs(at[1]));
    rate[0] = -xi;
    rate[1] = -eta / kappa_;
    rate[2] = at[0];
    rate[3] = at[1];
  };
  std::vector<Point> points;
  double now = 0;
  for (const double t : times) {
    solve(right, now, t * a_ / r, y);
    now = t * a_ / r;
    points.push_back({y[0] * r, y[1] * r, y[2] * r * r / a_, y[3] * r * r / a_});
  }
  return points;
}

}  // namespace verify::answers
