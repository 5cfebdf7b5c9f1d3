#include "contensou/system/spinning_top_stability.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "contensou/law/hertz.hpp"
#include "contensou/law/power.hpp"
#include "contensou/law/uniform.hpp"

using namespace contensou;
using Complex = std::complex<double>;

namespace {

Complex value(const CharacteristicCubic& c, Complex x) { return ((c[3] * x + c[2]) * x + c[1]) * x + c[0]; }
/// What rounding may make of `value`.
double size(const CharacteristicCubic& c, Complex x) {
  double sum = 0;
  for (std::size_t k = 4; k-- > 0;) sum = sum * std::abs(x) + std::abs(c[k]);
  return sum;
}

struct Draw {
  std::mt19937_64 generator{20030517};
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(generator() >> 11) * 0x1p-53;
  }
};

/// Any top, in units of about its own mass, size and gravity, r > a.
SpinningPosition random_position(Draw& draw) {
  const double i1 = draw(0.05, 1);
  const double r = draw(0.2, 2);
  return {.m = draw(0.5, 2),
          .i1 = i1,
          .i3 = draw(0.05, 2) * i1,
          .g = draw(0.5, 2),
          .a = r - r * draw(0.05, 4),
          .r = r};
}

}  // namespace

TEST_CASE("Initial slopes of the friction force", "[system][stability]") {
  // A law: accurate to 1e-13 at worst (power).
  CHECK(initial_slope(UniformLaw{}) == Approx(1).epsilon(1e-14));
  CHECK(initial_slope(HertzLaw{}) == Approx(3 * std::numbers::pi / 8).epsilon(1e-14));
  for (const double n : {-0.5, 1.0, 3.3}) {
    CHECK(initial_slope(PowerLaw(n)) == Approx((n + 1) * std::beta(0.5, n + 1) / 2).epsilon(2e-13));
  }
  CHECK(printed_initial_slope == Approx(3 / (8 * std::numbers::pi)).epsilon(1e-15));
}

TEST_CASE("Damping of slow slip", "[system][stability]") {
  // By hand: 0.3 · 6e-3 · 9.81/(180 · 5e-4) = 0.017658/0.09.
  const SpinningPosition top = trivial_position({});
  CHECK(slip_damping(top, {.mu = 0.3, .radius = 5e-4, .slope = 1}, 180) == Approx(0.1962).epsilon(1e-14));
  CHECK(slip_damping(top, {.mu = 0.3, .radius = 5e-4, .slope = 1}, -180) == Approx(0.1962).epsilon(1e-14));
}

TEST_CASE("The cubic is the determinant (5.30)", "[system][stability]") {
  Draw draw;
  for (int k = 0; k < 100; ++k) {
    const SpinningPosition p = random_position(draw);
    const double omega = draw(-10, 10);
    const double e = draw(0, 5);
    const Complex x(draw(-5, 5), draw(-5, 5));
    const double h = p.h();
    const Complex i(0, 1);
    const Complex determinant = (p.m * x + e) * (p.i1 * x * x + (e * h * h - i * p.i3 * omega) * x +
                                                 p.a * p.m * p.g - i * e * p.r * h * omega) -
                                (i * e * h * x + e * p.r * omega) * (-i * e * h);
    const CharacteristicCubic cubic = characteristic_cubic(p, omega, e);
    // The determinant's ε² terms cancel: they are at most ε²h(h|x| + r|ω|).
    const double rounding = size(cubic, x) + e * e * h * (h * std::abs(x) + p.r * std::abs(omega));
    CHECK(std::abs(value(cubic, x) - determinant) < 1e-14 * rounding);
  }
}

TEST_CASE("Eigenvalues are the roots, in order", "[system][stability]") {
  const Complex known[] = {{2, -1}, {0.5, 3}, {-4, 0.25}};
  const CharacteristicCubic cubic{-known[0] * known[1] * known[2] * 2.0,
                                  (known[0] * known[1] + known[1] * known[2] + known[2] * known[0]) * 2.0,
                                  -(known[0] + known[1] + known[2]) * 2.0, 2};
  const auto roots = eigenvalues(cubic);
  for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(roots[k] - known[k]) < 1e-14);

  // From a radius of a nanometre to one of a metre, from a slow to a fast spin.
  for (const auto& top : {trivial_position({}), inverted_position({})}) {
    for (const double omega : {-180.0, 0.01, 1.0, 1e4}) {
      for (double radius = 1e-9; radius < 2; radius *= 10) {
        const double e = slip_damping(top, {.mu = 0.3, .radius = radius, .slope = 1}, omega);
        const CharacteristicCubic c = characteristic_cubic(top, omega, e);
        for (const Complex& x : eigenvalues(c)) CHECK(std::abs(value(c, x)) < 4e-15 * size(c, x));
      }
    }
  }
}

TEST_CASE("A top that spins the other way is its mirror image", "[system][stability]") {
  const SpinningPosition top = inverted_position({});
  for (const double drilling : {0.0, 1e-5}) {
    const auto right = eigenvalues(characteristic_cubic(top, 120, 0.3, drilling));
    const auto left = eigenvalues(characteristic_cubic(top, -120, 0.3, drilling));
    for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(left[k] - std::conj(right[k])) < 1e-12 * 241);
  }
}

TEST_CASE("Eigenvalues without a meaning are refused", "[system][stability]") {
  CHECK_THROWS_AS(eigenvalues({1, 1, 1, 0}), std::invalid_argument);
  CHECK_THROWS_AS(eigenvalues({1, std::numeric_limits<double>::infinity(), 1, 1}), std::invalid_argument);
  CHECK_THROWS_AS(eigenvalues({1, 1, std::nan(""), 1}), std::invalid_argument);
}

