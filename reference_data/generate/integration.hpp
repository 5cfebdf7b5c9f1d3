#pragma once

#include <acb.h>
#include <acb_calc.h>

#include <functional>
#include <memory>

#include "ball.hpp"

namespace reference {

/// A complex box (Arb's acb_t).
class Box {
 public:
  Box() { acb_init(value_); }
  Box(const Box& other) : Box() { acb_set(value_, other.value_); }
  Box& operator=(const Box& other) {
    acb_set(value_, other.value_);
    return *this;
  }
  ~Box() { acb_clear(value_); }
  acb_ptr raw() { return value_; }
  acb_srcptr raw() const { return value_; }

 private:
  acb_t value_;
};

/// Puts an enclosure of the integrand on the box `at` into `out`. Where `analytic`, the enclosure must be
/// infinite unless the integrand is analytic on the whole box.
using Integrand = std::function<void(acb_ptr out, acb_srcptr at, bool analytic, long bits)>;

/// Encloses ∫_lower^upper g(t) dt, g real on the real interval.
Ball integrate(const Integrand& g, const Ball& lower, const Ball& upper);

/// base^exponent on a box, exponent >= 0; on a box that touches zero still finite where the integrand need
/// not be analytic (an interval that ends at a branch point).
void power_on_box(acb_ptr out, acb_srcptr base, const Ball& exponent, bool analytic, long bits);

}  // namespace reference
