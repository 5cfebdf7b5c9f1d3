#pragma once

#include <Eigen/Core>

namespace contensou {

/// Axes of a contact with unit normal n: the columns (n, t_1, t_2) of a right-handed orthonormal basis. For
/// n = e_z, t_1 and t_2 are e_x and e_y; for others these turned by the least turn that takes e_z to n:
///     t_k = e_k − (e_k·n)/(1 + e_z·n) (e_z + n),
/// smooth in n. Where n_z < −0.9 the same from −e_z (with −e_y), since at n = −e_z the first has no limit:
/// there, and only there, is a seam at which t_k jump; friction laws see no difference, being isotropic.
Eigen::Matrix3d contact_axes(const Eigen::Vector3d& normal);
/// The rate of contact_axes where n moves with ṅ, which is across n.
Eigen::Matrix3d contact_axes_rate(const Eigen::Vector3d& normal, const Eigen::Vector3d& rate);

/// A sphere of a body as it moves at one instant, in space.
struct MovingSphere {
  Eigen::Vector3d centre;
  Eigen::Vector3d arm;           ///< from the body's centre of mass to the sphere's centre
  Eigen::Vector3d velocity;      ///< of the sphere's centre
  Eigen::Vector3d acceleration;  ///< of the sphere's centre at u̇ = 0: ω × (ω × arm)
  Eigen::Vector3d spin;          ///< ω
  double radius;
};

/// The contact of a sphere with another: n from the other one to it. Rows in the order of `axes`:
///     γ_k = axis_k·V,   V = v_P − v_Q the velocity of the one's point P against the other's point Q.
struct SphereContact {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();  ///< n, t_1, t_2
  Eigen::Vector3d lever;                           ///< from the centre of mass to P
  Eigen::Vector3d other;                           ///< from the other one's centre of mass to Q
  Eigen::Vector3d drift =
      Eigen::Vector3d::Zero();  ///< rates of γ_N, γ_T1, γ_T2 at u̇ = 0, those of the axes included
  double spin_drift = 0;        ///< the rate of n·(ω − ω_other) at u̇ = 0 [1/s²]
};

double sphere_gap(const Eigen::Vector3d& centre, double radius, const Eigen::Vector3d& other,
                  double other_radius);
/// Centres must not coincide, or what is returned is not finite. Without friction only n, the levers and the
/// rate of γ_N are worked out.
SphereContact sphere_contact(const MovingSphere& sphere, const MovingSphere& other, bool friction);

}  // namespace contensou
