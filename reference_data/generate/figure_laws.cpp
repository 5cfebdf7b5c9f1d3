#include "figure_laws.hpp"

#include <arb_hypgeom.h>

namespace reference {

Ball exact(double x) { return Ball(x, bits); }

namespace {

Ball gauss(const Ball& a, const Ball& b, const Ball& c, const Ball& z) {
  Ball r(bits);
  arb_hypgeom_2f1(r.raw(), a.raw(), b.raw(), c.raw(), z.raw(), 0, bits);
  return r;
}

}  // namespace

Pair law(const Ball& n, const Ball& v, const Ball& s) {
  const Ball half = exact(0.5);
  if (arb_le(v.raw(), s.raw()) != 0) {
    const Ball u = v / s, m = u * u;
    const Ball a = (n + 1.0) * beta(exact(1.5), n + 1.0);
    return {a * (n + 1.5) * u * gauss(half, -0.5 - n, exact(2), m), a * gauss(half, -1.5 - n, exact(1), m)};
  }
  const Ball w = s / v, m = w * w;
  return {gauss(half, exact(-0.5), n + 2.0, m), w * gauss(half, half, n + 3.0, m) / (2.0 * (n + 2.0))};
}
Pair law(const Ball& n, double v, double s) { return law(n, exact(v), exact(s)); }

Ball potential(const Ball& n, double v, double s) {
  const Ball minus_half = exact(-0.5);
  if (v <= s) {
    const Ball u = exact(v) / exact(s);
    return exact(s) * (n + 1.0) * beta(exact(1.5), n + 1.0) * gauss(minus_half, -1.5 - n, exact(1), u * u);
  }
  const Ball w = exact(s) / exact(v);
  return exact(v) * gauss(minus_half, minus_half, n + 2.0, w * w);
}

namespace {

// y = η² of the second branch of LG03 (2.18) at ξ: 4y − (20/3) y² + (40/9) y³ = 1 − ξ², by bisection. The
// cubic rises everywhere (its derivative has no real root), so its sign at the middle decides for certain.
Ball printed_outer(const Ball& xi) {
  const Ball rest = (1.0 - xi) * (1.0 + xi);
  if (arb_is_zero(rest.raw()) != 0) return exact(0);
  Ball low = exact(0), high = exact(0.5);
  for (int i = 0; i < 200; ++i) {
    const Ball y = (low + high) * 0.5;
    const Ball value = y * (4.0 - y * (exact(20) / 3.0 - y * (exact(40) / 9.0))) - rest;
    if (arb_is_positive(value.raw()) != 0) {
      high = y;
    } else if (arb_is_negative(value.raw()) != 0) {
      low = y;
    } else {
      break;  // closer to the root than the precision can tell
    }
  }
  return sqrt((low + high) * 0.5);
}

}  // namespace

std::vector<Printed> printed_border() {
  std::vector<Printed> border;
  const Ball seam = exact(55) / 64.0;
  for (int k = 0; k <= 32; ++k) {
    const Ball xi = seam * exact(k) / 32.0, x = xi * xi;
    const Ball rest = 1.0 - 1.5 * x + (exact(15) / 32.0) * x * x + (exact(5) / 128.0) * x * x * x;
    border.push_back({"inner", {xi, sqrt(rest) * 2.0 / 3.0}});
  }
  for (int k = 32; k >= 0; --k) {
    const Ball xi = 1.0 - (1.0 - seam) * exact(k * k) / 1024.0;
    border.push_back({"outer", {xi, printed_outer(xi)}});
  }
  return border;
}

// With the normal (v, 1 − v) of the border, v
// in [0, 1], the sign of (t − ξ)(1 − v) − (τ − η)v says on which side of it the point lies. By bisection, v
// exact.
Pair nearest(const Ball& n, double t, double tau) {
  if (t == 0) return law(n, 0, 1);
  if (tau == 0) return law(n, 1, 0);
  Ball low = exact(0), high = exact(1);
  for (int i = 0; i < 120; ++i) {
    const Ball v = (low + high) * 0.5;
    const Pair x = law(n, v, 1.0 - v);
    const Ball side = (t - x.xi) * (1.0 - v) - (tau - x.eta) * v;
    if (arb_is_positive(side.raw()) != 0) {
      low = v;
    } else if (arb_is_negative(side.raw()) != 0) {
      high = v;
    } else {
      break;  // closer to the root than the precision can tell
    }
  }
  Ball v(bits);
  arb_union(v.raw(), low.raw(), high.raw(), bits);
  return law(n, v, 1.0 - v);
}

}  // namespace reference
