#pragma once

#include <array>
#include <optional>

#include "contensou/integrate/motion.hpp"

namespace contensou {

/// The tippe-top of LG03 Section 5: a body (sphere of radius r1 about M) and the tip of its stick (sphere of
/// radius r2 about N) on the floor z = 0; S is the centre of mass, M and N lie at a1 and a2 from it on the
/// axis. The defaults are the data of LG03 5.4 (Friedl 1997).
struct TippeTopData {
  double m = 6e-3;     ///< [kg] > 0
  double i1 = 8e-7;    ///< [kg m²] > 0, across the axis
  double i3 = 7e-7;    ///< [kg m²] > 0, about the axis; <= 2 i1
  double g = 9.81;     ///< [m/s²]
  double a1 = 0.3e-2;  ///< S to M [m]
  double a2 = 1.6e-2;  ///< S to N [m]
  double r1 = 1.5e-2;  ///< [m] > 0
  double r2 = 0.5e-2;  ///< [m] > 0
};

/// What both formulations of the tippe-top tell, whatever their coordinates. Contacts: 0 `body`, 1 `tip`.
class TippeTopModel : public MechanicalSystem {
 public:
  const TippeTopData& data() const { return data_; }

  /// The state of LG03 5.4 at t = 0: inclined by theta about e_1 (φ = ψ = 0), θ̇ = φ̇ = 0, spinning with ψ̇ about
  /// its own axis, v_S = 0; z_S as given, else so that the lower contact just touches (its gap exactly zero).
  virtual State start(double theta, double psi_dot, std::optional<double> z_s = {}) const = 0;

  virtual double inclination(ConstVector q) const = 0;                ///< θ [rad], 0 to π
  virtual double height(ConstVector q) const = 0;                     ///< z_S [m]
  virtual Eigen::Vector3d axis(ConstVector q) const = 0;              ///< e_3^4 in the floor's axes
  virtual Eigen::Vector3d spin(ConstVector q, ConstVector u) const = 0;  ///< ω in the floor's axes [rad/s]

 protected:
  /// Contacts `body` and `tip` in this order. Throws std::invalid_argument for data or contacts that make no
  /// sense, in one line.
  TippeTopModel(const TippeTopData& data, std::array<SystemContact, 2> contacts);

 private:
  TippeTopData data_;
};

}  // namespace contensou
