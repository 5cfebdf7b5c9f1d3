#include "chord_integrals.hpp"

#include "integration.hpp"

namespace reference {

namespace {

/// sin² t and cos² t counted from the end of the chord's range, t = π/2 − θ (or π/2 − a), where the
/// integrands are steep and which must therefore be an exact endpoint: here sin t = cos θ.
struct Sines {
  Box sine;
  Box sine_squared;
  Box cosine_squared;
};

Sines sines(acb_srcptr t, long bits) {
  Sines s;
  Box cosine;
  acb_sin_cos(s.sine.raw(), cosine.raw(), t, bits);
  acb_mul(s.sine_squared.raw(), s.sine.raw(), s.sine.raw(), bits);
  acb_mul(s.cosine_squared.raw(), cosine.raw(), cosine.raw(), bits);
  return s;
}

/// 1 − m cos² t = (1 − m) + m sin² t.
void one_minus(acb_ptr out, const Argument& at, const Sines& s, long bits) {
  acb_mul_arb(out, s.sine_squared.raw(), at.m.raw(), bits);
  acb_add_arb(out, out, at.complement.raw(), bits);
}

enum class Weight { one, along, across };  // 1, cos² θ, sin² θ

void apply(acb_ptr out, Weight weight, const Sines& s, long bits) {
  if (weight == Weight::along) acb_mul(out, out, s.sine_squared.raw(), bits);
  if (weight == Weight::across) acb_mul(out, out, s.cosine_squared.raw(), bits);
}

/// ∫_0^π weight Δ^exponent dθ.
Ball inner(const Argument& at, Weight weight, const Ball& exponent) {
  const auto integrand = [&](acb_ptr out, acb_srcptr t, bool analytic, long bits) {
    const Sines s = sines(t, bits);
    Box chord;
    Box power;
    one_minus(chord.raw(), at, s, bits);
    acb_set_arb(power.raw(), exponent.raw());
    acb_pow_analytic(out, chord.raw(), power.raw(), analytic, bits);
    apply(out, weight, s, bits);
  };
  const long bits = at.u.bits();
  return 2.0 * integrate(integrand, Ball(0.0, bits), pi(bits) / 2.0);
}

/// ∫_{−π/2}^{π/2} weight cos^exponent a (1 − w² sin² a)^{±1/2} da.
Ball outer(const Argument& at, Weight weight, const Ball& exponent, bool divide) {
  const auto integrand = [&](acb_ptr out, acb_srcptr t, bool analytic, long bits) {
    const Sines s = sines(t, bits);
    Box root;
    one_minus(root.raw(), at, s, bits);
    if (divide) {
      acb_rsqrt_analytic(root.raw(), root.raw(), analytic, bits);
    } else {
      acb_sqrt_analytic(root.raw(), root.raw(), analytic, bits);
    }
    power_on_box(out, s.sine.raw(), exponent, analytic, bits);
    acb_mul(out, out, root.raw(), bits);
    apply(out, weight, s, bits);
  };
  const long bits = at.u.bits();
  return 2.0 * integrate(integrand, Ball(0.0, bits), pi(bits) / 2.0);
}

/// ∫_{−π/2}^{π/2} cos^exponent a da.
Ball power_of_cosine(const Ball& exponent) {
  const auto integrand = [&](acb_ptr out, acb_srcptr t, bool analytic, long bits) {
    const Sines s = sines(t, bits);
    power_on_box(out, s.sine.raw(), exponent, analytic, bits);
  };
  return 2.0 * integrate(integrand, Ball(0.0, exponent.bits()), pi(exponent.bits()) / 2.0);
}

}  // namespace

Scaled by_chord_integrals(const Ball& n, const Argument& at) {
  const long bits = at.u.bits();
  const Ball length = (n + 1.0) * beta(Ball(0.5, bits), n + 1.0) / pi(bits);  // from ∫ (1−s²)ⁿ ds
  const Ball moment = (n + 1.0) * beta(Ball(1.5, bits), n + 1.0) / pi(bits);  // from ∫ s² (1−s²)ⁿ ds
  if (at.value == 1) {
    const Ball common = power_of_cosine(2.0 * n + 3.0);
    return {length * common, moment * common, length * common / (2.0 * n + 2.0)};
  }
  if (at.inner) {
    return {length * inner(at, Weight::along, n + 0.5), moment * inner(at, Weight::one, n + 1.5),
            length * inner(at, Weight::across, n + 0.5)};
  }
  return {length * outer(at, Weight::one, 2.0 * n + 2.0, false),
          moment * outer(at, Weight::one, 2.0 * n + 4.0, true),
          length * outer(at, Weight::across, 2.0 * n + 2.0, true)};
}

}  // namespace reference
