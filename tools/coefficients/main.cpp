// Makes lib/contensou/law/coefficients.hpp: the polynomials of the uniform and the Hertz law.
//
//   generate_coefficients > lib/contensou/law/coefficients.hpp
//
// Every polynomial interpolates at Chebyshev points in 50-digit arithmetic; its degree is the least whose
// error, found on a dense grid, is below 2^-57 of the function. Nothing here is shared with the tables that
// the laws are tested by.

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace {

using Real = boost::multiprecision::cpp_bin_float_50;
using Function = std::function<Real(const Real&)>;

const Real pi = boost::math::constants::pi<Real>();

struct Elliptic {
  Real k;
  Real e;
};

/// Complete elliptic integrals of parameter m < 1 (also negative) by the arithmetic-geometric mean.
Elliptic elliptic(const Real& m) {
  Real a = 1;
  Real g = sqrt(1 - m);
  Real sum = m / 2;
  Real power = 1;
  Real c2 = m;
  while (abs(c2) > std::numeric_limits<Real>::epsilon()) {
    const Real next = (a + g) / 2;
    const Real c = (a - g) / 2;
    g = sqrt(a * g);
    a = next;
    c2 = c * c;
    sum += power * c2;
    power *= 2;
  }
  const Real k = pi / (2 * a);
  return {k, k * (1 - sum)};
}

/// ξ, η and f'' of the uniform law as linear combinations of K and E (each with the textbook cancellation,
/// which fifty digits afford), so that the same combinations give the factors of the logarithm at u = 1.
struct Law {
  Real xi;
  Real eta;
  Real second;
};

Law uniform_inner(const Real& u, const Elliptic& ke) {
  const Real m = u * u;
  const Real mc = 1 - m;
  const Real d = (ke.k - ke.e) / m;
  const Real b = ke.k - d;
  const Real c = 4 / (3 * pi);
  return {c * u * (2 * b + mc * d), c / 3 * ((3 - m) * b + mc * (3 - 2 * m) * d), c * (b + 2 * mc * d)};
}

Law uniform_outer(const Real& u) {
  const Real m = 1 / (u * u);
  const Real mc = 1 - m;
  const auto [k, e] = elliptic(m);
  const Real d = (k - e) / m;
  const Real b = k - d;
  const Real c = (d - b) / m;
  const Real factor = 4 / (3 * pi);
  return {factor * (2 * b + mc * d), factor / (3 * u) * (2 * b + mc * c), factor / (u * u * u) * (d - c)};
}

Law uniform(const Real& u) { return u < 1 ? uniform_inner(u, elliptic(u * u)) : uniform_outer(u); }

/// The factor of ln|1 − u²| in the uniform law: K(m) carries −K(1−m)/π, E(m) carries −(K(1−m) − E(1−m))/π, on
/// both sides of u = 1 alike.
Law uniform_logarithm(const Real& u) {
  const auto [k, e] = elliptic(1 - u * u);
  return uniform_inner(u, {-k / pi, -(k - e) / pi});
}

Law hertz_outer(const Real& u) {
  const Real m = u * u;
  const Real root = sqrt(m - 1);
  const Real angle = asin(1 / u);
  const Real xi = Real(3) / 16 / u * (m * (4 - m) * angle + (m + 2) * root);
  const Real eta = Real(3) / 64 * ((3 * m * m - 8 * m + 8) * angle + (6 - 3 * m) * root);
  const Real second = Real(3) / 16 * ((4 - 3 * m) * angle + (3 * m - 2) / m * root);
  return {xi, eta, second};
}

/// Powers of t on [a, b], through the Chebyshev points, of the least degree that meets the tolerance relative
/// to `scale`.
std::vector<Real> fit(const Function& f, const Function& scale, const Real& a, const Real& b, double& error,
                      double tolerance = 0x1p-57) {
  const Real tiny("1e-9");
  for (std::size_t n = 6; n < 40; ++n) {
    // Newton's divided differences at Chebyshev points, then expanded into powers of t.
    std::vector<Real> node(n);
    std::vector<Real> divided(n);
    for (std::size_t j = 0; j < n; ++j) {
      node[j] = (a + b) / 2 + (b - a) / 2 * cos(pi * (2 * Real(j) + 1) / (2 * Real(n)));
      if (abs(node[j]) < tiny) node[j] = tiny;  // the functions are 0/0 at 0 but smooth there
      divided[j] = f(node[j]);
    }
    for (std::size_t order = 1; order < n; ++order) {
      for (std::size_t j = n - 1; j >= order; --j) {
        divided[j] = (divided[j] - divided[j - 1]) / (node[j] - node[j - order]);
      }
    }
    std::vector<Real> c(n, Real(0));
    for (std::size_t j = n; j-- > 0;) {
      for (std::size_t i = n - 1; i > 0; --i) c[i] = c[i - 1] - node[j] * c[i];
      c[0] = divided[j] - node[j] * c[0];
    }
    Real worst = 0;
    for (int i = 0; i < 100; ++i) {
      const Real t = a + (b - a) * (Real(i) + Real(1) / 3) / 100;
      Real value = 0;
      for (std::size_t k = n; k-- > 0;) value = value * t + c[k];
      const Real error_here = abs((value - f(t)) / scale(t));
      if (error_here > worst) worst = error_here;
    }
    error = worst.convert_to<double>();
    if (error < tolerance) return c;
  }
  std::fprintf(stderr, "no polynomial of degree below 40 is good enough\n");
  std::exit(1);
}

void print(const std::string& name, const std::string& meaning, const std::vector<Real>& c, double error) {
  std::printf("/// %s; relative error %.1e.\ninline constexpr std::array<double, %zu> %s{\n", meaning.c_str(),
              error, c.size(), name.c_str());
  for (const Real& x : c) std::printf("    %.17g,\n", x.convert_to<double>());
  std::printf("};\n");
}

enum Quantity { force, torque, second };
Real pick(const Law& law, Quantity q) { return q == force ? law.xi : q == torque ? law.eta : law.second; }
const char* const name_of[] = {"force", "torque", "second"};

}  // namespace

