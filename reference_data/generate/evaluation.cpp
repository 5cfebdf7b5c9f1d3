#include "evaluation.hpp"

#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "chord_integrals.hpp"
#include "closed_forms.hpp"
#include "decimal.hpp"
#include "hypergeometric.hpp"
#include "ring_integrals.hpp"

namespace reference {

namespace {

[[noreturn]] void fail(double n, double u, const std::string& what) {
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, u).ptr;
  throw std::runtime_error("n = " + std::to_string(n) + ", u = " + std::string(text, end) + ": " + what);
}

/// log2 of radius/|value|, an upper estimate.
double relative_radius(const Ball& x) { return -static_cast<double>(arb_rel_accuracy_bits(x.raw())); }

/// Two enclosures of one number: they must meet, and the second must be narrow enough for that to say
/// something about the first thirty digits (2^-100 < 10^-30).
void agree(double n, double u, const std::string& route, const Ball& stored, const Ball& other,
           double& widest) {
  constexpr double thirty_digits = -100;
  widest = std::max(widest, relative_radius(other));
  if (!overlap(stored, other)) fail(n, u, route + " and hypergeometric balls do not meet");
  if (relative_radius(other) > thirty_digits) fail(n, u, route + " ball is too wide to prove anything");
}

void agree(double n, double u, const std::string& route, const Scaled& stored, const Scaled& other,
           double& widest) {
  agree(n, u, route + " force", stored.force, other.force, widest);
  agree(n, u, route + " torque", stored.torque, other.torque, widest);
  agree(n, u, route + " second derivative", stored.second, other.second, widest);
}

/// Bits that leave about 160 after the cancellation in the closed forms, which is at most m^-3 = u^±6.
long closed_form_bits(double u) { return 192 + 6 * (1 + std::abs(std::ilogb(u))); }

struct Settled {
  Scaled scaled;
  Ball potential;  ///< f for u <= 1, f/u for u > 1
  Entries entries;
};

std::optional<Settled> try_with(double n_in, double u, long bits, Proof& proof) {
  const Ball n(n_in, bits);
  const Argument at(u, bits);
  Settled s{by_hypergeometric(n, at), potential_by_hypergeometric(n, at), {}};
  const Ball phi = s.potential / sqrt(1.0 + at.m);
  const Ball xi = at.inner ? at.u * s.scaled.force : s.scaled.force;
  const Ball eta = at.inner ? s.scaled.torque : s.scaled.torque / at.u;
  const Ball* const values[] = {&phi, &xi, &eta, &s.scaled.second};
  double widest = proof.widest_stored;
  for (std::size_t i = 0; i < s.entries.size(); ++i) {
    const auto text = correctly_rounded(*values[i], digits);
    if (!text) return std::nullopt;
    s.entries[i] = *text;
    if (*text != "0") widest = std::max(widest, relative_radius(*values[i]));
  }
  proof.widest_stored = widest;
  return s;
}

}  // namespace

Entries evaluate(double n, double u, Checks checks, Proof& proof) {
  constexpr long first_bits = 192;
  constexpr long last_bits = 16384;
  std::optional<Settled> settled;
  long bits = first_bits;
  for (; bits <= last_bits; bits *= 2) {
    settled = try_with(n, u, bits, proof);
    if (settled) break;
  }
  if (!settled) fail(n, u, "the last digit does not settle");
  ++proof.rows;
  proof.most_bits = std::max(proof.most_bits, bits);

  const Argument at(u, bits);
  const Scaled& stored = settled->scaled;
  const Ball euler =
      at.inner ? at.u * at.u * stored.force + stored.torque : stored.force + at.m * stored.torque;
  if (!overlap(settled->potential, euler)) fail(n, u, "f = u xi + eta does not hold");

  if (u != 0 && n == 0 && u != 1) {
    agree(n, u, "elliptic", stored, uniform_closed_form(Argument(u, closed_form_bits(u))),
          proof.widest_closed);
    ++proof.closed;
  }
  if (u != 0 && n == 0.5) {
    agree(n, u, "elementary", stored, hertz_closed_form(Argument(u, closed_form_bits(u))),
          proof.widest_closed);
    ++proof.closed;
  }
  constexpr long integration_bits = 128;
  if (checks.chords) {
    agree(n, u, "chord", stored, by_chord_integrals(Ball(n, integration_bits), Argument(u, integration_bits)),
          proof.widest_chord);
    ++proof.chords;
  }
  if (checks.rings) {
    const ForceAndTorque rings = by_ring_integrals(Ball(n, integration_bits), Argument(u, integration_bits));
    agree(n, u, "ring force", stored.force, rings.force, proof.widest_ring);
    agree(n, u, "ring torque", stored.torque, rings.torque, proof.widest_ring);
    ++proof.rings;
  }
  return settled->entries;
}

Entries at_infinity(double n) {
  const auto tail = correctly_rounded(0.5 / (Ball(n, 256) + 2.0), digits);
  if (!tail) throw std::runtime_error("the tail 1/(2(2+n)) does not settle");
  return {"1", "1", "0", *tail};
}

}  // namespace reference
