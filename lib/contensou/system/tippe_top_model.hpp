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

/// Contacts `body` and `tip` with the same friction; the defaults are the data of LG03 5.4.
std::array<SystemContact, 2> tippe_top_contacts(const AnyFriction& friction, double mu = 0.3,
                                                double radius = 5e-4, double restitution = 0);

/// What both formulations of the tippe-top tell, whatever their coordinates. Contacts: 0 `body`, 1 `tip`.
class TippeTopModel : public MechanicalSystem {
 public:
  const TippeTopData& data() const { return data_; }

  /// From S to the far side of the larger sphere.
  double length_scale() const override;
  /// q begins with the position of S; what follows are angles or an axis.
  void coordinate_scales(VectorRef scales) const override;

  /// The state of LG03 5.4 at t = 0: inclined by theta about e_1 (φ = ψ = 0), θ̇ = φ̇ = 0, spinning with ψ̇
  /// about its own axis, v_S = 0; z_S as given, else so that the lower contact just touches: gap() of it is
  /// exactly zero, the other's is not negative. Throws std::invalid_argument for theta not in [0, π] and for
  /// numbers that are not finite; a z_S at which the top penetrates the floor is left to whoever integrates.
  virtual State start(double theta, double psi_dot, std::optional<double> z_s = {}) const = 0;

  virtual double inclination(ConstVector q) const = 0;                   ///< θ [rad], 0 to π
  virtual double height(ConstVector q) const = 0;                        ///< z_S [m]
  virtual Eigen::Vector3d axis(ConstVector q) const = 0;                 ///< e_3^4 in the floor's axes
  virtual Eigen::Vector3d spin(ConstVector q, ConstVector u) const = 0;  ///< ω in the floor's axes [rad/s]

 protected:
  /// Contacts `body` and `tip` in this order. Throws std::invalid_argument for data or contacts that make no
  /// sense, in one line.
  TippeTopModel(const TippeTopData& data, const std::array<SystemContact, 2>& contacts);

  /// What a contact is made of, as its rows need it.
  struct Sphere {
    int rows;       ///< 1, 3 or 4
    double a;       ///< S to centre [m]
    double r;       ///< of the sphere [m]
    double radius;  ///< R of the contact [m]
  };
  const Sphere& sphere(std::size_t contact) const { return spheres_[contact]; }

  /// g_N, (5.13), (5.14), summed so that it is zero to the last bit where z_S = fl(r − a cosθ).
  double gap_at(std::size_t contact, double z, double cosine) const {
    return z - (spheres_[contact].r - spheres_[contact].a * cosine);
  }
  /// z_S of start(), and its checks.
  double starting_height(double theta, double psi_dot, std::optional<double> z_s) const;

 private:
  TippeTopData data_;
  std::array<Sphere, 2> spheres_;
};

}  // namespace contensou
