#pragma once

#include <arb.h>
#include <arb_hypgeom.h>

#include <algorithm>

namespace reference {

/// A real number known to lie in [mid - rad, mid + rad] (Arb's arb_t), together
/// with the precision in bits it is worked with. Every operation encloses its
/// exact result; operands of different precision give the higher one.
class Ball {
 public:
  explicit Ball(long bits) : bits_(bits) { arb_init(value_); }
  /// The double itself, exactly.
  Ball(double value, long bits) : Ball(bits) { arb_set_d(value_, value); }
  Ball(const Ball& other) : Ball(other.bits_) { arb_set(value_, other.value_); }
  Ball& operator=(const Ball& other) {
    arb_set(value_, other.value_);
    bits_ = other.bits_;
    return *this;
  }
  ~Ball() { arb_clear(value_); }

  arb_ptr raw() { return value_; }
  arb_srcptr raw() const { return value_; }
  long bits() const { return bits_; }

 private:
  arb_t value_;
  long bits_;
};

inline Ball operator+(const Ball& a, const Ball& b) {
  Ball r(std::max(a.bits(), b.bits()));
  arb_add(r.raw(), a.raw(), b.raw(), r.bits());
  return r;
}
inline Ball operator-(const Ball& a, const Ball& b) {
  Ball r(std::max(a.bits(), b.bits()));
  arb_sub(r.raw(), a.raw(), b.raw(), r.bits());
  return r;
}
inline Ball operator*(const Ball& a, const Ball& b) {
  Ball r(std::max(a.bits(), b.bits()));
  arb_mul(r.raw(), a.raw(), b.raw(), r.bits());
  return r;
}
inline Ball operator/(const Ball& a, const Ball& b) {
  Ball r(std::max(a.bits(), b.bits()));
  arb_div(r.raw(), a.raw(), b.raw(), r.bits());
  return r;
}

// Doubles enter exactly; only those with an exact meaning (1, 0.5, 64, ...) should be written in a formula.
inline Ball operator+(const Ball& a, double b) { return a + Ball(b, a.bits()); }
inline Ball operator-(const Ball& a, double b) { return a - Ball(b, a.bits()); }
inline Ball operator*(const Ball& a, double b) { return a * Ball(b, a.bits()); }
inline Ball operator/(const Ball& a, double b) { return a / Ball(b, a.bits()); }
inline Ball operator+(double a, const Ball& b) { return Ball(a, b.bits()) + b; }
inline Ball operator-(double a, const Ball& b) { return Ball(a, b.bits()) - b; }
inline Ball operator*(double a, const Ball& b) { return Ball(a, b.bits()) * b; }
inline Ball operator/(double a, const Ball& b) { return Ball(a, b.bits()) / b; }

inline Ball sqrt(const Ball& x) {
  Ball r(x.bits());
  arb_sqrt(r.raw(), x.raw(), r.bits());
  return r;
}
inline Ball asin(const Ball& x) {
  Ball r(x.bits());
  arb_asin(r.raw(), x.raw(), r.bits());
  return r;
}
inline Ball pow(const Ball& base, const Ball& exponent) {
  Ball r(std::max(base.bits(), exponent.bits()));
  arb_pow(r.raw(), base.raw(), exponent.raw(), r.bits());
  return r;
}
inline Ball gamma(const Ball& x) {
  Ball r(x.bits());
  arb_gamma(r.raw(), x.raw(), r.bits());
  return r;
}
inline Ball pi(long bits) {
  Ball r(bits);
  arb_const_pi(r.raw(), bits);
  return r;
}
/// B(a, b) = Γ(a) Γ(b)/Γ(a + b).
inline Ball beta(const Ball& a, const Ball& b) { return gamma(a) * gamma(b) / gamma(a + b); }

/// May both be the same number? (False is a proof that they are not.)
inline bool overlap(const Ball& a, const Ball& b) { return arb_overlaps(a.raw(), b.raw()) != 0; }
/// Radius/|value| <= 2^-bits for certain.
inline bool relatively_within(const Ball& a, long bits) { return arb_rel_accuracy_bits(a.raw()) > bits; }

}  // namespace reference
