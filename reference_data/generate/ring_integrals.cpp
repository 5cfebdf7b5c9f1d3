#include "ring_integrals.hpp"

#include <acb_elliptic.h>

#include <algorithm>

#include "integration.hpp"

namespace reference {

namespace {

/// Does the box touch the branch cut [1, ∞) of K and E? (Boxes that reach beyond Re m = 1 without touching it
/// do not arise, as all boxes lie about a real interval; they are counted as touching.)
bool on_cut(acb_srcptr m) {
  Ball distance(64);
  arb_sub_ui(distance.raw(), acb_realref(m), 1, 64);
  return !arb_is_negative(distance.raw());
}

void set_interval(acb_ptr out, const Ball& lower, const Ball& upper) {
  acb_zero(out);
  arb_union(acb_realref(out), lower.raw(), upper.raw(), lower.bits());
}

/// All complex numbers of magnitude <= radius.
void set_disc(acb_ptr out, const Ball& radius) {
  acb_zero(out);
  arb_add_error(acb_realref(out), radius.raw());
  arb_add_error(acb_imagref(out), radius.raw());
}

/// Wider than a point that is only rounded, as seen from either end of 0 <= m <= 1?
bool is_wide(acb_srcptr m, acb_srcptr complement) {
  constexpr long point_bits = 16;
  return std::min(acb_rel_accuracy_bits(m), acb_rel_accuracy_bits(complement)) < point_bits;
}

/// E and E − (1−m) K of parameter m = x², 0 <= x <= 1 on the real line.
struct Elliptic {
  Box e;
  Box difference;
};

Elliptic elliptic(acb_srcptr m, bool analytic, long bits) {
  Elliptic r;
  if (on_cut(m)) {
    if (analytic) {
      acb_indeterminate(r.e.raw());
      acb_indeterminate(r.difference.raw());
    } else {
      // Real 0 <= m <= 1: E falls from π/2 to 1, and E − (1−m) K rises from 0 to 1.
      const Ball one(1.0, bits);
      set_interval(r.e.raw(), one, pi(bits) / 2.0);
      set_interval(r.difference.raw(), Ball(0.0, bits), one);
    }
    return r;
  }
  Box complement;  // m − 1
  acb_sub_ui(complement.raw(), m, 1, bits);
  if (is_wide(m, complement.raw())) {
    // Arb's E and K are of little use on wide boxes; the integration needs
    // a bound there, not a value. As Re m <= 1, |E| = |∫ √(1 − m sin²)| <=
    // (π/2) √(1 + |m|) and |E − (1−m) K| = |m ∫ cos²/√(1 − m sin²)| <= |m|.
    Ball size(bits);
    acb_abs(size.raw(), m, bits);
    set_disc(r.e.raw(), pi(bits) / 2.0 * sqrt(1.0 + size));
    set_disc(r.difference.raw(), size);
    return r;
  }
  Box k;
  acb_elliptic_k(k.raw(), m, bits);
  acb_elliptic_e(r.e.raw(), m, bits);
  acb_mul(r.difference.raw(), complement.raw(), k.raw(), bits);
  acb_add(r.difference.raw(), r.difference.raw(), r.e.raw(), bits);
  return r;
}

/// ρ (1−ρ²)ⁿ.
void share(acb_ptr out, acb_srcptr rho, const Ball& n, bool analytic, long bits) {
  if (arb_is_zero(n.raw())) {
    acb_set(out, rho);
    return;
  }
  Box one_minus;
  Box one_plus;
  acb_sub_ui(one_minus.raw(), rho, 1, bits);
  acb_neg(one_minus.raw(), one_minus.raw());
  acb_add_ui(one_plus.raw(), rho, 1, bits);
  acb_mul(one_minus.raw(), one_minus.raw(), one_plus.raw(), bits);
  power_on_box(out, one_minus.raw(), n, analytic, bits);
  acb_mul(out, out, rho, bits);
}

enum class Wanted { force, torque };

/// ∫ over the rings inside the pole, ρ from 0 to min(u, 1); force ξ, torque η/u.
Ball rings_inside(const Ball& n, const Argument& at, Wanted wanted) {
  const auto integrand = [&](acb_ptr out, acb_srcptr rho, bool analytic, long bits) {
    Box x;
    Box m;
    acb_div_arb(x.raw(), rho, at.u.raw(), bits);
    acb_mul(m.raw(), x.raw(), x.raw(), bits);
    const Elliptic k = elliptic(m.raw(), analytic, bits);
    share(out, rho, n, analytic, bits);
    acb_mul(out, out, wanted == Wanted::force ? k.e.raw() : k.difference.raw(), bits);
  };
  const long bits = at.u.bits();
  return integrate(integrand, Ball(0.0, bits), at.inner ? at.u : Ball(1.0, bits));
}

/// ∫ over the rings around the pole, ρ from u to 1; force ξ, torque η.
Ball rings_around(const Ball& n, const Argument& at, Wanted wanted) {
  const auto integrand = [&](acb_ptr out, acb_srcptr rho, bool analytic, long bits) {
    Box x;
    Box m;
    acb_inv(x.raw(), rho, bits);
    acb_mul_arb(x.raw(), x.raw(), at.u.raw(), bits);
    acb_mul(m.raw(), x.raw(), x.raw(), bits);
    const Elliptic k = elliptic(m.raw(), analytic, bits);
    share(out, rho, n, analytic, bits);
    if (wanted == Wanted::torque) {
      acb_mul(out, out, rho, bits);
      acb_mul(out, out, k.e.raw(), bits);
    } else {
      acb_mul(out, out, k.difference.raw(), bits);
      acb_div(out, out, x.raw(), bits);
    }
  };
  const long bits = at.u.bits();
  return integrate(integrand, at.u, Ball(1.0, bits));
}

}  // namespace

ForceAndTorque by_ring_integrals(const Ball& n, const Argument& at) {
  const Ball factor = 4.0 * (n + 1.0) / pi(at.u.bits());
  Ball force = factor * rings_inside(n, at, Wanted::force);
  Ball torque = factor * at.u * rings_inside(n, at, Wanted::torque);
  if (at.value < 1) {
    force = force + factor * rings_around(n, at, Wanted::force);
    torque = torque + factor * rings_around(n, at, Wanted::torque);
  }
  if (at.inner) return {force / at.u, torque};
  return {force, torque * at.u};
}

}  // namespace reference
