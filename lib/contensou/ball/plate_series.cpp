#include "contensou/ball/plate_series.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/roots.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace contensou {
namespace {

// The elimination subtracts nearly equal numbers, about one digit
// a term: 100 digits leave more than 50 for the last of 40 terms.
using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;
using Series = std::vector<Real>;  // in t = u² (inner) or t = u⁻² (outer)

constexpr int most_terms = 40;
constexpr double largest_exponent = 100;
constexpr double negligible = 1e-50;

/// ₂F₁(a, b; c; t) to `count` terms.
Series hypergeometric(const Real& a, const Real& b, const Real& c, std::size_t count) {
  Series s(count);
  Real term = 1;
  for (std::size_t k = 0; k < count; ++k) {
    s[k] = term;
    const Real j(static_cast<unsigned>(k));
    term *= (a + j) * (b + j) / ((c + j) * (j + 1));
  }
  return s;
}

Series operator*(const Series& p, const Series& q) {
  Series r(p.size(), Real(0));
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; i + j < p.size(); ++j) r[i + j] += p[i] * q[j];
  }
  return r;
}

Series scaled(Series s, const Real& factor) {
  for (Real& c : s) c *= factor;
  return s;
}

/// t s(t), the last term dropped.
Series times_t(Series s) {
  std::rotate(s.begin(), s.end() - 1, s.end());
  s.front() = 0;
  return s;
}

/// The c_k of y = 1 − c_1 x − c_2 x² − ..., where x = x_1 t + ... and y = 1 + ... are series in t:
/// coefficient after coefficient, as one does by hand.
std::vector<double> eliminate(const Series& x, Series y) {
  std::vector<double> c;
  Series power = x;
  for (std::size_t k = 1; k < x.size(); ++k) {
    const Real factor = y[k] / power[k];
    // A coefficient that vanishes (Hertz: the inner ξ¹⁶ term) comes out as rounding of the 100 digits.
    c.push_back(abs(factor) < negligible ? 0.0 : static_cast<double>(-factor));
    for (std::size_t i = k; i < y.size(); ++i) y[i] -= factor * power[i];
    power = power * x;
  }
  return c;
}

/// c_1 x + c_2 x² + ...
double polynomial(const std::vector<double>& c, double x) {
  double sum = 0;
  for (auto k = c.rbegin(); k != c.rend(); ++k) sum = (sum + *k) * x;
  return sum;
}

}  // namespace

PlateSeries plate_series(double n, int terms) {
  if (!(n > -1 && n <= largest_exponent))
    throw std::invalid_argument("friction plate: -1 < n <= 100 is needed");
  if (terms < 1 || terms > most_terms)
    throw std::invalid_argument("friction plate: 1 to 40 terms are available");
  const auto count = static_cast<std::size_t>(terms) + 1;
  const Real half = Real(1) / 2;
  const Real m = n;
  const Real gammas = boost::math::tgamma(m + 2) / boost::math::tgamma(m + Real(5) / 2);
  const Real eta_max = boost::math::constants::root_pi<Real>() / 2 * gammas;  // (n+1) B(3/2, n+1)
  const Real slope = eta_max * (m + Real(3) / 2);                             // dξ/du at u = 0

  // ξ = slope u F(u²), η/η_max = G(u²)
  const Series f = hypergeometric(half, -half - m, 2, count);
  const Series g = hypergeometric(half, -Real(3) / 2 - m, 1, count);
  const std::vector<double> inner = eliminate(times_t(scaled(f * f, slope * slope)), g * g);

  // ξ = F(u⁻²), η = tail u⁻¹ G(u⁻²)
  const Real tail = 1 / (2 * (2 + m));
  const Series big_f = hypergeometric(half, -half, 2 + m, count);
  const Series big_g = hypergeometric(half, half, 3 + m, count);
  const std::vector<double> outer = eliminate(times_t(scaled(big_g * big_g, tail * tail)), big_f * big_f);

  const Real seam = (m + Real(3) / 2) * gammas * gammas;
  return {{1.0, static_cast<double>(eta_max)}, static_cast<double>(seam), inner, outer};
}

PlateSeries printed_uniform_plate() {
  return {.extent = {1.0, 2.0 / 3},
          .seam = 1 - 1.0 / 8 - 1.0 / 64,
          .inner = {3.0 / 2, -15.0 / 32, -5.0 / 128},
          .outer = {4.0, -20.0 / 3, 40.0 / 9}};
}

PlateSeries printed_hertz_plate() {
  const double seam = 9 * std::numbers::pi / 32;
  const double s = seam * seam;
  return {.extent = {1.0, 3 * std::numbers::pi / 16},  // from 9/64 (η/η*)² with η* = 9π/128
          .seam = seam,
          .inner = {9.0 / 8 / s, -243.0 / 1024 / (s * s), -9.0 / 32768 / (s * s * s)},
          .outer = {5.0, -75.0 / 7, 1250.0 / 147}};
}

double inner_side(const PlateSeries& plate, double xi, double eta) {
  const double h = eta / plate.extent.eta;
  return h * h + polynomial(plate.inner, xi * xi);
}

double outer_side(const PlateSeries& plate, double xi, double eta) {
  return xi * xi + polynomial(plate.outer, eta * eta);
}

double left_side(const PlateSeries& plate, double xi, double eta) {
  return xi <= plate.seam ? inner_side(plate, xi, eta) : outer_side(plate, xi, eta);
}

bool contains(const PlateSeries& plate, double xi, double eta) { return left_side(plate, xi, eta) <= 1; }

double inner_boundary_eta(const PlateSeries& plate, double xi) {
  if (!(xi >= 0 && xi <= 1)) throw std::domain_error("friction plate: 0 <= xi <= 1 is needed");
  // Far outside its range the inner piece can end before ξ = 1: no η is admissible there.
  return plate.extent.eta * std::sqrt(std::max(0.0, 1 - polynomial(plate.inner, xi * xi)));
}

double outer_boundary_eta(const PlateSeries& plate, double xi) {
  if (!(xi >= 0 && xi <= 1)) throw std::domain_error("friction plate: 0 <= xi <= 1 is needed");
  const double rest = (1 - xi) * (1 + xi);
  if (rest == 0) return 0;
  const auto excess = [&](double square) { return polynomial(plate.outer, square) - rest; };
  // Upwards in small steps from below, so that the first root is the one bracketed: the polynomial rises
  // monotonically as far as the seam, but may turn beyond it.
  const double step = rest / plate.outer.front() / 8;
  double low = 0;
  double high = step;
  constexpr double farthest = 4;  // η² is below 1 for every pressure
  while (excess(high) < 0) {
    low = high;
    high += step;
    if (high > farthest) return std::numeric_limits<double>::infinity();
  }
  std::uintmax_t iterations = 100;
  const auto [a, b] = boost::math::tools::toms748_solve(
      excess, low, high, boost::math::tools::eps_tolerance<double>(52), iterations);
  return std::sqrt(a + (b - a) / 2);
}

double boundary_eta(const PlateSeries& plate, double xi) {
  return xi <= plate.seam ? inner_boundary_eta(plate, xi) : outer_boundary_eta(plate, xi);
}

}  // namespace contensou