TEST_CASE("Pure rolling is the limit of a vanishing radius", "[system][stability]") {
  for (const auto& top : {trivial_position({}), inverted_position({})}) {
    for (const double omega : {180.0, -180.0, 30.0}) {
      const double a = top.i1 + top.m * top.h() * top.h();
      const double b = (top.i3 + top.m * top.h() * top.r) * omega;
      const Complex root = std::sqrt(Complex(b * b / (4 * a * a) + top.a * top.m * top.g / a));
      const auto rolling = rolling_eigenvalues(top, omega);
      // (5.37) as printed loses digits where the root nearly cancels B/2A: 1e-16 of B/2A.
      CHECK(std::abs(rolling[0] - Complex(0, 1) * (b / (2 * a) + root)) < 1e-15 * std::abs(b / a));
      CHECK(std::abs(rolling[1] - Complex(0, 1) * (b / (2 * a) - root)) < 1e-15 * std::abs(b / a));
      // The distance is O(R), about 2e5 R for this top at 180 rad/s.
      const double e = slip_damping(top, {.mu = 0.3, .radius = 1e-9, .slope = 1}, omega);
      const auto roots = eigenvalues(characteristic_cubic(top, omega, e));
      for (const Complex& x : rolling) {
        const double distance = std::min(std::abs(x - roots[0]), std::abs(x - roots[1]));
        CHECK(distance < 1e-3);
        CHECK(distance > 0);
      }
      CHECK(roots[2].real() < -1e6);
    }
  }
}

TEST_CASE("The sign of the margin is that of the largest real part, whatever the damping",
          "[system][stability]") {
  Draw draw;
  int stable = 0;
  for (int k = 0; k < 500; ++k) {
    const SpinningPosition p = random_position(draw);
    const double omega = draw(-6, 6);
    const double margin = stability_margin(p, omega);
    if (std::abs(margin) < 1e-3) continue;
    for (const double e : {0.05, 1.0, 20.0}) {
      CHECK((eigenvalues(characteristic_cubic(p, omega, e))[0].real() < 0) == (margin > 0));
    }
    stable += margin > 0;
  }
  CHECK(stable > 100);
  CHECK(stable < 400);
}

TEST_CASE("Regions and critical spins of the paper's top", "[system][stability]") {
  const SpinningPosition body = trivial_position({});
  CHECK(magnus_region(body) == MagnusRegion::iv);
  // amg = 0.003 · 6e-3 · 9.81 = 1.7658e-4, r/h = 1.25: ω_k² = 1.7658e-4/(1.25 · 8e-7 · 0.375).
  CHECK(critical_spin(body).value() == Approx(std::sqrt(470.88)).epsilon(1e-14));
  const SpinningPosition tip = inverted_position({});
  CHECK(magnus_region(tip) == MagnusRegion::ii);
  // amg = −9.4176e-4, r/h = 5/21: I₁(r/h)(I₃/I₁ − r/h) = 8e-7 · (5/21) · (107/168).
  CHECK(critical_spin(tip).value() ==
        Approx(std::sqrt(9.4176e-4 * 21 * 168 / (8e-7 * 5 * 107))).epsilon(1e-14));
  for (const auto& top : {body, tip}) {
    const double omega = critical_spin(top).value();
    CHECK(std::abs(stability_margin(top, omega)) < 1e-15 * std::abs(top.a * top.m * top.g) * 10);
    const CharacteristicCubic cubic = characteristic_cubic(top, omega, 0.2);
    const Complex crossing(0, top.r * omega / top.h());
    CHECK(std::abs(value(cubic, crossing)) < 1e-14 * size(cubic, crossing));
  }
}

TEST_CASE("Regions and their borders", "[system][stability]") {
  CHECK(magnus_region(1.5, 0.5) == MagnusRegion::i);
  CHECK(magnus_region(1.5, 0.75) == MagnusRegion::ii);
  CHECK(magnus_region(0.75, 1.5) == MagnusRegion::iii);
  CHECK(magnus_region(0.5, 0.5) == MagnusRegion::iv);
  CHECK(magnus_region(1.0, 0.5) == MagnusRegion::none);
  CHECK(magnus_region(2.0, 0.5) == MagnusRegion::none);
  const SpinningPosition ball{.m = 1, .i1 = 0.4, .i3 = 0.4, .g = 1, .a = 0, .r = 1};
  CHECK(!critical_spin(ball));
  const SpinningPosition third{.m = 1, .i1 = 1, .i3 = 1.75, .g = 1, .a = 0.25, .r = 1};
  CHECK(magnus_region(third) == MagnusRegion::iii);
  CHECK(!critical_spin(third));
  CHECK(std::string(name(MagnusRegion::iv)) == "IV");
  CHECK(std::string(name(MagnusRegion::none)) == "none");
}

TEST_CASE("The drilling torque across the inclined axis", "[system][stability]") {
  // For R → 0 the rolling roots move by −T/(2Aν − B)·sgn ω, the damping of the slip at the same order.
  const SpinningPosition top = trivial_position({});
  const double omega = 180;
  const double torque = 1e-9;
  const double e = 1e6;
  const double a = top.i1 + top.m * top.h() * top.h();
  const double b = (top.i3 + top.m * top.h() * top.r) * omega;
  const double nu = rolling_eigenvalues(top, omega)[1].imag();
  const double with = eigenvalues(characteristic_cubic(top, omega, e, torque))[1].real();
  const double without = eigenvalues(characteristic_cubic(top, omega, e))[1].real();
  // Second order in T: (T/B)²·A/B, and rounding 1e-16 of 193 1/s.
  CHECK(with - without == Approx(-torque / (2 * a * nu - b)).margin(1e-12));
}