int main() {
  std::printf(
      "#pragma once\n\n"
      "// Made by tools/coefficients; do not edit. Lowest power first.\n// clang-format off\n\n"
      "#include <array>\n\nnamespace contensou::coefficients {\n\n");

  const Real far_end = Real(9) / 16;  // (3/4)²
  const Real near_end = Real(1) / 7;  // y = (u − 1)/(u + 1) at u = 4/3
  const auto u_of = [](const Real& y) { return Real((1 + y) / (1 - y)); };

  // Far from u = 1: g(x²) = g(0) + x² p(x²) for the bounded forms; p is fitted, so that g(0) is met exactly.
  const auto far = [&](const std::string& law, const std::string& side,
                       const std::function<Real(const Real&, Quantity)>& g, Quantity q, const Real& at_zero) {
    double error = 0;
    const Function whole = [&](const Real& m) { return g(sqrt(m), q); };
    const Function part = [&](const Real& m) { return Real((whole(m) - at_zero) / m); };
    const Function scale = [&](const Real& m) { return Real(whole(m) / m); };
    std::vector<Real> c = fit(part, scale, Real(0), far_end, error);
    c.insert(c.begin(), at_zero);
    print(law + (side == "either side" ? "" : "_" + side) + "_" + name_of[q],
          law + " " + side + ", " + name_of[q] + ": powers of x², x <= 3/4", c, error);
  };
  const auto uniform_in = [](const Real& u, Quantity q) {
    const Real value = pick(uniform(u), q);
    return q == force ? Real(value / u) : value;
  };
  const auto outer_form = [](const Real& u, const Law& law, Quantity q) {
    return q == force ? law.xi : q == torque ? Real(law.eta * u) : Real(law.second * u * u * u);
  };
  const auto uniform_out = [&](const Real& w, Quantity q) {
    return outer_form(1 / w, uniform_outer(1 / w), q);
  };
  const auto hertz_out = [&](const Real& w, Quantity q) { return outer_form(1 / w, hertz_outer(1 / w), q); };
  const Real inner_zero[] = {Real(1), Real(2) / 3, Real(1)};
  const Real uniform_outer_zero[] = {Real(1), Real(1) / 4, Real(1) / 4};
  const Real hertz_outer_zero[] = {Real(1), Real(1) / 5, Real(1) / 5};
  // ξ/u inside is the same function of u² as ξ outside of 1/u²: 4/(3π) (2B + m_c D).
  far("uniform", "either side", uniform_in, force, inner_zero[force]);
  for (const Quantity q : {torque, second}) far("uniform", "inner", uniform_in, q, inner_zero[q]);
  for (const Quantity q : {torque, second}) far("uniform", "outer", uniform_out, q, uniform_outer_zero[q]);
  for (const Quantity q : {force, torque, second}) far("hertz", "outer", hertz_out, q, hertz_outer_zero[q]);

  // Near u = 1, uniform: ξ, η = P(y) + y² ln|y| Q(y), f'' = P(y) + y ln|y| Q(y), with the same P, Q on both
  // sides.
  for (const Quantity q : {force, torque, second}) {
    const int power = q == second ? 1 : 2;
    const Function factor = [&](const Real& y) { return pick(uniform_logarithm(u_of(y)), q); };
    const Function smooth = [&](const Real& y) {
      return Real(pick(uniform(u_of(y)), q) - factor(y) * log(abs(y)));
    };
    const Function whole = [&](const Real& y) { return pick(uniform(u_of(y)), q); };
    double error = 0;
    const std::string name = std::string("uniform_near_") + name_of[q];
    const std::string what = std::string("uniform near u = 1, ") + name_of[q];
    const auto p = fit(smooth, whole, -near_end, near_end, error);
    print(name, what + ": P(y)", p, error);
    const Function q_of = [&](const Real& y) { return Real(factor(y) / pow(y, power)); };
    const Function q_scale = [&](const Real& y) { return Real(whole(y) / abs(pow(y, power) * log(abs(y)))); };
    const auto c = fit(q_of, q_scale, -near_end, near_end, error);
    print(name + "_log", what + ": Q(y), factor of y^" + std::to_string(power) + " ln|y|", c, error);
  }

  // Near u = 1, Hertz, outside: all three are analytic in z = √y. (Inner polynomials + y^(5/2) Q(y) would be
  // the same with digits lost to cancellation: 5 ulp in η at u = 4/3.)
  for (const Quantity q : {force, torque, second}) {
    const Function whole = [&](const Real& z) {
      const Real u = u_of(z * z);
      const Law law = hertz_outer(u);
      return q == second ? Real(law.second * u * u * u) : pick(law, q);
    };
    double error = 0;
    const auto c = fit(whole, whole, Real(0), sqrt(near_end), error);
    print(std::string("hertz_near_") + name_of[q],
          std::string("Hertz just outside u = 1, ") + name_of[q] + ": powers of √y", c, error);
  }

  // A start for Newton's iteration in the batch laws, two steps from full accuracy.
  const Function inverse_root = [](const Real& m) { return Real(1 / sqrt(1 + m)); };
  double error = 0;
  const auto start = fit(inverse_root, inverse_root, Real(0), Real(1), error, 0x1p-15);
  print("inverse_root", "(1 + m)^(-1/2) for 0 <= m <= 1", start, error);
  std::printf("\n}  // namespace contensou::coefficients\n");
}
