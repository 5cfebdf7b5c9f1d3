#include "series_oracle.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <stdexcept>

namespace accuracy {
namespace {

/// ₂F₁(a, b; c; x) for |x| <= 1/4.
Quad gauss(const Quad& a, const Quad& b, const Quad& c, const Quad& x) {
  Quad sum = 1;
  Quad term = 1;
  for (int k = 0; abs(term) > abs(sum) * std::numeric_limits<Quad>::epsilon() / 16; ++k) {
    term *= (a + k) * (b + k) / ((c + k) * (k + 1)) * x;
    sum += term;
  }
  return sum;
}

}  // namespace

ReferenceRow series_oracle(double exponent, double u) {
  if (exponent != 0 && exponent != 0.5) throw std::invalid_argument("series oracle: n is 0 or 1/2");
  if (u > 0.5 && u < 2) throw std::invalid_argument("series oracle: u outside (1/2, 2)");
  const Quad n = exponent;
  const Quad half = 0.5;
  const Quad x = u;
  ReferenceRow row{};
  row.u = u;
  if (u < 1) {
    const Quad three_halves = 3 * half;
    // A = (n + 1) B(3/2, n + 1)
    const Quad a = exponent == 0 ? Quad(2) / 3 : 3 * boost::math::constants::pi<Quad>() / 16;
    const Quad m = x * x;
    row.phi = a * gauss(-half, -three_halves - n, 1, m) / sqrt(1 + m);
    row.xi = a * (three_halves + n) * x * gauss(half, -half - n, 2, m);
    row.eta = a * gauss(half, -three_halves - n, 1, m);
    row.second = a * (three_halves + n) * gauss(three_halves, -half - n, 2, m);
    return row;
  }
  const Quad m = 1 / (x * x);
  const Quad tail = 1 / (2 * (2 + n));
  row.phi = gauss(-half, -half, 2 + n, m) / sqrt(1 + m);
  row.xi = gauss(half, -half, 2 + n, m);
  row.eta = tail / x * gauss(half, half, 3 + n, m);
  row.second = tail / (x * x * x) * gauss(3 * half, half, 3 + n, m);
  return row;
}

std::vector<ReferenceRow> series_scan(double n, bool outwards) {
  constexpr int per_decade = 200;
  std::vector<ReferenceRow> rows;
  for (int k = 0;; ++k) {
    const double u = 2 * std::pow(10.0, static_cast<double>(k) / per_decade);
    if (u > 1e9) return rows;
    rows.push_back(series_oracle(n, outwards ? u : 1 / u));
  }
}

}  // namespace accuracy
