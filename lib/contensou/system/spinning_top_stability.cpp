#include "contensou/system/spinning_top_stability.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace contensou {
namespace {

using Complex = std::complex<double>;

/// One step of Newton's method, where it is defined.
Complex polished(const CharacteristicCubic& c, Complex x) {
  const Complex value = ((c[3] * x + c[2]) * x + c[1]) * x + c[0];
  const Complex slope = (3.0 * c[3] * x + 2.0 * c[2]) * x + c[1];
  return slope == 0.0 ? x : x - value / slope;
}

/// I₁(r/h)(I₃/I₁ − r/h), what ω² is multiplied with in (5.33).
double spin_stiffness(const SpinningPosition& p) {
  const double ratio = p.r / p.h();
  return ratio * (p.i3 - p.i1 * ratio);
}

}  // namespace

SpinningPosition trivial_position(const TippeTopData& top) {
  return {.m = top.m, .i1 = top.i1, .i3 = top.i3, .g = top.g, .a = top.a1, .r = top.r1};
}

SpinningPosition inverted_position(const TippeTopData& top) {
  return {.m = top.m, .i1 = top.i1, .i3 = top.i3, .g = top.g, .a = -top.a2, .r = top.r2};
}

double slip_damping(const SpinningPosition& position, const SlowSlip& contact, double omega) {
  return contact.mu * position.m * position.g * contact.slope / (std::abs(omega) * contact.radius);
}

CharacteristicCubic characteristic_cubic(const SpinningPosition& p, double omega, double epsilon,
                                         double drilling) {
  const double h = p.h();
  const Complex spring(p.a * p.m * p.g, std::copysign(drilling, omega));
  return {epsilon * spring, p.m * spring - Complex(0, epsilon * (p.i3 + p.m * h * p.r) * omega),
          Complex(epsilon * (p.i1 + p.m * h * h), -p.m * p.i3 * omega), p.m * p.i1};
}

std::array<Complex, 3> eigenvalues(const CharacteristicCubic& cubic) {
  for (const Complex& c : cubic) {
    if (!std::isfinite(c.real()) || !std::isfinite(c.imag()))
      throw std::invalid_argument("eigenvalues: a coefficient is not finite");
  }
  if (cubic[3] == 0.0) throw std::invalid_argument("eigenvalues: the leading coefficient is zero");
  Eigen::Matrix3cd companion = Eigen::Matrix3cd::Zero();
  companion(1, 0) = companion(2, 1) = 1;
  for (int i = 0; i < 3; ++i) companion(i, 2) = -cubic[static_cast<std::size_t>(i)] / cubic[3];
  const Eigen::ComplexEigenSolver<Eigen::Matrix3cd> solver(companion, false);
  std::array<Complex, 3> roots;
  // The companion's entries differ by powers of 1/s, which costs the small roots digits: two steps of Newton
  // give them back.
  for (int i = 0; i < 3; ++i) {
    roots[static_cast<std::size_t>(i)] = polished(cubic, polished(cubic, solver.eigenvalues()[i]));
  }
  std::sort(roots.begin(), roots.end(),
            [](const Complex& x, const Complex& y) { return x.real() > y.real(); });
  return roots;
}

std::array<Complex, 2> rolling_eigenvalues(const SpinningPosition& p, double omega) {
  const double a = p.i1 + p.m * p.h() * p.h();
  const double half_b = (p.i3 + p.m * p.h() * p.r) * omega / 2;
  const double c = p.a * p.m * p.g;
  // λ = iν, aν² − 2 half_b ν − c = 0; the root of larger size first, the other from the product −c/a.
  const Complex root = std::sqrt(Complex(half_b * half_b + a * c));
  const Complex large = (half_b + (half_b < 0 ? -root : root)) / a;
  const Complex small = large == 0.0 ? 0.0 : -c / a / large;
  const Complex i(0, 1);
  return half_b < 0 ? std::array{i * small, i * large} : std::array{i * large, i * small};
}

double stability_margin(const SpinningPosition& p, double omega) {
  return spin_stiffness(p) * omega * omega + p.a * p.m * p.g;
}

const char* name(MagnusRegion region) {
  switch (region) {
    case MagnusRegion::i:
      return "I";
    case MagnusRegion::ii:
      return "II";
    case MagnusRegion::iii:
      return "III";
    case MagnusRegion::iv:
      return "IV";
    case MagnusRegion::none:
      break;
  }
  return "none";
}

MagnusRegion magnus_region(double h_over_r, double i3_over_i1) {
  const double product = h_over_r * i3_over_i1;  // > 1 beyond the hyperbola
  if (h_over_r == 1 || product == 1) return MagnusRegion::none;
  if (h_over_r > 1) return product < 1 ? MagnusRegion::i : MagnusRegion::ii;
  return product > 1 ? MagnusRegion::iii : MagnusRegion::iv;
}

MagnusRegion magnus_region(const SpinningPosition& p) { return magnus_region(p.h() / p.r, p.i3 / p.i1); }

std::optional<double> critical_spin(const SpinningPosition& p) {
  const MagnusRegion region = magnus_region(p);
  if (region != MagnusRegion::ii && region != MagnusRegion::iv) return {};
  return std::sqrt(-p.a * p.m * p.g / spin_stiffness(p));
}

}  // namespace contensou
