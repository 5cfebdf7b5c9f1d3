#pragma once

#include <span>

namespace contensou {

/// Where a batch goes: phi, xi, eta as in `Reduced`, each as long as u. One of them may be where u is (in
/// place); they must not overlap otherwise.
struct ReducedBatch {
  std::span<double> phi;
  std::span<double> xi;
  std::span<double> eta;
};

/// `reduced(UniformLaw{}, u)` for many u at once, vectorised for the machine it runs on (chosen at load
/// time). u in [0, ∞]; NaN and negative u give NaN in their own row only (a batch does not throw half-way).
/// Throws std::invalid_argument if the lengths differ. Same accuracy as the scalar law, not the same bits.
void reduced_uniform(std::span<const double> u, ReducedBatch out);
/// `reduced(HertzLaw{}, u)` for many u.
void reduced_hertz(std::span<const double> u, ReducedBatch out);

}  // namespace contensou
