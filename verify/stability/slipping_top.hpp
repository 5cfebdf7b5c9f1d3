#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "contensou/integrate/ode.hpp"
#include "contensou/system/tippe_top_axis.hpp"

/// What LG03 5.5 is checked against: the whole nonlinear top in a closed, slipping contact. It knows the
/// system's terms and the friction law, nothing of the stability analysis.
namespace verify::stability {

enum class Pressure { uniform, hertz };
const char* name(Pressure pressure);

/// A top on one of its two spheres.
struct Setting {
  contensou::TippeTopData top;
  std::size_t contact = 0;  ///< 0 on the body, e_3^4 up; 1 on the tip, e_3^4 down
  Pressure pressure = Pressure::hertz;
  double mu = 0.3;
  double radius = 5e-4;  ///< R [m]
  bool drilling = true;  ///< false: λ_τ = 0 by decree, as (5.22) has it; λ_T stays Contensou's

  // The sphere's centre above S and the sphere's radius, as LG03 5.5 calls them.
  double a() const { return contact == 0 ? top.a1 : -top.a2; }
  double r() const { return contact == 0 ? top.r1 : top.r2; }
  double h() const { return r() - a(); }
  double up() const { return contact == 0 ? 1 : -1; }
  double weight() const { return top.m * top.g; }
};

/// The paper's data on body or tip.
Setting paper_top(std::size_t contact);
/// A top on its body with given shape in Magnus's plane; m, I_1 and h are the paper's.
Setting top_of_shape(double h_over_r, double i3_over_i1);

/// y = (q, u) of TippeTopAxis; λ_N from γ̇_N = 0, λ_F = λ_F(γ_F, λ_N).
class SlippingTop final : public contensou::OdeSystem {
 public:
  explicit SlippingTop(const Setting& setting);

  const Setting& setting() const { return setting_; }
  Eigen::Index size() const override { return 12; }
  void derivative(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dy) override;

  /// Of the last call of derivative().
  double normal_force() const { return lambda_n_; }
  const Eigen::Vector3d& friction() const { return lambda_f_; }
  const Eigen::Vector3d& slip() const { return gamma_f_; }

  double gap(const Eigen::VectorXd& y) const { return system_.gap(setting_.contact, 0, y.head<6>()); }

 private:
  Setting setting_;
  contensou::TippeTopAxis system_;
  contensou::ContactRows rows_;
  Eigen::VectorXd acceleration_;
  double lambda_n_ = 0;
  Eigen::Vector3d lambda_f_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d gamma_f_ = Eigen::Vector3d::Zero();
};

/// The deviation from spinning upright, LG03 5.5: ẋ_S, ẏ_S, the Cardan angles α, β of the axis that points up
/// (n = e_3^4 on the body, −e_3^4 on the tip; n = (sinβ, −sinα cosβ, cosα cosβ)), and their rates.
struct Deviation {
  double vx, vy, alpha, beta, alpha_rate, beta_rate;
};
/// The state with this deviation, ω·n = spin, z_S and ż_S as the closed contact has them.
Eigen::VectorXd state(const Setting& setting, double spin, const Deviation& deviation);
/// The angle between n and the vertical.
double inclination(const Setting& setting, const Eigen::VectorXd& y);
/// ω·n.
double spin(const Setting& setting, const Eigen::VectorXd& y);

}  // namespace verify::stability
