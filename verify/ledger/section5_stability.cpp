// LG03 Section 5.5, (5.22) to (5.37) and Fig. 11: the stability of a top that spins upright. The motion of a
// rigid body by differences of its angular momentum, polynomials by their roots, all in 50 digits, SI units.

#include <algorithm>
#include <array>
#include <boost/multiprecision/complex_adaptor.hpp>
#include <cmath>

#include "oracle.hpp"

namespace verify::ledger {
namespace {

using Complex = boost::multiprecision::number<
    boost::multiprecision::complex_adaptor<boost::multiprecision::cpp_bin_float<50>>,
    boost::multiprecision::et_off>;
using Vector = std::array<Real, 3>;

const Complex i(0, 1);

/// A top on one of its spheres, LG03 5.5; the data are those of 5.4.
struct Top {
  Real m = ratio(6, 1000);
  Real i1 = Real("8e-7");
  Real i3 = Real("7e-7");
  Real g = ratio(981, 100);
  Real a = ratio(3, 1000);
  Real r = ratio(15, 1000);

  Real h() const { return r - a; }
  Real amg() const { return a * m * g; }
};
Top on_body() { return {}; }
Top on_tip() {
  Top t;
  t.a = -ratio(16, 1000);
  t.r = ratio(5, 1000);
  return t;
}
const Real paper_spin = 180;
const Real mu = ratio(3, 10);
const Real paper_radius = Real("5e-4");

/// (5.25) with the slope of (5.23).
Real epsilon(const Top& t, const Real& spin, const Real& radius) {
  return mu * t.m * t.g * 3 * pi() / 8 / (abs(spin) * radius);
}

Vector operator+(const Vector& x, const Vector& y) { return {x[0] + y[0], x[1] + y[1], x[2] + y[2]}; }
Vector operator*(const Real& c, const Vector& x) { return {c * x[0], c * x[1], c * x[2]}; }
Real dot(const Vector& x, const Vector& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }
Vector cross(const Vector& x, const Vector& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

/// Five-point derivative in 50 digits: h⁴ = 1e-40 and 1e-50/h.
template <class F>
auto derivative(const F& f) {
  const Real h = Real("1e-10");
  return 1 / (12 * h) * (8 * f(h) + Real(-8) * f(-h) + f(-2 * h) + Real(-1) * f(2 * h));
}
/// Of that, relative.
constexpr double differenced50 = 1e-30;

/// A small motion about spinning upright in Cardan angles, all of its numbers times η: α(t) and so on to the
/// second order in t, γ̇ not small.
struct Motion {
  Real eta;
  Vector alpha{ratio(7, 10), 30, 4000};  ///< α, α̇, α̈
  Vector beta{-ratio(4, 10), 50, -2500};
  Real gamma_rate = 180;
  Real gamma_acceleration = 5;  ///< times η²

  static Real along(const Vector& x, const Real& t) { return x[0] + t * x[1] + t * t / 2 * x[2]; }
  Vector axis(const Real& t) const {
    const Real x = eta * along(alpha, t), y = eta * along(beta, t);
    return {sin(y), -sin(x) * cos(y), cos(x) * cos(y)};
  }
  /// Turns α about the first axis of the floor, β about the second one so turned, γ about the axis.
  Vector spin(const Real& t) const {
    const Real x = eta * along(alpha, t);
    const Vector first{eta * (alpha[1] + t * alpha[2]), 0, 0};
    const Real second = eta * (beta[1] + t * beta[2]);
    return first + second * Vector{0, cos(x), sin(x)} +
           (gamma_rate + t * eta * eta * gamma_acceleration) * axis(t);
  }
  /// About the centre of mass, in the floor's axes.
  Vector angular_momentum(const Top& top, const Real& t) const {
    const Vector n = axis(t), omega = spin(t);
    return top.i1 * omega + (top.i3 - top.i1) * dot(omega, n) * n;
  }
  Vector arm(const Top& top) const { return top.a * axis(0) + Vector{0, 0, -top.r}; }
};

/// λ_T, of first order, and λ_N.
const Vector force{Real("3e-2"), Real("-2e-2"), Real("6e-2")};
Vector force_at(const Real& eta) { return {eta * force[0], eta * force[1], force[2]}; }

/// What is left of L̇ − s × λ after the fourth, fifth or sixth equation of (5.22) is taken off.
Real remainder(const Top& top, int equation, const Real& eta, bool as_printed = false) {
  const Motion x{.eta = eta};
  const Vector lambda = force_at(eta);
  const Vector rate = derivative([&](const Real& t) { return x.angular_momentum(top, t); });
  const Vector left = rate + Real(-1) * cross(x.arm(top), lambda);
  const Real alpha = eta * x.alpha[0], beta = eta * x.beta[0];
  if (equation == 4) {
    return left[0] - (top.i1 * eta * x.alpha[2] + top.i3 * x.gamma_rate * eta * x.beta[1] +
                      top.a * alpha * lambda[2] - top.h() * lambda[1]);
  }
  if (equation == 5) {
    return left[1] - (top.i1 * eta * x.beta[2] - top.i3 * x.gamma_rate * eta * x.alpha[1] +
                      top.a * beta * lambda[2] + top.h() * lambda[0]);
  }
  const Real turning = as_printed ? x.gamma_rate : Real(eta * eta * x.gamma_acceleration);
  return dot(left, x.axis(0)) - (top.i3 * turning - top.r * (alpha * lambda[0] + beta * lambda[1]));
}

Finding equations_of_motion() {
  const auto sixth = [](bool as_printed) {
    return order([=](const Real& eta) { return remainder(on_body(), 6, eta, as_printed); }, 2);
  };
  std::vector<Trial> corrected{sixth(false)};
  for (const Top& top : {on_body(), on_tip()}) {
    for (const int equation : {4, 5})
      corrected.push_back(order([&](const Real& eta) { return remainder(top, equation, eta); }, 3));
  }
  return {
      sixth(true), worst(corrected), order_bound,
      "A small motion in Cardan angles, its angular momentum differentiated, less the moment of λ: what the "
      "equations leave falls with the powers " +
          text(corrected[1].obtained, 4) + " (α), " + text(corrected[2].obtained, 4) + " (β), " +
          text(corrected[0].obtained, 4) + " (γ) of η; with I_3γ̇ for I_3γ̈ with the power " +
          text(sixth(true).obtained, 2)};
}

Finding left_out_torque() {
  // The torque about the vertical by the definition (2.1): τ_N ω = Φ at v = 0.
  Contact c;
  c.v = 0;
  const Real torque = Real(potential_by_definition(Pressure::hertz, c)) / c.omega;
  const Real unit = Real(c.mu) * c.lambda_n * c.radius;
  const Top t;
  const Real slowing = 3 * pi() / 16 * mu * t.m * t.g * paper_radius / t.i3;
  return {absolute(0, torque / unit), relative(torque, 3 * pi() / 16 * unit), nested,
          "The torque at v = 0 by the definition is " + text(torque / unit, 7) +
              " μλ_N R: not of order η², nor small against ελ-terms, which are of order R as well; γ̈ = −" +
              text(slowing, 4) + " rad/s² for the paper's top"};
}

Finding normal_motion() {
  const Top top;
  const Trial t = order(
      [&](const Real& eta) -> Real {
        const Motion x{.eta = eta};
        const auto rate = [&](const Real& at) {
          return derivative([&](const Real& s) -> Real { return -top.a * x.axis(at + s)[2]; });
        };
        return derivative(rate);
      },
      2);
  return {at_most_zero(Real(1 - t.obtained)),
          {},
          order_bound,
          "z_S = r − a cosα cosβ, differentiated twice: z̈_S falls with the power " + text(t.obtained, 5) +
              " of η"};
}

Finding largest_height() {
  const auto above = [](const Top& t) -> Real { return t.r - t.a * cos(ratio(1, 10)) - t.h(); };
  return {at_most_zero(above(on_body())),
          worst({at_most_zero(above(on_tip())), at_most_zero(-above(on_body()))}), 0,
          "z_S = r − a cosθ at θ = 0.1: on the body " + text(above(on_body()) * 1e6, 3) +
              " µm above h, on the tip " + text(-above(on_tip()) * 1e6, 3) + " µm below"};
}

Finding friction_force() {
  std::vector<Trial> trials;
  for (int k = 1; k <= 10; ++k) {
    const Real u = ratio(k, 10);
    trials.push_back(relative(exact(Pressure::hertz, u).xi, 3 * pi() / 32 * u * (4 - u * u)));
  }
  const Trial t = worst(trials);
  return {t,
          {},
          digits50,
          "Against the reduced integral of the Hertz pressure, u = 0.1 ... 1: " + text(t.error, 2)};
}

/// −λ_T/v in units of μλ_N/(|ω|R) where u = 1e-12, and the cubic term 1e-24/4.
Real measured_slope() { return exact(Pressure::hertz, Real("1e-12")).xi / Real("1e-12"); }
constexpr double slow = 1e-23;

Finding slope() {
  return {relative(measured_slope(), 3 / (8 * pi())), relative(measured_slope(), 3 * pi() / 8), slow,
          "ξ/u at u = 1e-12 is " + text(measured_slope(), 10) + "; 3/(8π) = " + text(3 / (8 * pi()), 6) +
              ", 3π/8 = " + text(3 * pi() / 8, 10)};
}

Finding damping() {
  const Top t;
  std::vector<Trial> printed, corrected;
  for (const Real& spin : {paper_spin, Real(-paper_spin)}) {
    const Real value = mu * t.m * t.g * measured_slope() / (abs(spin) * paper_radius);
    printed.push_back(relative(value, mu * t.m * t.g * 3 / (8 * pi()) / (spin * paper_radius)));
    corrected.push_back(relative(value, epsilon(t, spin, paper_radius)));
  }
  return {worst(printed), worst(corrected), slow,
          "The paper's top: −λ_T/v at u = 1e-12 is " + text(epsilon(t, paper_spin, paper_radius), 5) +
              " N s/m for ω = ±180 rad/s; as printed ±" +
              text(mu * t.m * t.g * 3 / (8 * pi()) / (paper_spin * paper_radius), 5)};
}

/// Numbers of no meaning for (v_x, v_y), (α, β), (α̇, β̇).
struct Deviation {
  std::array<Real, 2> v{ratio(3, 10), -ratio(7, 10)}, angle{ratio(2, 10), ratio(9, 10)}, rate{-40, 65};
  Deviation turned() const { return {{-v[1], v[0]}, {-angle[1], angle[0]}, {-rate[1], rate[0]}}; }
};
/// v̇_x, v̇_y, α̈, β̈ of (5.26).
std::array<Real, 4> reduced(const Top& t, const Real& w, const Real& e, const Deviation& d) {
  const Real h = t.h();
  const auto& [vx, vy] = d.v;
  const auto& [alpha, beta] = d.angle;
  const auto& [da, db] = d.rate;
  return {-e * (vx - h * db + t.r * w * alpha) / t.m, -e * (vy + h * da + t.r * w * beta) / t.m,
          -(e * h * h * da + t.amg() * alpha + t.i3 * w * db + e * t.r * h * w * beta + e * h * vy) / t.i1,
          -(e * h * h * db + t.amg() * beta - t.i3 * w * da - e * t.r * h * w * alpha - e * h * vx) / t.i1};
}

Finding reduced_equations() {
  std::vector<Trial> trials;
  for (const Top& top : {on_body(), on_tip()}) {
    const Deviation d;
    const Real e = epsilon(top, paper_spin, paper_radius);
    // γ_T = v_S + ω × s to first order.
    const auto slip = [&](const Real& eta) {
      Motion x{.eta = eta};
      x.alpha = {d.angle[0], d.rate[0], 0};
      x.beta = {d.angle[1], d.rate[1], 0};
      x.gamma_rate = paper_spin;
      return eta * Vector{d.v[0], d.v[1], 0} + cross(x.spin(0), x.arm(top));
    };
    const Vector gamma = derivative(slip);
    const Real l1 = -e * gamma[0], l2 = -e * gamma[1], weight = top.m * top.g;
    const std::array<Real, 4> expected{
        l1 / top.m, l2 / top.m,
        (-top.a * d.angle[0] * weight + top.h() * l2 - top.i3 * paper_spin * d.rate[1]) / top.i1,
        (-top.a * d.angle[1] * weight - top.h() * l1 + top.i3 * paper_spin * d.rate[0]) / top.i1};
    const auto printed = reduced(top, paper_spin, e, d);
    for (std::size_t k = 0; k < 4; ++k) trials.push_back(relative(expected[k], printed[k]));
  }
  const Trial t = worst(trials);
  return {t,
          {},
          differenced50,
          "(5.22) with λ_N = mg, λ_T = −εγ_T, γ_T = v_S + ω × s to first order, body and tip: " +
              text(t.error, 2)};
}

Finding complex_variables() {
  std::vector<Trial> trials;
  for (const Top& top : {on_body(), on_tip()}) {
    const Real e = epsilon(top, paper_spin, paper_radius);
    const auto x = reduced(top, paper_spin, e, {});
    const auto y = reduced(top, paper_spin, e, Deviation{}.turned());
    for (const std::size_t k : {std::size_t{0}, std::size_t{2}}) {
      trials.push_back(relative(-x[k + 1], y[k]));
      trials.push_back(relative(x[k], y[k + 1]));
    }
  }
  const Trial t = worst(trials);
  return {
      t,
      {},
      digits50,
      "A deviation turned by π/2, w → iw, ξ → iξ, has its accelerations turned by π/2: " + text(t.error, 2)};
}

/// ẇ and ξ̈ of (5.28).
std::array<Complex, 2> complex_system(const Top& t, const Real& omega, const Real& e, const Complex& w,
                                      const Complex& xi, const Complex& rate) {
  const Real h = t.h();
  return {-e / t.m * (w + i * h * rate + t.r * omega * xi),
          -1 / t.i1 *
              (e * h * h * rate + t.amg() * xi - i * t.i3 * omega * rate - i * e * t.r * h * omega * xi -
               i * e * h * w)};
}

Trial relative(const Complex& expected, const Complex& obtained) {
  return absolute(0, Real(abs(obtained - expected)) / Real(abs(expected)));
}

Finding complex_equations() {
  std::vector<Trial> trials;
  for (const Top& top : {on_body(), on_tip()}) {
    const Real e = epsilon(top, paper_spin, paper_radius);
    const Deviation d;
    const auto real = reduced(top, paper_spin, e, d);
    const auto complex = complex_system(top, paper_spin, e, Complex(d.v[0], d.v[1]),
                                        Complex(d.angle[0], d.angle[1]), Complex(d.rate[0], d.rate[1]));
    trials.push_back(relative(Complex(real[0], real[1]), complex[0]));
    trials.push_back(relative(Complex(real[2], real[3]), complex[1]));
  }
  const Trial t = worst(trials);
  return {t, {}, digits50, "Against (5.26), body and tip: " + text(t.error, 2)};
}

/// The left-hand side of (5.31), constant term first.
using Cubic = std::array<Complex, 4>;
Cubic cubic(const Top& t, const Real& omega, const Real& e) {
  const Real h = t.h();
  return {e * t.amg(), t.m * t.amg() - i * e * (t.i3 + t.m * h * t.r) * omega,
          e * (t.i1 + t.m * h * h) - i * t.m * t.i3 * omega, t.m * t.i1};
}
Complex value(const Cubic& c, const Complex& x) { return ((c[3] * x + c[2]) * x + c[1]) * x + c[0]; }
/// The roots by simultaneous iteration (Durand and Kerner), to rounding, in descending order of real part.
std::array<Complex, 3> roots(const Cubic& c) {
  const Real size = 1 + Real(abs(c[2] / c[3])) + sqrt(Real(abs(c[1] / c[3])));
  const Complex seed(ratio(4, 10), ratio(9, 10));
  std::array<Complex, 3> x{size * seed, size * seed * seed, size * seed * seed * seed};
  for (int pass = 0; pass < 400; ++pass) {
    Real change = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Complex step = value(c, x[k]) / (c[3] * (x[k] - x[(k + 1) % 3]) * (x[k] - x[(k + 2) % 3]));
      x[k] -= step;
      change = std::max(change, Real(abs(step) / abs(x[k])));
    }
    if (change < Real("1e-44")) break;
  }
  std::sort(x.begin(), x.end(), [](const Complex& y, const Complex& z) { return y.real() > z.real(); });
  return x;
}
/// Roots far apart, to 50 digits less the cancellation of their values.
constexpr double by_roots = 1e-30;

Real largest(const Top& t, const Real& spin, const Real& e) { return roots(cubic(t, spin, e))[0].real(); }

Finding ansatz() {
  std::vector<Trial> trials;
  const Top top;
  const Real e = epsilon(top, paper_spin, paper_radius);
  for (const Complex& x : roots(cubic(top, paper_spin, e))) {
    // Ξ = 1, W from the first equation; ẇ and ξ̈ differentiated.
    const Complex w = -(i * e * top.h() * x + e * top.r * paper_spin) / (top.m * x + e);
    const Real start = ratio(1, 100);
    const auto motion = [&](const Complex& amplitude) {
      return derivative([&](const Real& t) -> Complex { return amplitude * exp(x * Complex(start + t)); });
    };
    const Complex now = exp(x * Complex(start));
    const auto system = complex_system(top, paper_spin, e, w * now, now, x * now);
    trials.push_back(relative(motion(w), system[0]));
    trials.push_back(relative(motion(x), system[1]));
  }
  const Trial t = worst(trials);
  return {t,
          {},
          1e-25,
          "With each of the three roots, differentiated in t, they solve (5.28) at t = 0.01 s: " +
              text(t.error, 2)};
}

/// (5.30).
std::array<Complex, 4> matrix(const Top& t, const Real& omega, const Real& e, const Complex& x) {
  const Real h = t.h();
  return {t.m * x + e, i * e * h * x + e * t.r * omega, -i * e * h,
          t.i1 * x * x + (e * h * h - i * t.i3 * omega) * x + t.amg() - i * e * t.r * h * omega};
}

const std::array<Complex, 3> places{Complex(30, 100), Complex(-200, -40), Complex(5, -300)};

Finding characteristic_matrix() {
  std::vector<Trial> trials;
  for (const Top& top : {on_body(), on_tip()}) {
    const Real e = epsilon(top, paper_spin, paper_radius);
    for (const Complex& x : places) {
      const Complex w(ratio(3, 10), 2), xi(-1, ratio(7, 10));
      const auto system = complex_system(top, paper_spin, e, w, xi, x * xi);
      const auto a = matrix(top, paper_spin, e, x);
      trials.push_back(relative(top.m * (x * w - system[0]), a[0] * w + a[1] * xi));
      trials.push_back(relative(top.i1 * (x * x * xi - system[1]), a[2] * w + a[3] * xi));
    }
  }
  const Trial t = worst(trials);
  return {t, {}, digits50, "The matrix times (W, Ξ) against (5.28) with the ansatz: " + text(t.error, 2)};
}

Finding characteristic_equation() {
  std::vector<Trial> trials;
  for (const Top& top : {on_body(), on_tip()}) {
    const Real e = epsilon(top, paper_spin, paper_radius);
    for (const Complex& x : places) {
      const auto a = matrix(top, paper_spin, e, x);
      trials.push_back(relative(a[0] * a[3] - a[1] * a[2], value(cubic(top, paper_spin, e), x)));
    }
  }
  const Trial t = worst(trials);
  return {t, {}, digits50, "Against the determinant of (5.30) at three λ, body and tip: " + text(t.error, 2)};
}

/// The expressions between the straight brackets of (5.31).
Complex first_bracket(const Top& t, const Real& w, const Complex& x) {
  return t.i1 * x * x - i * t.i3 * w * x + t.amg();
}
Complex second_bracket(const Top& t, const Real& w, const Complex& x) {
  const Real h = t.h();
  return (t.i1 + t.m * h * h) * x * x - i * (t.i3 + t.m * h * t.r) * w * x + t.amg();
}

Finding difference_of_brackets() {
  std::vector<Trial> trials;
  for (const Top& top : {on_body(), on_tip()}) {
    const Real h = top.h();
    for (const Complex& x : places) {
      trials.push_back(relative(second_bracket(top, paper_spin, x) - first_bracket(top, paper_spin, x),
                                top.m * h * x * (h * x - i * top.r * paper_spin)));
    }
  }
  const Trial t = worst(trials);
  return {t, {}, digits50, "The second bracket less the first: " + text(t.error, 2)};
}

Finding zero_root() {
  std::vector<Trial> trials;
  for (const Top& top : {on_body(), on_tip()}) {
    const Real e = epsilon(top, paper_spin, paper_radius);
    trials.push_back(relative(Complex(e * top.amg()), value(cubic(top, paper_spin, e), 0)));
  }
  const Trial t = worst(trials);
  return {t, {}, digits50, "At λ = 0 (5.31) is εamg, not zero for a ≠ 0: " + text(t.error, 2)};
}

Real margin(const Top& t, const Real& w) {
  return t.i1 * t.r / t.h() * (t.i3 / t.i1 - t.r / t.h()) * w * w + t.amg();
}

Finding boundary() {
  std::vector<Trial> trials;
  for (const Top& top : {on_body(), on_tip()}) {
    const Complex x = i * top.r * paper_spin / top.h();
    trials.push_back(relative(first_bracket(top, paper_spin, x), Complex(margin(top, paper_spin))));
    trials.push_back(relative(second_bracket(top, paper_spin, x), Complex(margin(top, paper_spin))));
  }
  const Trial t = worst(trials);
  return {t, {}, digits50, "Both brackets at λ = irω_0/h: " + text(t.error, 2)};
}

/// A top of given shape; m, I_1, h and g are the paper's.
Top of_shape(const Real& h_over_r, const Real& i3_over_i1) {
  Top t;
  const Real h = t.h();
  t.i3 = i3_over_i1 * t.i1;
  t.r = h / h_over_r;
  t.a = t.r - h;
  return t;
}
Real critical(const Top& t) { return sqrt(-t.amg() / (t.r / t.h() * t.i1 * (t.i3 / t.i1 - t.r / t.h()))); }

/// Shapes of one region; all four for 0.
std::vector<std::pair<Top, int>> shapes(int wanted) {
  std::vector<std::pair<Top, int>> all;
  for (const int tenths : {3, 6, 9, 12, 16, 25, 42}) {
    for (const int y : {2, 5, 9, 13, 19}) {
      const Real x = ratio(tenths, 10), z = ratio(y, 10);
      const int region = x > 1 ? (x * z < 1 ? 1 : 2) : (x * z > 1 ? 3 : 4);
      if (wanted == 0 || wanted == region) all.emplace_back(of_shape(x, z), region);
    }
  }
  return all;
}

struct Count {
  int cases = 0;
  int wrong = 0;
};
/// Cases where the roots are not as `stable(top, spin)` has it: spins about the critical one or the top's
/// own.
Count count(int region, const std::function<bool(const Top&, const Real&)>& stable) {
  Count c;
  for (const auto& [top, where] : shapes(region)) {
    const bool conditional = where == 2 || where == 4;
    const Real unit = conditional ? critical(top) : Real(sqrt(abs(top.amg()) / top.i1));
    for (const int percent : {20, 98, 102, 500}) {
      const Real spin = unit * ratio(percent, 100);
      for (const Real& e : {Real("1e-2"), Real(1), Real(100)}) {
        ++c.cases;
        c.wrong += (largest(top, spin, e) < 0) != stable(top, spin);
      }
    }
  }
  return c;
}

Finding counted(const Count& c, const std::string& what) {
  return {
      absolute(0, c.wrong),
      {},
      0,
      what +
          ": the sign of the largest real part of the roots of (5.31), shapes, spins and ε = 1e-2, 1, 100 "
          "N s/m: " +
          text(c.wrong) + " of " + text(c.cases) + " cases against it"};
}

Finding stable_side() {
  return counted(count(0, [](const Top& t, const Real& w) { return margin(t, w) > 0; }),
                 "Stable where it holds, unstable where not");
}
Finding region_one() {
  return counted(count(1, [](const Top&, const Real&) { return false; }), "Unstable at every spin");
}
Finding region_two() {
  return counted(count(2, [](const Top& t, const Real& w) { return w > critical(t); }),
                 "Stable above ω_k, unstable below");
}
Finding region_three() {
  return counted(count(3, [](const Top&, const Real&) { return true; }), "Stable at every spin");
}
Finding region_four() {
  return counted(count(4, [](const Top& t, const Real& w) { return w < critical(t); }),
                 "Stable below ω_k, unstable above");
}

/// Where the largest real part changes its sign, by halving.
Real changes(const Top& t, const Real& e, Real low, Real high) {
  const bool sign = largest(t, low, e) > 0;
  for (int k = 0; k < 60; ++k) {
    const Real middle = (low + high) / 2;
    ((largest(t, middle, e) > 0) == sign ? low : high) = middle;
  }
  return low;
}
/// 170 rad/s halved sixty times.
constexpr double halved = 1e-15;

Finding critical_spins() {
  std::vector<Trial> trials;
  for (const Top& top : {on_body(), on_tip()})
    trials.push_back(ledger::relative(changes(top, 1, 2, 170), critical(top)));
  const Trial t = worst(trials);
  return {t,
          {},
          halved,
          "The spin at which a root of (5.31) crosses the imaginary axis, the paper's top: " +
              text(critical(on_body()), 6) + " rad/s (trivial), " + text(critical(on_tip()), 6) +
              " rad/s (inverted): " + text(t.error, 2)};
}

Finding independent_of_radius() {
  std::vector<Trial> trials;
  for (const Top& top : {on_body(), on_tip()}) {
    const Real once = changes(top, 1, 2, 170);
    for (const Real& e : {Real("1e-3"), Real(1000)})
      trials.push_back(ledger::relative(once, changes(top, e, 2, 170)));
  }
  const Trial t = worst(trials);
  return {
      t,
      {},
      halved,
      "Critical spins of the paper's top with ε = 1e-3 and 1000 N s/m against ε = 1: " + text(t.error, 2)};
}

Finding non_rotating() {
  // The height of S over the position's own, on a small circle about it.
  const auto rises = [](const Top& t) -> Real { return t.r - t.a * cos(ratio(1, 1000)) - t.h(); };
  const int wrong = (rises(on_body()) > 0 ? 0 : 1) + (rises(on_tip()) < 0 ? 0 : 1);
  return {
      absolute(0, wrong),
      {},
      0,
      "V = mg(r − a cosθ) has a minimum at θ = 0 for a > 0 and none for a < 0, and friction adds no energy"};
}

Finding paper_positions() {
  const auto region = [](const Top& t) {
    const Real x = t.h() / t.r, y = t.i3 / t.i1;
    return x > 1 ? (x * y < 1 ? 1 : 2) : (x * y > 1 ? 3 : 4);
  };
  return {absolute(0, (region(on_body()) != 4) + (region(on_tip()) != 2)),
          {},
          0,
          "The data of 5.4, I_3/I_1 = 7/8: h/r = 12/15 < 1 < 8/7 (IV) on the body, h/r = 21/5 > 8/7 (II) on "
          "the tip"};
}

Finding borders() {
  // Along h/r at fixed I_3/I_1: where the kind of stability (at a slow and at a fast spin) changes.
  std::vector<Trial> trials;
  const auto kind = [](const Real& x, const Real& y) {
    const Top t = of_shape(x, y);
    return 2 * (largest(t, ratio(1, 1000), 1) < 0) + (largest(t, Real("1e6"), 1) < 0);
  };
  for (const Real& y : {ratio(1, 2), ratio(3, 2)}) {
    for (const Real& expected : {Real(1), Real(1 / y)}) {
      Real low = expected * ratio(8, 10), high = expected * ratio(12, 10);
      const int left = kind(low, y);
      for (int k = 0; k < 24; ++k) {
        const Real middle = (low + high) / 2;
        (kind(middle, y) == left ? low : high) = middle;
      }
      trials.push_back(ledger::relative(expected, low));
    }
  }
  const Trial t = worst(trials);
  // 0.4 halved 24 times; the slowest and the fastest spin see a strip of relative width 1e-6.
  return {
      t,
      {},
      1e-5,
      "Where the roots of (5.31), at a slow and at a fast spin, change their kind along h/r, I_3/I_1 = ½ and "
      "3/2: h/r = 1 and h/r = I_1/I_3 to " +
          text(t.error, 2)};
}

/// The two roots of the quadratic (5.36) by (5.37).
std::array<Complex, 2> rolling(const Top& t, const Real& w) {
  const Real a = t.i1 + t.m * t.h() * t.h(), b = (t.i3 + t.m * t.h() * t.r) * w, c = t.amg();
  const Complex root = sqrt(Complex(b * b / (4 * a * a) + c / a));
  return {i * (b / (2 * a) + root), i * (b / (2 * a) - root)};
}

/// Of the roots of (5.31) for that R the one next to x.
Complex next_to(const Top& t, const Real& radius, const Complex& x) {
  const auto all = roots(cubic(t, paper_spin, epsilon(t, paper_spin, radius)));
  return *std::min_element(all.begin(), all.end(), [&](const Complex& y, const Complex& z) {
    return Real(abs(y - x)) < Real(abs(z - x));
  });
}

Finding vanishing_radius() {
  std::vector<Trial> trials;
  for (const Top& top : {on_body(), on_tip()}) {
    for (const Complex& x : rolling(top, paper_spin)) {
      trials.push_back(order(
          [&](const Real& times) -> Real { return Real(abs(next_to(top, times * Real("1e-6"), x) - x)); },
          1));
    }
  }
  const Trial t = worst(trials);
  return {t,
          {},
          order_bound,
          "Two roots of (5.31) tend to those of (5.36) with the power " + text(t.obtained, 5) + " of R"};
}

Finding rolling_roots() {
  std::vector<Trial> trials;
  for (const Top& top : {on_body(), on_tip()}) {
    for (const Complex& x : rolling(top, paper_spin)) {
      const Real size = (top.i1 + top.m * top.h() * top.h()) * Real(norm(x)) + abs(top.amg());
      trials.push_back(absolute(0, Real(abs(second_bracket(top, paper_spin, x))) / size));
    }
  }
  const Trial t = worst(trials);
  return {t, {}, digits50, "Put into (5.36), body and tip, relative to its terms: " + text(t.error, 2)};
}

Finding purely_imaginary() {
  std::vector<Trial> trials;
  for (const auto& [top, region] : shapes(0)) {
    if (region < 3) continue;
    for (const Real& w : {Real("0.01"), Real(10), Real(1000)}) {
      for (const Complex& x : rolling(top, w)) trials.push_back(absolute(0, x.real()));
    }
  }
  const auto tip = rolling(on_tip(), 60);
  const Trial t = worst(trials);
  return {t,
          {},
          0,
          "Shapes with a > 0, three spins: largest real part " + text(t.error, 2) +
              ". (For a < 0 only above a spin: the inverted position at 60 rad/s has " +
              text(abs(tip[0].real()), 4) + " 1/s)"};
}

Finding small_real_part() {
  std::vector<Trial> trials;
  for (const Top& top : {on_body(), on_tip()}) {
    for (const Complex& x : rolling(top, paper_spin)) {
      trials.push_back(
          order([&](const Real& times) -> Real { return next_to(top, times * Real("1e-6"), x).real(); }, 1));
    }
  }
  const Trial t = worst(trials);
  return {t, {}, order_bound, "Real parts fall with the power " + text(t.obtained, 5) + " of R"};
}

Finding slower_with_radius() {
  const Top top;
  const auto rate = [&](const Real& radius) {
    return largest(top, paper_spin, epsilon(top, paper_spin, radius));
  };
  const auto falls = [&](const std::vector<std::string>& radii) {
    int count = 0;
    for (std::size_t k = 1; k < radii.size(); ++k) count += rate(Real(radii[k])) < rate(Real(radii[k - 1]));
    return count;
  };
  const int all = falls({"1e-5", "2e-5", "5e-5", "1e-4", "2e-4", "5e-4", "1e-3", "2e-3"});
  const int small = falls({"1e-5", "2e-5", "5e-5", "1e-4", "2e-4"});
  return {absolute(0, all), absolute(0, small), 0,
          "Trivial position, 180 rad/s, largest real part of (5.31) in 1/s: " + text(rate(Real("1e-5")), 4) +
              " at R = 1e-5 m, " + text(rate(Real("1e-4")), 4) + " at 1e-4, " + text(rate(Real("2e-4")), 4) +
              " at 2e-4, " + text(rate(Real("5e-4")), 4) + " at 5e-4, " + text(rate(Real("1e-3")), 4) +
              " at 1e-3, " + text(rate(Real("2e-3")), 4) + " at 2e-3"};
}

}  // namespace

std::vector<Row> section5_stability() {
  return {
      {"5.22", "(5.22)", "I_1α̈ + I_3γ̇β̇ = −aαλ_N + hλ_T2, ..., I_3γ̇ = rαλ_T1 + rβλ_T2", Flaw::misprint,
       "I_3γ̈ = rαλ_T1 + rβλ_T2 in the sixth", "The text below takes it as a small change of the spin.",
       equations_of_motion},
      {"5.22.drilling", "(5.22), the drilling torque", "I_3γ̈ is of order η², the spin constant",
       Flaw::imprecise, "I_3γ̈ = −η(0)μλ_N R sgn γ̇ + O(η²), η(0) = 3π/16 (Hertz)",
       "With Contensou's law there is a torque where there is spin. It slows the top and has a part across "
       "the inclined axis, both of the order of R like the real parts of the eigenvalues. The nutation that "
       "inverts the top at 180 rad/s hardly notices; precession does, and slow tops: below ω_k the "
       "inclination on the body goes like a negative power of the dying spin, whatever the small R. See the "
       "claims "
       "stability.growth, stability.drilling and stability.points.",
       left_out_torque},
      {"5.22.height", "5.5, h", "h = −a + r defines the maximal height of S", Flaw::imprecise,
       "the height of S in the position: the largest on the tip, the smallest on the body", "",
       largest_height},
      {"5.22.normal", "5.5, below (5.22)", "mz̈_S is of order η: λ_N = mg", Flaw::none, "",
       "It is of order η²: λ_N = mg is good to first order, as it has to be.", normal_motion},
      {"5.23", "(5.23)", "−λ_T ∈ ∂‖γ_T‖ (3μλ_N/32)πu(−u² + 4), u <= 1", Flaw::none, "", "", friction_force},
      {"5.24", "(5.24)", "λ_T ≈ −μλ_N 3/(8π) γ_T/(ωR)", Flaw::misprint, "3π/8 in place of 3/(8π), |ω|",
       "A factor of π² = 9.87 in ε, and in R where eigenvalues are concerned.", slope},
      {"5.25", "(5.25)", "ε = μmg 3/(8π) 1/(ωR)", Flaw::misprint, "ε = μmg (3π/8)/(|ω|R)", "As (5.24).",
       damping},
      {"5.26", "(5.26)", "the reduced equations of motion", Flaw::none, "", "", reduced_equations},
      {"5.27", "(5.27)", "w = v_x + iv_y, ξ = α + iβ", Flaw::none, "", "", complex_variables},
      {"5.28", "(5.28)", "mẇ + ε(w + ihξ̇ + rω_0ξ) = 0, ...", Flaw::none, "", "", complex_equations},
      {"5.29", "(5.29)", "w = We^{λt}, ξ = Ξe^{λt}", Flaw::none, "", "", ansatz},
      {"5.30", "(5.30)", "the determinant", Flaw::none, "", "", characteristic_matrix},
      {"5.31", "(5.31)", "mλ[I_1λ² − iI_3ω_0λ + amg] + ε[(I_1 + mh²)λ² − i(I_3 + mhr)ω_0λ + amg] = 0",
       Flaw::none, "", "", characteristic_equation},
      {"5.32", "(5.32)", "mhλ(hλ − irω_0) = 0", Flaw::none, "", "", difference_of_brackets},
      {"5.32.zero", "(5.32), its first root", "λ = 0 is not a root of (5.31)", Flaw::none, "", "", zero_root},
      {"5.33", "(5.33)", "I_1(r/h)(I_3/I_1 − r/h)ω_0² + amg = 0", Flaw::none, "", "", boundary},
      {"5.34", "(5.34)", "stable where I_1(r/h)(I_3/I_1 − r/h)ω_0² > −amg", Flaw::none, "",
       "Of (5.31), that is without drilling torque; see (5.22).", stable_side},
      {"5.34.rest", "5.5, below (5.34)", "the non-rotating trivial position is stable if a > 0", Flaw::none,
       "",
       "True, though (5.34) cannot say it: for ω_0 → 0 ε has no bounds, what is left is undamped rolling.",
       non_rotating},
      {"5.35", "(5.35)", "ω_k² = −amg/((r/h)I_1(I_3/I_1 − r/h))", Flaw::none, "", "", critical_spins},
      {"5.35.i", "5.5, Region I", "unstable for all values of ω_0", Flaw::none, "", "", region_one},
      {"5.35.ii", "5.5, Region II", "asymptotically stable if ω_0² > ω_k², unstable if less", Flaw::none, "",
       "", region_two},
      {"5.35.iii", "5.5, Region III", "always asymptotically stable (ω_0 ≠ 0)", Flaw::none, "", "",
       region_three},
      {"5.35.iv", "5.5, Region IV", "asymptotically stable if 0 < ω_0² < ω_k², unstable if more", Flaw::none,
       "", "", region_four},
      {"fig11", "Fig. 11", "four regions, bounded by h/r = 1 and h/r = I_1/I_3", Flaw::none, "", "", borders},
      {"fig11.top", "Fig. 11, the Tippe-Top", "the trivial position is in Region IV, the inverted one in II",
       Flaw::none, "", "", paper_positions},
      {"5.5.radius", "5.5, below Region IV",
       "the stability regions do not depend on ε, and therefore not on R", Flaw::none, "",
       "Of (5.31). With drilling torque they do not depend on small R either, but are others: see (5.22).",
       independent_of_radius},
      {"5.36", "(5.36)", "(I_1 + mh²)λ² − i(I_3 + mhr)ω_0λ + amg = 0 for R → 0", Flaw::none, "",
       "The third root goes to −∞ like 1/R.", vanishing_radius},
      {"5.37", "(5.37)", "λ = i(B/2A ± √(B²/4A² + C/A))", Flaw::none, "", "", rolling_roots},
      {"5.37.imaginary", "5.5, below (5.37)", "for a > 0 always purely imaginary", Flaw::none, "", "",
       purely_imaginary},
      {"5.37.small", "5.5, below (5.37), small R", "the real parts are very small for small R", Flaw::none,
       "", "", small_real_part},
      {"5.5.slower", "5.5, on Fig. 12",
       "decreasing R decreases the magnitude of the real part of the eigenvalues", Flaw::imprecise,
       "it does for small R: below about 2e-4 m at 180 rad/s",
       "The paper's own R = 5e-4 m lies beyond the radius of fastest growth: there a smaller one makes the "
       "growing "
       "eigenvalue larger.",
       slower_with_radius},
  };
}

}  // namespace verify::ledger
