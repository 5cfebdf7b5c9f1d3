#include "elimination.hpp"

#include <algorithm>

namespace verify::ledger {
namespace {

/// (2/π) ∫_0^{π/2} sin^{2k} = C(2k, k)/4^k.
Rational wallis(unsigned k) {
  Rational w = 1;
  for (unsigned i = 1; i <= k; ++i) w *= Rational(2 * i - 1, 2 * i);
  return w;
}

Rational alternating(unsigned k) { return k % 2 == 0 ? 1 : -1; }

PowerSeries operator*(const PowerSeries& p, const PowerSeries& q) {
  PowerSeries r(p.size(), Rational(0));
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; i + j < p.size(); ++j) r[i + j] += p[i] * q[j];
  }
  return r;
}

PowerSeries times_t(PowerSeries s) {
  std::rotate(s.begin(), s.end() - 1, s.end());
  s.front() = 0;
  return s;
}

template <class Term>
PowerSeries tabulate(std::size_t count, Term term) {
  PowerSeries s;
  for (unsigned k = 0; k < count; ++k) s.push_back(term(k));
  return s;
}

}  // namespace

Rational binomial(const Rational& a, unsigned k) {
  Rational b = 1;
  for (unsigned i = 0; i < k; ++i) b *= (a - Rational(i)) / Rational(i + 1);
  return b;
}

LawSeries uniform_inner(std::size_t count) {
  // ξ = (4u/π) ∫cos²θ √(1 − u² sin²θ), η = 4/(3π) ∫(1 − u² sin²θ)^{3/2}
  return {tabulate(count,
                   [](unsigned k) -> Rational {
                     return 2 * binomial(Rational(1, 2), k) * alternating(k) * (wallis(k) - wallis(k + 1));
                   }),
          tabulate(count, [](unsigned k) -> Rational {
            return Rational(2, 3) * binomial(Rational(3, 2), k) * alternating(k) * wallis(k);
          })};
}

LawSeries uniform_outer(std::size_t count) {
  // ξ = (4/π) ∫√(1 − w² sin²ψ) cos²ψ, η = 4w/(3π) ∫cos⁴ψ/√(1 − w² sin²ψ)
  return {tabulate(count,
                   [](unsigned k) -> Rational {
                     return 2 * binomial(Rational(1, 2), k) * alternating(k) * (wallis(k) - wallis(k + 1));
                   }),
          tabulate(count, [](unsigned k) -> Rational {
            return Rational(2, 3) * binomial(Rational(-1, 2), k) * alternating(k) *
                   (wallis(k) - 2 * wallis(k + 1) + wallis(k + 2));
          })};
}

LawSeries hertz_inner(std::size_t count) {
  // ξ = (3u/2) ∫cos²θ (1 − u² sin²θ), η = (3/8) ∫(1 − u² sin²θ)²; the Wallis integrals carry π/2
  // ξ/ξ* = (3/2)(π/2)/(9π/32) u (...) = (8/3) u (...),  η/η_max = (3/8)(π/2)/(3π/16) (...) = (...)
  return {
      tabulate(count,
               [](unsigned k) -> Rational {
                 return Rational(8, 3) * binomial(1, k) * alternating(k) * (wallis(k) - wallis(k + 1));
               }),
      tabulate(count, [](unsigned k) -> Rational { return binomial(2, k) * alternating(k) * wallis(k); })};
}

LawSeries hertz_outer(std::size_t count) {
  // ξ = (3/2) ∫√(1 − w² sin²ψ) cos³ψ, η = (3/8) w ∫cos⁵ψ/√(1 −
  // w² sin²ψ); with s = sin ψ these are integrals of powers of s
  return {tabulate(count,
                   [](unsigned k) -> Rational {
                     return Rational(3, 2) * binomial(Rational(1, 2), k) * alternating(k) *
                            (Rational(1, 2 * k + 1) - Rational(1, 2 * k + 3));
                   }),
          tabulate(count, [](unsigned k) -> Rational {
            return Rational(3, 8) * binomial(Rational(-1, 2), k) * alternating(k) *
                   (Rational(1, 2 * k + 1) - Rational(2, 2 * k + 3) + Rational(1, 2 * k + 5));
          })};
}

PowerSeries potential_series(const LawSeries& law, bool inner) {
  // inner: u·uX + Y; outer: u X + Y/u = u (X + t Y)
  PowerSeries f = inner ? times_t(law.xi) : times_t(law.eta);
  const PowerSeries& other = inner ? law.eta : law.xi;
  for (std::size_t k = 0; k < f.size(); ++k) f[k] += other[k];
  return f;
}

PowerSeries eliminate(const PowerSeries& x, PowerSeries y) {
  PowerSeries c;
  PowerSeries power = x;
  for (std::size_t k = 1; k < x.size(); ++k) {
    const Rational factor = y[k] / power[k];
    c.push_back(-factor);
    for (std::size_t i = k; i < y.size(); ++i) y[i] -= factor * power[i];
    power = power * x;
  }
  return c;
}

PowerSeries plate_inner(const LawSeries& law) {
  PowerSeries eta = law.eta;
  for (Rational& c : eta) c /= law.eta.front();
  return eliminate(times_t(law.xi * law.xi), eta * eta);
}

PowerSeries plate_outer(const LawSeries& law) {
  return eliminate(times_t(law.eta * law.eta), law.xi * law.xi);
}

std::string text(const PowerSeries& series) {
  std::string joined;
  for (const Rational& c : series) joined += (joined.empty() ? "" : ", ") + c.str();
  return joined;
}

}  // namespace verify::ledger
