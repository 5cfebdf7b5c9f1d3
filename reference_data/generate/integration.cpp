#include "integration.hpp"

namespace reference {

namespace {

int call(acb_ptr out, const acb_t at, void* parameter, slong order, slong bits) {
  const auto& g = *static_cast<const Integrand*>(parameter);
  g(out, at, order != 0, bits);
  return 0;
}

}  // namespace

Ball integrate(const Integrand& g, const Ball& lower, const Ball& upper) {
  const long bits = std::max(lower.bits(), upper.bits());
  Integrand copy = g;
  Box result;
  Box from;
  Box to;
  acb_set_arb(from.raw(), lower.raw());
  acb_set_arb(to.raw(), upper.raw());

  mag_t tolerance;  // absolute; far below the relative goal for all our integrals (> 1e-10), it only stops
                    // the bisection
  mag_init(tolerance);
  mag_set_ui_2exp_si(tolerance, 1, -(bits + 40));
  acb_calc_integrate_opt_t options;
  acb_calc_integrate_opt_init(options);
  options->depth_limit = 4 * bits;
  options->eval_limit = 1000 * bits;
  acb_calc_integrate(result.raw(), call, &copy, from.raw(), to.raw(), bits, tolerance, options, bits);
  mag_clear(tolerance);

  Ball value(bits);
  acb_get_real(value.raw(), result.raw());
  return value;
}

void power_on_box(acb_ptr out, acb_srcptr base, const Ball& exponent, bool analytic, long bits) {
  if (!analytic && acb_contains_zero(base)) {
    // |base^exponent| <= M^exponent with M the largest |base|: a disc around zero.
    Ball largest(bits);
    mag_t bound;
    mag_init(bound);
    acb_get_mag(bound, base);
    arf_set_mag(arb_midref(largest.raw()), bound);
    mag_clear(bound);
    const Ball radius = pow(largest, exponent);
    acb_zero(out);
    arb_add_error(acb_realref(out), radius.raw());
    arb_add_error(acb_imagref(out), radius.raw());
    return;
  }
  // exp(e log z) throughout: Arb's acb_pow multiplies half-integer powers out, with needlessly wide boxes.
  acb_log_analytic(out, base, analytic, bits);
  acb_mul_arb(out, out, exponent.raw(), bits);
  acb_exp(out, out, bits);
}

}  // namespace reference
