#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "contensou/system/body_contacts.hpp"
#include "contensou/system/body_forces.hpp"
#include "contensou/system/body_layout.hpp"
#include "contensou/system/contact_geometry.hpp"

namespace contensou {

/// Rigid bodies among fixed planes as one mechanical system, for few of them: every row of a contact is f
/// numbers, every pair of surfaces that has a rule is a contact of its own, touching or not. (Many bodies are
/// run_nscd's.) q and u are those of BodyLayout, M and h those of BodyForces. With n the normal and P, Q the
/// points that touch, V = v_P − v_Q (a plane is at rest):
///     sphere and plane:   g_N = n·c − d − r,            P at c − r n
///     sphere and sphere:  g_N = |c − c'| − (r + r'),    P at c − r n, Q at c' + r' n, n from c' to c
///     base and plane:     g_N = n·x − d − height;       V = v: the body stays flat, friction has no lever
///     γ_N = n·V,   γ_Tk = t_k·V,   γ_τ = R n·(ω − ω'),
/// n, t_1, t_2 those of contact_axes(): the floor's are e_z, e_x, e_y. What a driven body's given spin does
/// to γ is w̃, what is left of γ at u = 0.
class RigidBodies final : public MechanicalSystem {
 public:
  /// Throws std::invalid_argument as require_valid(BodiesData), body_pairs() and pair_contacts() do.
  explicit RigidBodies(BodiesData data);
  RigidBodies(const RigidBodies&) = delete;
  RigidBodies& operator=(const RigidBodies&) = delete;

  /// With normals and orientations of length 1 to the last bits.
  const BodiesData& data() const { return data_; }
  const BodyLayout& layout() const { return layout_; }
  /// What each contact is of, in the order of contacts().
  const std::vector<BodyPair>& pairs() const { return pairs_; }
  /// The state the data start with, at t = 0.
  State start() const { return layout_.start(); }

  Eigen::Index coordinates() const override { return layout_.coordinates(); }
  Eigen::Index velocities() const override { return layout_.velocities(); }
  void coordinate_rates(ConstVector q, ConstVector u, VectorRef rates) const override;
  /// Quaternions to unit length; left alone where |q|² is 1 within 4 roundings.
  void restore(VectorRef q) const override;
  /// The largest distance from a centre of mass to a surface of its body, or radius of gyration; more where
  /// bodies or planes are so far from the origin (32 such lengths) that gaps are rounded by that. 1 m where
  /// nothing has a length.
  double length_scale() const override { return length_; }
  void coordinate_scales(VectorRef scales) const override;

  void mass_matrix(ConstVector q, Eigen::Ref<Eigen::MatrixXd> mass) const override;
  void force(double t, ConstVector q, ConstVector u, VectorRef h) const override;
  void free_acceleration(double t, ConstVector q, ConstVector u, VectorRef a) const override;
  double gap(std::size_t contact, double t, ConstVector q) const override;
  void contact_rows(std::size_t contact, double t, ConstVector q, ConstVector u,
                    ContactRows& rows) const override;

  bool driven() const override { return driven_; }

  /// Of a driven body without its rotation.
  double kinetic_energy(ConstVector q, ConstVector u) const override;
  double potential_energy(ConstVector q) const override;  ///< of gravity, zero at x = 0
  const std::vector<std::string>& works() const override { return forces_.works(); }
  void powers(double t, ConstVector q, ConstVector u, VectorRef power) const override;

 private:
  /// What rows need of a body.
  struct Body {
    Rotation rotation;
    Eigen::Index first;  ///< velocity
    double inverse_mass;
    Eigen::Vector3d inverse_inertia;  ///< free
    Eigen::Vector3d axis;             ///< upright, in space
    double inverse_axial;             ///< upright, 1/I_3
  };
  /// One side of a contact at one instant.
  struct Instant {
    MovingSphere sphere;
    Eigen::Vector3d velocity;  ///< of the centre of mass
    Eigen::Matrix3d attitude;  ///< of a free body
  };
  /// One side's part in the rows of a contact.
  struct Part {
    double sign;
    const Eigen::Vector3d& lever;
    const Eigen::Matrix3d& axes;
    double radius;
    int rows;
  };
  struct Prepared;

  explicit RigidBodies(Prepared prepared);
  void set_length();
  Eigen::Vector3d centre(const BodySide& side, double t, ConstVector q) const;
  Instant instant(const BodySide& side, double t, ConstVector q, ConstVector u) const;
  void add(const BodySide& side, const Instant& instant, const Part& part, ContactRows& rows) const;

  BodiesData data_;
  BodyLayout layout_;
  BodyForces forces_;
  std::vector<BodyPair> pairs_;
  std::vector<Body> bodies_;
  std::vector<int> rows_;                    ///< by contact
  std::vector<Eigen::Matrix3d> plane_axes_;  ///< by plane
  std::vector<Eigen::Index> quaternions_;    ///< first coordinates
  double length_ = 1;
  bool driven_ = false;
};

}  // namespace contensou
