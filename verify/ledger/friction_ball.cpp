// LG03 (2.11), (2.18) to (2.20), (3.19) to (3.22) read as sets: what the force laws admit, and what the ball
// is.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "oracle.hpp"

namespace verify::ledger {
namespace {

struct Border {
  double u;  ///< the outward normal is (u, 1)
  double f;
  double xi;
  double eta;
};

/// The exact meridian, from the pole to the equator, in equal steps of the normal's angle.
std::vector<Border> compute_meridian(Pressure pressure) {
  constexpr int steps = 240;
  std::vector<Border> all;
  for (int i = 0; i < steps; ++i) {
    const Real u = tan(pi() / 2 * (2 * i + 1) / (2 * steps));
    const Exact e = exact(pressure, u);
    all.push_back({static_cast<double>(u), static_cast<double>(e.f), static_cast<double>(e.xi),
                   static_cast<double>(e.eta)});
  }
  return all;
}
const std::vector<Border>& meridian(Pressure pressure) {
  static const std::vector<Border> uniform = compute_meridian(Pressure::uniform);
  static const std::vector<Border> hertz = compute_meridian(Pressure::hertz);
  return pressure == Pressure::uniform ? uniform : hertz;
}
/// A step of 0.0065 of the normal's angle, radii of curvature up to 2 and h²/8: of lengths of order one.
constexpr double mesh = 1e-4;

double highest(Pressure pressure) {
  return pressure == Pressure::uniform ? 2.0 / 3 : 3 * std::numbers::pi / 16;
}

/// Largest size t such that t (a, b) passes λ·γ <= Φ(γ) for all γ of the mesh.
double joint_reach(const std::vector<Border>& border, double eta_max, double a, double b) {
  double reach = std::min(a > 0 ? 1 / a : 1e9, b > 0 ? eta_max / b : 1e9);
  for (const Border& p : border) reach = std::min(reach, p.f / (p.u * a + b));
  return reach;
}

/// Volumes over 2π, by rays: ∫ of t³/3 cos over the elevation.
double volume(const std::function<double(double a, double b)>& reach) {
  constexpr int rays = 4000;
  double sum = 0;
  for (int i = 0; i < rays; ++i) {
    const double angle = std::numbers::pi / 2 * (i + 0.5) / rays;
    sum += std::pow(reach(std::cos(angle), std::sin(angle)), 3) / 3 * std::cos(angle);
  }
  return 2 * sum * std::numbers::pi / 2 / rays;
}

Finding sets_at_rest(Pressure pressure) {
  const std::vector<Border>& border = meridian(pressure);
  const double top = highest(pressure);
  const double separate = volume([&](double a, double b) { return std::min(1 / a, top / b); });
  const double joint = volume([&](double a, double b) { return joint_reach(border, top, a, b); });
  // ∫ ξ² dη along the border, both halves
  double ball = 0;
  double corner = 0;
  for (std::size_t k = 0; k <= border.size(); ++k) {
    const double xi0 = k > 0 ? border[k - 1].xi : 0;
    const double xi1 = k < border.size() ? border[k].xi : 1;
    const double eta0 = k > 0 ? border[k - 1].eta : top;
    const double eta1 = k < border.size() ? border[k].eta : 0;
    ball += (xi0 * xi0 + xi0 * xi1 + xi1 * xi1) / 3 * (eta0 - eta1);
  }
  for (const Border& p : border) {
    corner = std::max(corner, (p.u * 1 + top - p.f) / std::hypot(p.u, 1.0));
  }
  return {relative(ball, separate), relative(ball, joint), 10 * mesh,
          "Both −λ_T ∈ ∂_{γ_T}Φ and −λ_τ ∈ ∂_{γ_τ}Φ at γ_F = 0 give a disk times an interval of volume " +
              text(2 * std::numbers::pi / 2 * separate) + " (μλ_N)³; the joint condition λ·γ <= Φ(γ) gives " +
              text(std::numbers::pi * joint) + ", the ball " + text(std::numbers::pi * ball) + ": " +
              text(100 * (1 - ball / separate), 4) + " % of the product lies outside the ball, up to " +
              text(corner, 4) + " μλ_N from it"};
}

Finding one_velocity_zero() {
  std::vector<Trial> trials;
  const Real small("1e-12");
  for (const Pressure pressure : {Pressure::uniform, Pressure::hertz}) {
    // v = 0, ω ≠ 0: ∂_{γ_T}Φ is {0} if Φ rises more slowly than v; and the joint law's limit is the pole.
    trials.push_back(absolute(0, (exact(pressure, small).f - Real(exact(pressure, Real(0)).f)) / small));
    trials.push_back(absolute(0, exact(pressure, small).xi));
    // ω = 0, v ≠ 0: the same for |ω|
    trials.push_back(absolute(0, (exact(pressure, 1 / small).f * small - 1) / small));
    trials.push_back(absolute(0, exact(pressure, 1 / small).eta));
  }
  const Trial t = worst(trials);
  // Both are linear in 1e-12 with slopes below one.
  return {t,
          {},
          1e-11,
          "At γ_T = 0, γ_τ ≠ 0 and at γ_τ = 0, γ_T ≠ 0 the difference quotients of Φ across the axis and the "
          "forces of "
          "the joint law vanish together, both pressures: at 1e-12 of the other velocity below " +
              text(t.error, 2) + ". There the two separate sets are single points, those of the joint law"};
}

Finding support_of_ball() {
  std::vector<Trial> trials;
  for (const Pressure pressure : {Pressure::uniform, Pressure::hertz}) {
    const std::vector<Border>& border = meridian(pressure);
    for (const Border& n : border) {
      double support = 0;
      for (const Border& p : border) support = std::max(support, n.u * p.xi + p.eta);
      trials.push_back(relative(n.f, support));
    }
    // convex: the border turns one way only, and lies on its own hull
    for (std::size_t k = 1; k + 1 < border.size(); ++k) {
      const double turn = (border[k].xi - border[k - 1].xi) * (border[k + 1].eta - border[k].eta) -
                          (border[k].eta - border[k - 1].eta) * (border[k + 1].xi - border[k].xi);
      trials.push_back(at_most_zero(turn));
    }
  }
  const Trial t = worst(trials);
  return {t,
          {},
          1e-12,
          "Exact ball, both pressures, 240 normals: the largest λ·γ over the border is Φ(γ), reached where "
          "the law "
          "has its force, and the border turns one way only: largest violation " +
              text(t.error, 2)};
}

/// A plate cut after three terms, as printed.
struct Cut {
  double top;
  double seam;
  std::vector<double> inner;  ///< of ξ²ᵏ
  std::vector<double> outer;  ///< of η²ᵏ
  static double sum(const std::vector<double>& c, double x) {
    double value = 0;
    for (auto k = c.rbegin(); k != c.rend(); ++k) value = (value + *k) * x;
    return value;
  }
  /// η of the border.
  double height(double xi) const {
    if (xi <= seam) return top * std::sqrt(std::max(0.0, 1 - sum(inner, xi * xi)));
    double low = 0;
    double high = top;
    for (int i = 0; i < 60; ++i) {
      const double eta = low + (high - low) / 2;
      (xi * xi + sum(outer, eta * eta) < 1 ? low : high) = eta;
    }
    return low;
  }
};

Cut cut(Pressure pressure) {
  if (pressure == Pressure::uniform) {
    return {2.0 / 3, 1 - 1.0 / 8 - 1.0 / 64, {1.5, -15.0 / 32, -5.0 / 128}, {4, -20.0 / 3, 40.0 / 9}};
  }
  const double s = std::pow(9 * std::numbers::pi / 32, 2);
  return {highest(pressure),
          std::sqrt(s),
          {9.0 / 8 / s, -243.0 / 1024 / (s * s), -9.0 / 32768 / (s * s * s)},
          {5, -75.0 / 7, 1250.0 / 147}};
}

Finding cut_ball(Pressure pressure) {
  const Cut c = cut(pressure);
  const std::vector<Border>& border = meridian(pressure);
  std::vector<Border> printed;
  for (int k = 0; k < 4000; ++k) {
    const double xi = (k + 0.5) / 4000;
    printed.push_back({0, 0, xi, c.height(xi)});
  }
  std::vector<Trial> as_printed;
  std::vector<Trial> as_exact;
  for (const Border& n : border) {
    double of_printed = 0;
    for (const Border& p : printed) of_printed = std::max(of_printed, n.u * p.xi + p.eta);
    double of_exact = 0;
    for (const Border& p : border) of_exact = std::max(of_exact, n.u * p.xi + p.eta);
    as_printed.push_back(relative(n.f, of_printed));
    as_exact.push_back(relative(n.f, of_exact));
  }
  // The corner of the outer piece at the seam against the inner one: points that no plane supports.
  const double step = c.height(c.seam * (1 + 1e-12)) - c.height(c.seam);
  double dent = 0;
  for (double x = 0.5; x < 1; x += 1e-3) {
    const double a = c.height(c.seam * x);
    const double b = c.height(c.seam * (1 + 1e-12));
    for (double t = 0.05; t < 1; t += 0.05) {
      const double xi = c.seam * (x + (1 - x) * t);
      dent = std::max(dent, a + (b - a) * t - c.height(xi));
    }
  }
  const Trial p = worst(as_printed);
  return {p, worst(as_exact), mesh,
          "Taken to the letter, with three terms: the support function differs from Φ by up to " +
              text(p.error, 3) + " of it, the border jumps by " + text(step, 3) +
              " μλ_N at ξ*, and lies up to " + text(dent, 3) +
              " μλ_N inside its own convex hull: points of the border without a normal, and no single "
              "nearest point"};
}

}  // namespace

std::vector<Row> friction_ball() {
  return {
      {"2.11.sets", "(2.11), the two sets at rest", "−λ_T ∈ ∂_{γ_T}Φ, −τ_N ∈ ∂_ωΦ at γ_F = 0 (uniform)",
       Flaw::wrong, "−λ_F ∈ ∂Φ(0) = B_F",
       "A contact that sticks by the separate laws may carry a force far outside the ball.",
       [] { return sets_at_rest(Pressure::uniform); }},
      {"3.16.sets", "(3.16), the two sets at rest", "−λ_T ∈ ∂_{γ_T}Φ, −λ_τ ∈ ∂_{γ_τ}Φ at γ_F = 0 (Hertz)",
       Flaw::wrong, "−λ_F ∈ ∂Φ(0) = B_F", "As for (2.11).", [] { return sets_at_rest(Pressure::hertz); }},
      {"2.11.axes", "(2.11), one velocity zero", "−λ_T ∈ ∂_{γ_T}Φ, −τ_N ∈ ∂_ωΦ where only γ_T or only ω is 0",
       Flaw::none, "", "Rest is the only place where separate and joint inclusion differ.",
       one_velocity_zero},
      {"2.20.set", "(2.20), (3.22), B_F as a set", "B_F is convex and N_{B_F} gives back the force law",
       Flaw::none, "", "Of the exact border; so −γ_F ∈ N_{B_F}(λ_F) and −λ_F ∈ ∂Φ(γ_F) say the same.",
       support_of_ball},
      {"2.19.cut", "(2.19), cut after three terms", "B_F as the set of the law", Flaw::imprecise,
       "the exact border",
       "Good enough to draw, not to project on: the library keeps it for comparison only.",
       [] { return cut_ball(Pressure::uniform); }},
      {"3.21.cut", "(3.21), cut after three terms", "B_F as the set of the law", Flaw::imprecise,
       "the exact border", "As for (2.19).", [] { return cut_ball(Pressure::hertz); }},
  };
}

}  // namespace verify::ledger
