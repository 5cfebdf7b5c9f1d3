#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "checks.hpp"
#include "contensou/law/hertz.hpp"
#include "contensou/law/uniform.hpp"
#include "linearised.hpp"
#include "worst.hpp"

namespace verify::stability {
namespace {

using std::numbers::pi;

/// Of the linearisation: the law leaves 4·(3/64)u⁴ with u of some 1e-2 (uniform; nothing for Hertz, whose
/// force is cubic), rounding 1e-16/(3e-3 R/r) = 2e-11 for the smallest R, times the cancellation in a row.
constexpr double linear = 1e-8;
/// Of eigenvalues, relative to the largest: ten times that, for the eigenvectors are not orthogonal.
constexpr double spectral = 1e-7;
/// Of an order of magnitude p measured between R and R/10 where the next term is O(R): as in the ledger.
constexpr double order_bound = 0.01;

std::vector<Setting> settings(bool drilling) {
  std::vector<Setting> all;
  for (const std::size_t contact : {std::size_t{0}, std::size_t{1}}) {
    for (const Pressure pressure : {Pressure::uniform, Pressure::hertz}) {
      for (const double radius : {1e-5, 1e-4, 5e-4, 2e-3}) {
        Setting s = paper_top(contact);
        s.pressure = pressure;
        s.radius = radius;
        s.drilling = drilling;
        all.push_back(s);
      }
    }
  }
  return all;
}
constexpr double spins[] = {180, -180, 40};

double slope(const Setting& s) { return s.pressure == Pressure::hertz ? 3 * pi / 8 : 1; }
/// (5.25) with the slope of (5.23).
double epsilon(const Setting& s, double spin) {
  return s.mu * s.weight() * slope(s) / (std::abs(spin) * s.radius);
}

/// (5.26), for (ẋ_S, ẏ_S, α, β, α̇, β̇).
Matrix6 printed(const Setting& s, double spin, double e) {
  const double m = s.top.m, i1 = s.top.i1, i3 = s.top.i3, h = s.h(), r = s.r(), amg = s.a() * s.weight();
  Matrix6 j;
  j << -e / m, 0, -e * r * spin / m, 0, 0, e * h / m,                                       //
      0, -e / m, 0, -e * r * spin / m, -e * h / m, 0,                                       //
      0, 0, 0, 0, 1, 0,                                                                     //
      0, 0, 0, 0, 0, 1,                                                                     //
      0, -e * h / i1, -amg / i1, -e * r * h * spin / i1, -e * h * h / i1, -i3 * spin / i1,  //
      e * h / i1, 0, e * r * h * spin / i1, -amg / i1, i3 * spin / i1, -e * h * h / i1;
  return j;
}

/// Largest entry of the difference, velocities in rω and rates in ω, relative to its row.
double distance(const Setting& s, double spin, const Matrix6& expected, const Matrix6& obtained) {
  const double v = s.r() * std::abs(spin), w = std::abs(spin);
  const Eigen::Matrix<double, 6, 1> units{v, v, 1, 1, w, w};
  const Matrix6 size = (expected * units.asDiagonal()).cwiseAbs();
  const Matrix6 error = ((expected - obtained) * units.asDiagonal()).cwiseAbs();
  return error.rowwise().maxCoeff().cwiseQuotient(size.rowwise().maxCoeff()).maxCoeff();
}

double distance(const std::array<Complex, 3>& x, const std::array<Complex, 3>& y) {
  double largest = 0;
  double size = 0;
  for (const Complex& a : x) {
    double nearest = std::abs(a - y[0]);
    for (const Complex& b : y) nearest = std::min(nearest, std::abs(a - b));
    largest = std::max(largest, nearest);
    size = std::max(size, std::abs(a));
  }
  return largest / size;
}

/// The determinant (5.30) as printed.
Complex determinant(const Setting& s, double spin, double e, Complex x) {
  const Complex i(0, 1);
  const double h = s.h();
  return (s.top.m * x + e) * (s.top.i1 * x * x + (e * h * h - i * s.top.i3 * spin) * x + s.a() * s.weight() -
                              i * e * s.r() * h * spin) -
         (i * e * h * x + e * s.r() * spin) * (-i * e * h);
}

void linearisation(Record& record) {
  Worst matrix, defect, roots, drilled, slowing, cubic;
  for (const bool drilling : {false, true}) {
    for (const Setting& s : settings(drilling)) {
      for (const double spin : spins) {
        const Matrix6 j = jacobian(s, spin);
        const ComplexForm form = complex_form(j);
        const double torque =
            drilling ? (s.pressure == Pressure::hertz ? 3 * pi / 16 : 2.0 / 3) * s.mu * s.weight() * s.radius
                     : 0;
        const auto library = contensou::eigenvalues(
            contensou::characteristic_cubic(position(s), spin, damping(s, spin), torque));
        const double apart = distance(library, modes(form.matrix).eigenvalue);
        defect.add(form.defect);
        if (drilling) {
          drilled.add(apart);
          const double expected = -std::copysign(torque, spin) / s.top.i3;
          slowing.add(std::abs(spin_rate(s, spin) / expected - 1));
          continue;
        }
        roots.add(apart);
        matrix.add(distance(s, spin, printed(s, spin, epsilon(s, spin)), j));
        // det(λ − C)·mI_1 at points about the size of the roots, and (5.30) there.
        for (const Complex x : {Complex(30, 100), Complex(-200, -40), Complex(5, -300)}) {
          const Complex numeric = s.top.m * s.top.i1 * (x * Matrix3c::Identity() - form.matrix).determinant();
          cubic.add(std::abs(numeric - determinant(s, spin, epsilon(s, spin), x)) / std::abs(numeric));
        }
      }
    }
  }
  record.add(
      Claim{"stability.5.26", "LG03 (5.22), (5.26)",
            "the equations of motion for small deviations, with the slope 3pi/8 (Hertz), 1 (uniform), are "
            "the nonlinear top's linearised by differences, without drilling torque",
            0, matrix.value(), matrix.value(), linear, true});
  record.add(Claim{"stability.5.27", "LG03 (5.27), (5.28)",
                   "the linearised equations are complex ones in w and xi (also with drilling torque)", 0,
                   defect.value(), defect.value(), linear, true});
  record.add(Claim{"stability.5.30", "LG03 (5.30)",
                   "the determinant, at points of the plane, is that of the nonlinear top linearised", 0,
                   cubic.value(), cubic.value(), spectral, true});
  record.add(Claim{"stability.5.31.eigenvalues", "LG03 (5.31)",
                   "the library's roots are the eigenvalues of the nonlinear top linearised", 0,
                   roots.value(), roots.value(), spectral, true});
  record.add(Claim{"stability.drilling.eigenvalues", "LG03 (5.22), with the drilling torque",
                   "the library's roots with the drilling torque are the eigenvalues of the nonlinear top "
                   "linearised at the momentary spin",
                   0, drilled.value(), drilled.value(), spectral, true});
  record.add(Claim{"stability.drilling.spin", "LG03 (5.22), with the drilling torque",
                   "I_3 times the spin's rate is -(3pi/16) mu m g R (Hertz), -(2/3) mu m g R (uniform)", 0,
                   slowing.value(), slowing.value(), 1e-14, true});
}

/// The sixth equation, and λ_N, on small deviations.
void small_terms(Record& record) {
  Setting s = paper_top(0);
  const double spin_now = 180;
  const auto deviation = [](double x) { return Deviation{0.1 * x, 0.2 * x, x, -0.5 * x, 40 * x, 70 * x}; };
  const auto rates = [&](double x) {
    SlippingTop top(s);
    Eigen::VectorXd dy;
    const Eigen::VectorXd y = state(s, spin_now, deviation(x));
    top.derivative(0, y, dy);
    const double spin_change =
        s.up() * (dy.tail<3>().dot(y.segment<3>(3)) + y.tail<3>().dot(dy.segment<3>(3)));
    const Deviation d = deviation(x);
    const double printed = s.r() * (d.alpha * top.friction()[0] + d.beta * top.friction()[1]);
    return std::array{s.top.i3 * spin_change, printed, top.normal_force() / s.weight() - 1};
  };
  // Where u < 1/10 and the angles are some 1e-3: the order to an accuracy of their squares.
  const double x = 1e-3;
  const double normal = std::log10(std::abs(rates(x)[2] / rates(x / 10)[2]));
  record.add(Claim{"stability.5.22.normal_force", "LG03 (5.22), the sentence below",
                   "lambda_N/(mg) - 1 is of second order in the deviation (the text says first)", 2, normal,
                   std::abs(normal - 2), order_bound, true});
  s.drilling = false;
  const auto at = rates(x);
  record.add(Claim{"stability.5.22.spin", "LG03 (5.22), sixth equation, printed with the spin itself",
                   "I_3 times the rate of the spin is r(alpha lambda_T1 + beta lambda_T2), without drilling "
                   "torque, to second order",
                   at[1], at[0], std::abs(at[0] / at[1] - 1), 10 * x, true});
  record.add(Claim{"stability.5.22.spin.printed", "LG03 (5.22), sixth equation",
                   "I_3 times the spin is r(alpha lambda_T1 + beta lambda_T2), as printed", at[1],
                   s.top.i3 * spin_now, std::abs(s.top.i3 * spin_now / at[1] - 1), 10 * x, false});
}

void damping_of_slip(Record& record) {
  Worst force;
  for (int k = 1; k <= 64; ++k) {
    const double u = k / 64.0;
    const double expected = 3 * pi / 32 * u * (4 - u * u);
    force.add(std::abs(contensou::HertzLaw{}.at(u, 1).xi / expected - 1));
  }
  record.add(Claim{"stability.5.23", "LG03 (5.23)", "the friction force of the Hertz law, u <= 1", 0,
                   force.value(), force.value(), 2e-15, true});
  // The slope as the nonlinear top shows it: −m ∂v̇/∂v in units of μmg/(|ω|R).
  const Setting s = paper_top(0);
  const double unit = s.mu * s.weight() / (180 * s.radius);
  const double obtained = -s.top.m * jacobian(s, 180)(0, 0) / unit;
  const double printed = contensou::printed_initial_slope;
  record.add(Claim{"stability.5.24.printed", "LG03 (5.24), (5.25)",
                   "the force at small u falls with the slope 3/(8pi), as printed", printed, obtained,
                   std::abs(obtained / printed - 1), linear, false});
  record.add(Claim{"stability.5.24", "LG03 (5.24), (5.25)", "the force at small u falls with the slope 3pi/8",
                   3 * pi / 8, obtained, std::abs(obtained / (3 * pi / 8) - 1), linear, true});
  Worst library;
  for (const Setting& each : settings(false)) {
    for (const double spin : spins) library.add(std::abs(damping(each, spin) / epsilon(each, spin) - 1));
  }
  record.add(Claim{"stability.5.25", "LG03 (5.25)", "the library's epsilon is mu m g slope/(|omega| R)", 0,
                   library.value(), library.value(), 1e-13, true});
}

/// Where the largest real part changes sign, found without any closed form: by halving between two spins.
double crossing(const Setting& s, double low, double high) {
  const auto largest = [&](double spin) { return modes(linearised(s, spin)).eigenvalue[0].real(); };
  const bool sign = largest(low) > 0;
  if ((largest(high) > 0) == sign) return std::nan("");
  for (int k = 0; k < 44; ++k) {
    const double middle = (low + high) / 2;
    (((largest(middle) > 0) == sign) ? low : high) = middle;
  }
  return (low + high) / 2;
}

void boundary(Record& record) {
  Worst critical, frequency, margin, zero;
  for (const Setting& s : settings(false)) {
    const double found = crossing(s, 2, 170);
    critical.add(std::abs(found / contensou::critical_spin(position(s)).value() - 1));
    const Complex at = modes(linearised(s, found)).eigenvalue[0];
    frequency.add(std::abs(at.imag() / (s.r() * found / s.h()) - 1));
    margin.add(std::abs(contensou::stability_margin(position(s), found) / (s.a() * s.weight())));
    // λ = 0: the determinant there is ε·amg.
    const double e = epsilon(s, found);
    zero.add(std::abs(determinant(s, found, e, 0).real() / (e * s.a() * s.weight()) - 1));
  }
  // A relative error `spectral` of the eigenvalue over the change of the real part with the spin: of order
  // one.
  record.add(Claim{"stability.5.32", "LG03 (5.32)",
                   "where the nonlinear top, linearised, changes its stability, an eigenvalue is i r omega/h",
                   0, frequency.value(), frequency.value(), spectral, true});
  record.add(Claim{"stability.5.32.zero", "LG03 (5.32), the sentence below",
                   "lambda = 0 is no root: the determinant (5.30) there is epsilon a m g", 0, zero.value(),
                   zero.value(), 1e-12, true});
  record.add(Claim{"stability.5.33", "LG03 (5.33)", "there the left-hand side vanishes, in units of a m g", 0,
                   margin.value(), margin.value(), 10 * spectral, true});
  record.add(
      Claim{"stability.5.35", "LG03 (5.35)",
            "the critical spin, both positions, both pressures, R from 1e-5 to 2e-3 m: it does not depend "
            "on epsilon",
            0, critical.value(), critical.value(), spectral, true});
}

void rolling(Record& record) {
  Worst order, real_order;
  for (const std::size_t contact : {std::size_t{0}, std::size_t{1}}) {
    Setting s = paper_top(contact);
    s.drilling = false;
    const auto slow = contensou::rolling_eigenvalues(position(s), 180);
    const auto apart = [&](double radius) {
      s.radius = radius;
      const auto all = modes(linearised(s, 180)).eigenvalue;
      std::array<double, 4> d{};
      for (std::size_t k = 0; k < 2; ++k) {
        const Complex& x = std::abs(all[0] - slow[k]) < std::abs(all[1] - slow[k]) ? all[0] : all[1];
        d[k] = std::abs(x - slow[k]);
        d[k + 2] = std::abs(x.real());
      }
      return d;
    };
    const auto small = apart(1e-5), smaller = apart(1e-6);
    for (std::size_t k = 0; k < 2; ++k) {
      order.add(std::abs(std::log10(small[k] / smaller[k]) - 1));
      real_order.add(std::abs(std::log10(small[k + 2] / smaller[k + 2]) - 1));
    }
  }
  record.add(
      Claim{"stability.5.37", "LG03 (5.36), (5.37)",
            "two eigenvalues of the nonlinear top, linearised, tend to (5.37) with the first power of R", 0,
            order.value(), order.value(), order_bound, true});
  record.add(Claim{"stability.5.37.real", "LG03 5.5", "their real parts vanish with the first power of R", 0,
                   real_order.value(), real_order.value(), order_bound, true});
}

}  // namespace

contensou::SpinningPosition position(const Setting& s) {
  return {.m = s.top.m, .i1 = s.top.i1, .i3 = s.top.i3, .g = s.top.g, .a = s.a(), .r = s.r()};
}

double damping(const Setting& s, double spin) {
  const double steep = s.pressure == Pressure::hertz ? contensou::initial_slope(contensou::HertzLaw{})
                                                     : contensou::initial_slope(contensou::UniformLaw{});
  return contensou::slip_damping(position(s), {.mu = s.mu, .radius = s.radius, .slope = steep}, spin);
}

double drilling_torque(const Setting& s) {
  const double eta = s.pressure == Pressure::hertz ? contensou::HertzLaw{}.extent().eta
                                                   : contensou::UniformLaw{}.extent().eta;
  return eta * s.mu * s.weight() * s.radius;
}

void check_equations(Record& record) {
  linearisation(record);
  small_terms(record);
  damping_of_slip(record);
  boundary(record);
  rolling(record);
}

}  // namespace verify::stability
