#pragma once

#include <array>

#include "adaptive.hpp"

namespace verify {

/// What is integrated over the disc, for R = 1, ω = 1, v = u, μλ_N = 1.
enum class Quantity { potential, force, torque, curvature, load };

/// The four quantities of the law; `load` (∬σ dA = 1) checks the coordinates themselves.
inline constexpr std::array law_quantities{Quantity::potential, Quantity::force, Quantity::torque,
                                           Quantity::curvature};

constexpr const char* name(Quantity q) {
  switch (q) {
    case Quantity::potential:
      return "phi";
    case Quantity::force:
      return "xi";
    case Quantity::torque:
      return "eta";
    case Quantity::curvature:
      return "curvature";
    case Quantity::load:
      return "load";
  }
  return "";
}

/// Relative tolerance of the outer and of the inner integrals. Everything the quadrature is compared with is
/// held to their sum plus `rounding`: some hundred roundings of 2^-53 on the way to one integrand, none of
/// them amplified because no integrand cancels.
constexpr double outer_tolerance = 1e-12;
constexpr double inner_tolerance = 1e-13;
constexpr double rounding = 100 * 0x1p-53;
constexpr double quadrature_bound = outer_tolerance + inner_tolerance + rounding;

}  // namespace verify
