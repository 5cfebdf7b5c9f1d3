// LG03 Appendix A: the integral tables, (A.1) to (A.5), each as a definite integral between two points.

#include "oracle.hpp"

namespace verify::ledger {
namespace {

/// X = ax² + bx + c with a < 0 and Δ < 0, generic.
struct Quadratic {
  Real a = ratio(-13, 10);
  Real b = ratio(7, 10);
  Real c = ratio(9, 10);
  Real operator()(const Real& x) const { return (a * x + b) * x + c; }
  Real delta() const { return 4 * a * c - b * b; }
};

/// ∫_x^y integrand against `printed(y) − printed(x)`, 0.15 to 0.95: within the zeros of X.
Finding definite(const Function& integrand, const Function& printed) {
  const Real x = ratio(3, 20);
  const Real y = ratio(19, 20);
  const Trial t = relative(integrate(integrand, x, y), printed(y) - printed(x));
  return {t,
          {},
          digits50,
          "Between 0.15 and 0.95: quadrature " + text(t.expected, 15) + ", table " + text(t.obtained, 15) +
              ", relative difference " + text(t.error, 2)};
}

Finding a1() {
  const Quadratic q;
  const auto root = [q](const Real& x) -> Real { return sqrt(q(x)); };
  return definite([q](const Real& x) -> Real { return x * x * sqrt(q(x)); },
                  [q, root](const Real& x) -> Real {
                    const Real rest = integrate(root, 0, x);
                    return (x - 5 * q.b / (6 * q.a)) * q(x) * sqrt(q(x)) / (4 * q.a) +
                           (5 * q.b * q.b - 4 * q.a * q.c) / (16 * q.a * q.a) * rest;
                  });
}

Finding a2() {
  const Quadratic q;
  return definite([q](const Real& x) -> Real { return sqrt(q(x)); },
                  [q](const Real& x) -> Real {
                    const Real rest = integrate([q](const Real& y) -> Real { return 1 / sqrt(q(y)); }, 0, x);
                    return (2 * q.a * x + q.b) / (4 * q.a) * sqrt(q(x)) + q.delta() / (8 * q.a) * rest;
                  });
}

Finding a3() {
  const Quadratic q;
  return definite(
      [q](const Real& x) -> Real { return 1 / sqrt(q(x)); },
      [q](const Real& x) -> Real { return -asin((2 * q.a * x + q.b) / sqrt(-q.delta())) / sqrt(-q.a); });
}

Finding a4() {
  return definite([](const Real& x) -> Real { return sin(x) * sin(x); },
                  [](const Real& x) -> Real { return x / 2 - sin(2 * x) / 4; });
}

Finding a5() {
  return definite([](const Real& x) -> Real { return pow(sin(x), 4); },
                  [](const Real& x) -> Real { return 3 * x / 8 - sin(2 * x) / 4 + sin(4 * x) / 32; });
}

/// Δ = 4ac − b² of (3.11) is −4(1 − u² sin²θ) < 0, as the tables ask, wherever the chord is.
Finding discriminant() {
  std::vector<Trial> trials;
  for (const char* number : {"0.3", "0.999", "1.7", "9"}) {
    const Real u(number);
    const Real farthest = u <= 1 ? Real(pi()) : Real(asin(1 / u));
    for (int i = 0; i < 10; ++i) {
      const Real theta = farthest * (2 * i + 1) / 20;
      const Real b = 2 * u * cos(theta);
      const Real delta = -4 * (1 - u * u) - b * b;
      trials.push_back(relative(-4 * (1 - u * u * sin(theta) * sin(theta)), delta));
      trials.push_back(at_most_zero(delta));
    }
  }
  const Trial t = worst(trials);
  return {t, {}, digits50, "40 chords, u = 0.3 to 9: Δ as in (3.11) and negative, to " + text(t.error, 2)};
}

}  // namespace

std::vector<Row> appendix_a() {
  return {
      {"A.1", "(A.1)", "∫x²√X dx = (x − 5b/(6a)) X√X/(4a) + (5b² − 4ac)/(16a²) ∫√X dx", Flaw::none, "", "",
       a1},
      {"A.2", "(A.2)", "∫√X dx = (2ax + b)/(4a) √X + Δ/(8a) ∫dx/√X", Flaw::none, "", "", a2},
      {"A.3", "(A.3)", "∫dx/√X = −(1/√−a) arcsin((2ax + b)/√−Δ)", Flaw::none, "", "", a3},
      {"A.4", "(A.4)", "∫sin²x dx = x/2 − (1/4) sin 2x", Flaw::none, "", "", a4},
      {"A.5", "(A.5)", "∫sin⁴x dx = 3x/8 − (1/4) sin 2x + (1/32) sin 4x", Flaw::none, "", "", a5},
      {"A.delta", "Appendix A, text before (A.1)", "X = ax² + bx + c with a < 0 and Δ = 4ac − b² < 0",
       Flaw::none, "", "The condition holds wherever (3.11) uses the tables.", discriminant},
  };
}

}  // namespace verify::ledger
