// LG03 Section 4.1, second half: the augmented Lagrangian and the iteration, (4.10) to (4.17).

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "inclusion.hpp"
#include "oracle.hpp"

namespace verify::ledger {
namespace {

using Eigen::Vector3d;
using Point = Inclusion::Point;
using Vector6 = Inclusion::Vector6;

constexpr double some_r = 0.6;

/// Central differences with this step: (step)² times third derivatives of order one, 1e-16·10/step of
/// rounding, and the projection's own 1e-12/step.
constexpr double step = 1e-4;
constexpr double differences = 1e-6;

/// A point that is no solution: friction that must be projected, a normal impulse that presses.
Point off_solution() {
  Point p;
  for (int k = 0; k < 6; ++k) p.change[k] = 0.4 * std::sin(2.0 * k + 1);
  p.normal = 1.7;
  p.friction = Vector3d(0.9, -1.4, 0.8);
  return p;
}

Point zero() { return {Vector6::Zero(), 0, Vector3d::Zero()}; }
Point along(int k) {
  Point d = zero();
  if (k < 6) d.change[k] = 1;
  if (k == 6) d.normal = 1;
  if (k > 6) d.friction[k - 7] = 1;
  return d;
}

Inclusion::Size frozen(double size) {
  return [size](const Point&) { return size; };
}
/// B_F(Λ_N), the arguments of Π_F in (4.16).
Inclusion::Size following(const Inclusion& i) {
  return [mu = i.mu](const Point& p) { return mu * p.normal; };
}
/// B_F(prox(Λ_N − rγ_N)), footnote 1.
Inclusion::Size footnote(const Inclusion& i, double r) {
  return [i, r](const Point& p) { return i.mu * std::max(0.0, p.normal - r * i.gamma_n(p.change)); };
}

double project_n(const Inclusion& i, const Point& p, double r) {
  return std::max(0.0, p.normal - r * i.gamma_n(p.change));
}
Vector3d project_f(const Inclusion& i, const Point& p, double r, double size) {
  return hertz_ball::prox(p.friction - r * i.gamma_f(p.change), size);
}

/// The right-hand sides of (4.15) along the ten directions, Δu, Λ_N, Λ_F.
double stationarity(const Inclusion& i, const Point& p, double r, double size, int k) {
  const double normal = project_n(i, p, r);
  const Vector3d friction = project_f(i, p, r, size);
  if (k < 6) return (i.mass * p.change - i.smooth - i.w_n * normal - i.w_f * friction)[k];
  if (k == 6) return -(p.normal - normal) / r;
  return -(p.friction - friction)[k - 7] / r;
}

Trial gradient_error(const Inclusion& i, const Point& p, double r, const Inclusion::Size& size, int from,
                     int to) {
  std::vector<Trial> trials;
  for (int k = from; k < to; ++k) {
    trials.push_back(absolute(stationarity(i, p, r, size(p), k), i.slope(p, along(k), r, size, step)));
  }
  return worst(trials);
}

/// Points all over the space, some of them inside the ball of size one.
std::vector<Vector3d> cloud() {
  std::vector<Vector3d> points;
  for (int k = 1; k <= 24; ++k) {
    points.emplace_back(0.15 * k * Vector3d(std::sin(1.3 * k), std::cos(2.1 * k), std::sin(0.7 * k + 2)));
  }
  return points;
}

Finding lagrangian_as_maximum() {
  // (4.10) = max over λ ∈ C_N × B of L(Δu, λ) − ‖λ − Λ‖²/(2r), Rockafellar's form, with the points of C_N and
  // of the ball tried one after another.
  const Inclusion i = sliding();
  const std::vector<Vector3d> border = hertz_ball::cover(60);
  std::vector<Trial> trials;
  for (const double r : {0.2, 0.6, 2.0}) {
    for (int k = 0; k < 3; ++k) {
      Point p = off_solution();
      p.normal -= 1.5 * k;         // the last lifts off
      p.friction *= 1 - 0.45 * k;  // the last is inside
      const double size = 0.5;
      const Vector6 rest = p.change - i.mass.ldlt().solve(i.smooth);
      double normal = -1e9;
      for (int j = 0; j <= 200000; ++j) {
        const double l = 1e-4 * j;
        normal = std::max(normal, -i.gamma_n(p.change) * l - std::pow(l - p.normal, 2) / (2 * r));
      }
      double friction = -1e9;
      const Vector3d gamma = i.gamma_f(p.change);
      for (const Vector3d& b : border) {
        // on the ray through b the best place is known
        const Vector3d ray = size * b;
        const double best = std::clamp(ray.dot(p.friction - r * gamma) / ray.squaredNorm(), 0.0, 1.0);
        friction =
            std::max(friction, -gamma.dot(best * ray) - (best * ray - p.friction).squaredNorm() / (2 * r));
      }
      trials.push_back(
          relative(rest.dot(i.mass * rest) / 2 + normal + friction, i.lagrangian(p, r, frozen(size))));
    }
  }
  const Trial t = worst(trials);
  // A mesh of 1.5 degrees: 0.013² size²/(2r) and the like, of values of order one.
  return {
      t,
      {},
      1e-3,
      "For a fixed ball L_A is the maximum of L(Δu, λ) − ‖λ − Λ‖²/(2r) over λ ∈ C_N × B, here by trying all "
      "points of a mesh, 9 cases with three r: largest relative difference " +
          text(t.error, 2)};
}

Finding plain_lagrangian() {
  const Inclusion i = sliding();
  const Point p = off_solution();
  const auto value = [&](const Vector6& change) {
    const Vector6 rest = change - i.mass.ldlt().solve(i.smooth);
    return rest.dot(i.mass * rest) / 2 - i.gamma_n(change) * p.normal - i.gamma_f(change).dot(p.friction);
  };
  const Vector6 residual = i.mass * p.change - i.smooth - i.w_n * p.normal - i.w_f * p.friction;
  std::vector<Trial> trials;
  for (int k = 0; k < 6; ++k) {
    const Vector6 h = step * Vector6::Unit(k);
    trials.push_back(absolute(residual[k], (value(p.change + h) - value(p.change - h)) / (2 * step)));
  }
  const Trial t = worst(trials);
  return {t, {}, differences, "∇_{Δu}L by differences is the left side of (4.7): to " + text(t.error, 2)};
}

Finding nearest_point() {
  const std::vector<Vector3d> border = hertz_ball::cover(120);
  std::vector<Trial> trials;
  for (const Vector3d& x : cloud()) {
    const Vector3d nearest = hertz_ball::prox(x, 1);
    if (nearest == x) {  // inside: no plane with a support of the ball parts it
      double above = -1e9;
      for (const Vector3d& b : border) above = std::max(above, x.dot(b) - hertz_ball::support(b));
      trials.push_back(at_most_zero(above));
      continue;
    }
    double distance = 1e9;
    for (const Vector3d& b : border) distance = std::min(distance, (b - x).norm());
    trials.push_back(absolute(distance, (nearest - x).norm()));
  }
  const Trial t = worst(trials);
  // A mesh of 0.013: the nearest of its points is up to 0.01 from the nearest point, 0.01²/(2·0.05) farther
  // off.
  return {t,
          {},
          1e-3,
          "24 points about the ball of the Hertz law: distance of prox against the nearest of " +
              text(border.size()) + " border points, to " + text(t.error, 2) +
              ". One nearest point, since the exact ball is convex"};
}

Finding distance_gradient() {
  std::vector<Trial> trials;
  for (const Vector3d& x : cloud()) {
    const Vector3d claimed = x - hertz_ball::prox(x, 1);
    for (int k = 0; k < 3; ++k) {
      const auto value = [&](double h) {
        const Vector3d y = x + h * Vector3d::Unit(k);
        return (y - hertz_ball::prox(y, 1)).squaredNorm() / 2;
      };
      trials.push_back(absolute(claimed[k], (value(step) - value(-step)) / (2 * step)));
    }
  }
  const Trial t = worst(trials);
  return {t, {}, differences, "By differences at 24 points, inside and outside: to " + text(t.error, 2)};
}

Finding function_gradient() {
  std::vector<Trial> trials;
  const Vector3d y(0.6, -0.3, 0.5);
  for (const Vector3d& x : cloud()) {
    const Vector3d claimed = -hertz_ball::prox(y - x, 1);
    for (int k = 0; k < 3; ++k) {
      const auto value = [&](double h) {
        const Vector3d z = x + h * Vector3d::Unit(k);
        return -z.dot(y) + z.squaredNorm() / 2 - (y - z - hertz_ball::prox(y - z, 1)).squaredNorm() / 2;
      };
      trials.push_back(absolute(claimed[k], (value(step) - value(-step)) / (2 * step)));
    }
  }
  const Trial t = worst(trials);
  return {t, {}, differences, "By differences at 24 points, signs as printed: to " + text(t.error, 2)};
}

Finding stationarity_conditions() {
  const Inclusion i = sliding();
  std::vector<Trial> trials;
  for (const double r : {0.2, some_r, 2.0})
    trials.push_back(gradient_error(i, off_solution(), r, frozen(0.5), 0, 10));
  const Trial t = worst(trials);
  return {
      t,
      {},
      differences,
      "All ten components by differences of (4.10), with B_F held fixed, three r: to " + text(t.error, 2)};
}

/// What ∂/∂Λ_N of −dist²_{B(Λ_N)}/(2r) adds: (μ/r) dist Φ(n)/(μλ_N), n the direction to the point.
double added(const Inclusion& i, const Point& p, double r, double size) {
  const Vector3d rest = p.friction - r * i.gamma_f(p.change) - project_f(i, p, r, size);
  return i.mu / r * hertz_ball::support(rest);
}

Finding moving_ball() {
  const Inclusion i = sliding();
  Point p = i.solve();  // and aside, in all ten components
  for (int k = 0; k < 6; ++k) p.change[k] += 0.1 * std::sin(2.0 * k + 1);
  p.normal *= 1.1;
  p.friction += Vector3d(0.1, -0.2, 0.15);
  const double slope = i.slope(p, along(6), some_r, following(i), step);
  const double printed = stationarity(i, p, some_r, i.mu * p.normal, 6);
  const double term = added(i, p, some_r, i.mu * p.normal);
  const Trial noted = gradient_error(i, p, some_r, footnote(i, some_r), 0, 6);
  return {absolute(slope, printed), absolute(slope, printed + term), differences,
          "With B_F(Λ_N) the derivative of (4.10) in Λ_N is " + text(slope) + ", the line gives " +
              text(printed) + "; the missing term is " + text(term) +
              ". With the ball of footnote 1, which moves with Δu, the first line differs from the "
              "derivative by " +
              text(noted.error, 3)};
}

/// Whether the ball of that size has the point nearest to x, tested by its planes: λ·c <= size Φ(c).
bool has_nearest(const Vector3d& x, double size, const std::vector<std::pair<Vector3d, double>>& planes) {
  const Vector3d nearest = hertz_ball::prox(x, size);
  return std::all_of(planes.begin(), planes.end(), [&](const auto& plane) {
    const auto& [c, support] = plane;
    return nearest.dot(c) - size * support <= 1e-10 * c.norm() * std::abs(size);
  });
}

Finding defined_everywhere() {
  // With c there is −c: a ball of negative size would have to be in front of one plane and behind the other.
  std::vector<std::pair<Vector3d, double>> planes;
  for (const Vector3d& c : hertz_ball::cover(16)) planes.emplace_back(c, hertz_ball::support(c));
  int count = 0;
  int printed = 0;
  int noted = 0;
  for (int k = 1; k <= 300; ++k) {
    const double impulse = 2 * std::sin(1.0 * k);
    const double gamma = 2 * std::cos(1.7 * k);
    const Vector3d x(3 * std::sin(0.7 * k), 3 * std::cos(2.1 * k), 3 * std::sin(1.3 * k + 1));
    ++count;
    if (has_nearest(x, impulse, planes)) ++printed;
    if (has_nearest(x, std::max(0.0, impulse - some_r * gamma), planes)) ++noted;
  }
  return {relative(1, ratio(printed, count)), relative(1, ratio(noted, count)), 0,
          "Of " + text(count) +
              " triples (Λ_N, γ_N, Λ_F − rγ_F), Λ_N of either sign, the nearest point of "
              "B_F(Λ_N) exists for " +
              text(printed) + ", of B_F(prox(Λ_N − rγ_N)) for " + text(noted)};
}

Finding same_at_solution() {
  std::vector<Trial> trials;
  for (const Inclusion& i : {sliding(), sticking()}) {
    const Point p = i.solve();
    for (const double r : {0.01, 1.0, 100.0}) trials.push_back(relative(p.normal, project_n(i, p, r)));
  }
  const Trial t = worst(trials);
  return {
      t, {}, 1e-11, "At the solutions prox(Λ_N − rγ_N) = Λ_N for r = 0.01, 1, 100: to " + text(t.error, 2)};
}

Finding equations_are_the_inclusion() {
  std::vector<Trial> trials;
  const std::vector<Vector3d> border = hertz_ball::cover(40);
  for (const Inclusion& i : {sliding(), sticking()}) {
    const Point p = i.solve();
    for (const double r : {0.01, 1.0, 100.0}) {
      const double size = i.mu * p.normal;
      trials.push_back(absolute(0, (p.friction - project_f(i, p, r, size)).norm() / (1 + r)));
      trials.push_back(
          absolute(0, (i.mass * p.change - i.smooth - i.w_n * p.normal - i.w_f * p.friction).norm()));
    }
    // (4.8) by its definition
    trials.push_back(absolute(0, i.gamma_n(p.change)));
    const Vector3d gamma = i.gamma_f(p.change);
    for (const Vector3d& b : border)
      trials.push_back(at_most_zero(-gamma.dot(i.mu * p.normal * b - p.friction)));
  }
  const Trial t = worst(trials);
  return {t,
          {},
          1e-10,
          "A sliding and a sticking contact: the solution found with one r satisfies (4.17) for r = 0.01, 1 "
          "and 100, "
          "and the laws (4.8) by their definition over " +
              text(border.size()) + " points of the ball: to " + text(t.error, 2)};
}

Finding saddle_point() {
  const Inclusion i = sliding();
  const Point p = i.solve();
  const double size = i.mu * p.normal;
  const double scale = i.gamma_f(p.change).norm();
  const double coupled = i.slope(p, along(6), some_r, following(i), step);
  double held = 0;
  for (int k = 0; k < 10; ++k) {
    held = std::max(held, std::abs(i.slope(p, along(k), some_r, frozen(size), step)));
  }
  // With the ball held fixed: L_A(Δu*, Λ) <= L_A* <= L_A(Δu, Λ*).
  const double value = i.lagrangian(p, some_r, frozen(size));
  double violation = 0;
  for (int k = 0; k < 300; ++k) {
    Point in_u = p;
    Point in_l = p;
    const double far = 0.01 * (k + 1);
    for (int j = 0; j < 6; ++j) in_u.change[j] += far * std::sin(1.0 + k * (j + 2));
    in_l.normal += far * std::cos(2.0 * k);
    for (int j = 0; j < 3; ++j) in_l.friction[j] += far * std::sin(3.0 + k * (j + 1));
    violation = std::max({violation, i.lagrangian(in_l, some_r, frozen(size)) - value,
                          value - i.lagrangian(in_u, some_r, frozen(size))});
  }
  return {absolute(0, coupled / scale), absolute(0, std::max(held, violation) / scale), differences,
          "At the solution of a sliding contact ∂L_A/∂Λ_N = " + text(coupled) +
              " = Φ(γ_F)/Λ_N with B_F(Λ_N): not stationary. With B_F held at the solution's size all "
              "derivatives are "
              "below " +
              text(held, 2) + " and 600 points around violate the saddle by " + text(violation, 2)};
}

Finding size_of_r() {
  const Inclusion i = sticking();
  const double limit = 2 / i.largest_eigenvalue();
  const Point p = i.solve();
  const auto error = [&](double r) { return std::abs(i.iterate(r, 1500).normal / p.normal - 1); };
  Eigen::Matrix<double, 6, 4> w;
  w << i.w_n, i.w_f;
  const auto condition = [&](double r) {
    const Eigen::Matrix<double, 6, 6> a = i.mass + r * w * w.transpose();
    const Vector6 e = a.selfadjointView<Eigen::Lower>().eigenvalues();
    return e.maxCoeff() / e.minCoeff();
  };
  const double above = error(1.05 * limit);
  const double below = error(0.95 * limit);
  return {absolute(0, above), absolute(0, below), 1e-6,
          "Sticking contact: r = 1.05·2/λ_max(WᵀM⁻¹W) ends " + text(above, 2) +
              " off in Λ_N, r = 0.95·2/λ_max " + text(below, 2) +
              ", while the condition of M + rWWᵀ there is " + text(condition(1.05 * limit), 3) +
              " (M: " + text(condition(0), 3) + "); step 1 solves with M, whatever r"};
}

Finding first_step() {
  const Inclusion i = sliding();
  const Point p = off_solution();
  const Vector6 change = i.motion(p.normal, p.friction);
  const Vector6 rest = i.mass * change - i.smooth - i.w_n * p.normal - i.w_f * p.friction;
  return {absolute(0, rest.norm()),
          {},
          1e-13,
          "It is (4.7) for the impulses at hand, to " + text(rest.norm(), 2)};
}

Finding second_step() {
  const Inclusion i = sliding();
  const Point p = i.solve();
  // u^k = u⁻ + Δu^k, the last iterate
  const double r = 0.5 / i.largest_eigenvalue();
  double normal = 0;
  Vector3d friction = Vector3d::Zero();
  Vector6 last = Vector6::Zero();
  for (int k = 0; k < 3000; ++k) {
    const Vector6 change = i.motion(normal, friction);
    normal = std::max(0.0, normal - r * i.gamma_n(change + last));
    friction = hertz_ball::prox(friction - r * i.gamma_f(change + last), i.mu * normal);
    last = change;
  }
  const double through = i.gamma_n(i.motion(normal, friction));
  const Trial meant = relative(p.normal, i.iterate(r, 3000).normal);
  return {relative(p.normal, normal), meant, 1e-9,
          "With u^k = u⁻ + Δu^k the iteration comes to rest at Λ_N = " + text(normal) + " instead of " +
              text(p.normal) + ", where γ_N⁺ = " + text(through) +
              " m/s, through the floor; with u⁻ relative error " + text(meant.error, 2)};
}

Finding stopping() {
  const Inclusion i = sticking();
  const Point p = i.solve();
  const double tolerance = 1e-6 * p.normal;
  const auto off = [&](double r) {
    // passes until ‖ΔΛ_N‖ + ‖ΔΛ_F‖ <= tolerance, and the error then
    double normal = 0;
    Vector3d friction = Vector3d::Zero();
    for (int k = 0; k < 5000; ++k) {
      const Vector6 change = i.motion(normal, friction);
      const double n = std::max(0.0, normal - r * i.gamma_n(change));
      const Vector3d f = hertz_ball::prox(friction - r * i.gamma_f(change), i.mu * n);
      const double moved = std::abs(n - normal) + (f - friction).norm();
      normal = n;
      friction = f;
      if (moved <= tolerance) break;
    }
    return std::hypot(normal - p.normal, (friction - p.friction).norm()) / p.normal;
  };
  // ours: ‖Λ − Π(Λ − ργ)‖ with a ρ that does not follow r
  const double safe = 1 / i.largest_eigenvalue();
  const auto residual = [&](const Point& x) {
    const double n = project_n(i, x, safe);
    return std::hypot(x.normal - n, (x.friction - project_f(i, x, safe, i.mu * n)).norm()) / p.normal;
  };
  const auto error = [&](const Point& x) {
    return std::hypot(x.normal - p.normal, (x.friction - p.friction).norm()) / p.normal;
  };
  int passes = 1;
  while (residual(i.iterate(safe / 2, passes)) > 1e-6) passes *= 2;
  const double tiny = off(1e-7);
  const double ours = error(i.iterate(safe / 2, passes));
  // In stick the error is at most the condition of WᵀM⁻¹W, here below 1e3, times the residual.
  return {absolute(0, tiny), absolute(0, ours), 1e-3,
          "Tolerance 1e-6 of Λ_N: with r = 0.5/λ_max the impulses are then right to " +
              text(off(0.5 * safe), 2) + " of Λ_N, with r = 0.01/λ_max to " + text(off(0.01 * safe), 2) +
              ", with r = 1e-7 kg it ends at once, " + text(tiny, 2) +
              " off. By the natural map's residual: that r does not end (residual " +
              text(residual(i.iterate(1e-7, 1)), 2) + "), 0.5/λ_max ends " + text(ours, 2) + " off"};
}

}  // namespace

std::vector<Row> augmented_lagrangian() {
  return {
      {"4.10", "(4.10)",
       "L_A = ½‖Δu − M⁻¹hΔt‖²_M − γ_NᵀΛ_N − γ_FᵀΛ_F + (r/2)‖γ_N‖² − (1/2r) dist²_{C_N}(Λ_N − rγ_N) + the "
       "same for F",
       Flaw::none, "", "Read with B_F held fixed; see (4.15).", lagrangian_as_maximum},
      {"4.11", "(4.11)", "L = ½‖Δu − M⁻¹hΔt‖²_M − γ_NᵀΛ_N − γ_FᵀΛ_F", Flaw::none, "", "", plain_lagrangian},
      {"4.12", "(4.12)", "prox_C(x) = argmin_{x* ∈ C} ‖x − x*‖, dist_C(x) = ‖x − prox_C(x)‖", Flaw::none, "",
       "Needs a convex closed set, which (2.19) and (3.21) are not when cut after three terms.",
       nearest_point},
      {"4.13", "(4.13)", "∇½dist²_C(x) = x − prox_C(x)", Flaw::none, "", "", distance_gradient},
      {"4.14", "(4.14)", "f = −xᵀy + ½‖x‖² − ½dist²_C(y − x) ⟹ ∇f = −prox_C(y − x)", Flaw::none, "", "",
       function_gradient},
      {"4.15", "(4.15)", "∇L_A: MΔu − hΔt − W_NΠ_N − W_FΠ_F; −(1/r)(Λ_N − Π_N); −(1/r)(Λ_F − Π_F)",
       Flaw::none, "", "With B_F held fixed while differentiating; see the next row.",
       stationarity_conditions},
      {"4.15.moving", "(4.15), B_F dependent on the normal force", "∇_{Λ_N}L_A = −(1/r)(Λ_N − Π_N)",
       Flaw::wrong,
       "… + (μ/r) dist_{B_F}(Λ_F − rγ_F) times the support function of the ball of size 1, unless B_F is "
       "held fixed",
       "L_A of (4.10) with B_F(Λ_N), as the text has it, does not have these derivatives: hence “quasi”. The "
       "equations (4.17) are right and stand on their own.",
       moving_ball},
      {"4.16", "(4.16)", "Π_F = prox_{B_F(Λ_N)}(Λ_F − rγ_F)", Flaw::imprecise, "B_F(prox_{R+}(Λ_N − rγ_N))",
       "The footnote says so, and step 2 does so; a Newton method needs it.", defined_everywhere},
      {"4.16.footnote", "(4.16), footnote 1", "B_F = B_F(prox_{R+}(Λ_N − rγ_N))", Flaw::none, "", "",
       same_at_solution},
      {"4.17", "(4.17)", "MΔu − hΔt − W_NΠ_N − W_FΠ_F = 0, Λ_N = Π_N, Λ_F = Π_F", Flaw::none, "",
       "The inclusions (4.7) to (4.9), for every r > 0. What the library's solvers solve.",
       equations_are_the_inclusion},
      {"4.1.saddle", "Section 4.1, saddle-point",
       "The solution to the algebraic inclusion then corresponds to a saddle-point of the Augmented "
       "Lagrangian",
       Flaw::wrong, "of the Augmented Lagrangian with B_F held at the size that the solution gives it",
       "True without friction, or with a friction that does not follow Λ_N. The coupled problem is no "
       "optimisation: a "
       "descent of L_A proves nothing, and convergence needs other arguments.",
       saddle_point},
      {"4.1.r", "Section 4.1, the value of r",
       "large enough to make the problem well conditioned, but not too high in order to prevent "
       "ill-conditioning due "
       "to the penalty term",
       Flaw::imprecise, "0 < r < 2/λ_max(WᵀM⁻¹W) for the Modified Newton Method, and near the upper end",
       "The iteration never sees the penalty's matrix; too high an r makes it cycle or diverge. Numbers in "
       "augmented_r.tsv.",
       size_of_r},
      {"4.1.step1", "Section 4.1, step 1", "MΔu^{k+1} = hΔt + W_NΛ_N^k + W_FΛ_F^k", Flaw::none, "",
       "That is the minimum of L, not of L_A: the method is Uzawa's.", first_step},
      {"4.1.step2", "Section 4.1, step 2", "γ^{k+1} = Wᵀ(Δu^{k+1} + u^k) + w", Flaw::misprint,
       "u⁻ for u^k, w̃ for w", "(4.9) has u⁻. The library does what is meant.", second_step},
      {"4.1.stop", "Section 4.1, stopping", "until the error ‖ΔΛ_N‖ + ‖ΔΛ_F‖ is within some tolerance",
       Flaw::imprecise, "until a residual that does not shrink with r is",
       "The change is not the error: it is r times a residual, and 1/(1 − rate) times smaller than the "
       "error. The "
       "library ends by the natural map's residual.",
       stopping},
  };
}

}  // namespace verify::ledger
