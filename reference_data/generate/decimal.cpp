#include "decimal.hpp"

#include <arf.h>
#include <fmpz.h>

#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace reference {

namespace {

/// An integer of any size (FLINT's fmpz_t).
class Integer {
 public:
  explicit Integer(unsigned long value = 0) { fmpz_init_set_ui(value_, value); }
  Integer(const Integer&) = delete;
  Integer& operator=(const Integer&) = delete;
  ~Integer() { fmpz_clear(value_); }
  fmpz* raw() { return value_; }
  const fmpz* raw() const { return value_; }

 private:
  fmpz_t value_;
};

/// x multiplied by base^exponent, exponent >= 0.
void scale(Integer& x, unsigned long base, long exponent) {
  Integer power(base);
  fmpz_pow_ui(power.raw(), power.raw(), static_cast<unsigned long>(exponent));
  fmpz_mul(x.raw(), x.raw(), power.raw());
}

/// quotient = |mantissa| 2^binary 10^decimal, rounded to nearest, ties to even.
void round_scaled(Integer& quotient, const Integer& mantissa, long binary, long decimal) {
  Integer numerator(1);
  Integer denominator(1);
  fmpz_abs(numerator.raw(), mantissa.raw());
  scale(binary > 0 ? numerator : denominator, 2, std::abs(binary));
  scale(decimal > 0 ? numerator : denominator, 10, std::abs(decimal));
  Integer rest;
  fmpz_fdiv_qr(quotient.raw(), rest.raw(), numerator.raw(), denominator.raw());
  fmpz_mul_2exp(rest.raw(), rest.raw(), 1);
  const int half = fmpz_cmp(rest.raw(), denominator.raw());
  if (half > 0 || (half == 0 && fmpz_is_odd(quotient.raw()))) fmpz_add_ui(quotient.raw(), quotient.raw(), 1);
}

/// The number itself, exactly a binary fraction, to `digits`
/// decimals; in integers, so that nothing is left to proof.
std::string rounded(arf_srcptr x, int digits) {
  Integer mantissa;
  Integer exponent;
  arf_get_fmpz_2exp(mantissa.raw(), exponent.raw(), x);
  const long binary = fmpz_get_si(exponent.raw());
  Integer limit(10);
  fmpz_pow_ui(limit.raw(), limit.raw(), static_cast<unsigned long>(digits));

  const double log2_x = static_cast<double>(fmpz_bits(mantissa.raw())) + static_cast<double>(binary);
  long ten =
      static_cast<long>(std::floor((log2_x - 1) * std::log10(2.0))) - 1;  // at most the decimal exponent
  Integer quotient;
  for (;; ++ten) {
    round_scaled(quotient, mantissa, binary, digits - 1 - ten);
    if (fmpz_cmp(quotient.raw(), limit.raw()) < 0) break;
  }
  char* text = fmpz_get_str(nullptr, 10, quotient.raw());
  std::string decimal;
  if (fmpz_sgn(mantissa.raw()) < 0) decimal += '-';
  decimal += text[0];
  decimal += '.';
  decimal += text + 1;
  flint_free(text);
  const std::string magnitude = std::to_string(std::abs(ten));
  decimal += ten < 0 ? "e-" : "e+";
  if (magnitude.size() < 2) decimal += '0';
  return decimal + magnitude;
}

/// Both ends of a ball, as binary fractions outside of it or on its boundary.
struct Ends {
  explicit Ends(const Ball& value) {
    arf_init(lower);
    arf_init(upper);
    arb_get_lbound_arf(lower, value.raw(), value.bits() + 64);
    arb_get_ubound_arf(upper, value.raw(), value.bits() + 64);
  }
  Ends(const Ends&) = delete;
  Ends& operator=(const Ends&) = delete;
  ~Ends() {
    arf_clear(lower);
    arf_clear(upper);
  }
  arf_t lower;
  arf_t upper;
};

}  // namespace

// Rounding never reverses an order: if both ends of the
// ball round to the same decimal, so does all between them.
std::optional<std::string> correctly_rounded(const Ball& value, int digits) {
  if (!arb_is_finite(value.raw())) return std::nullopt;
  if (arb_is_zero(value.raw())) return "0";
  if (arb_contains_zero(value.raw())) return std::nullopt;
  const Ends ends(value);
  const std::string lower = rounded(ends.lower, digits);
  if (lower != rounded(ends.upper, digits)) return std::nullopt;
  return lower;
}

double nearest_double(const Ball& value) {
  const Ends ends(value);
  const double lower = arf_get_d(ends.lower, ARF_RND_NEAR);
  if (lower != arf_get_d(ends.upper, ARF_RND_NEAR))
    throw std::runtime_error("the nearest double is not settled");
  return lower;
}

}  // namespace reference
