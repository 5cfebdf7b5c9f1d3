#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <vector>

#include "contensou/integrate/motion.hpp"
#include "contensou/system/tippe_top_model.hpp"

/// The nonlinear tippe-top over seconds: the story that LG03 5.4 tells, and what changes it.
namespace verify::story {

contensou::AnyFriction hertz();
contensou::AnyFriction uniform();

/// A run of the tippe-top; the defaults are LG03 5.4 with Hertz pressure.
struct Setting {
  contensou::TippeTopData data = {};
  contensou::AnyFriction friction = hertz();
  double mu = 0.3;
  double radius = 5e-4;  ///< R [m], both contacts
  double theta = 0.1;    ///< θ_0 [rad]
  double psi_dot = 180;  ///< ψ̇_0 [rad/s]
  double phi_dot = 0;    ///< φ̇_0 [rad/s]
  std::optional<double> z_s = {};
  bool rolling = false;  ///< v_S such that the body starts with γ_T = 0, not at rest
  Eigen::Vector2d slide =
      Eigen::Vector2d::Zero();  ///< and then this more of v_S [m/s]; axis only, as the former
  bool euler = false;           ///< LG03's coordinates, else the axis of symmetry
  contensou::IntegratorOptions options = {};
  double duration = 8;  ///< [s]
};

/// The motion at equal intervals.
struct Curve {
  std::vector<double> t;
  std::vector<double> theta;
  std::vector<double> gap_body;
  std::vector<double> gap_tip;
  std::vector<double> omega_z;  ///< ω_3 along the vertical
  std::vector<double> spin;     ///< ω·e_3^4
  std::vector<Eigen::Vector3d> axis;
  bool body_sticks = false;    ///< at the end
  std::vector<double> energy;  ///< [J]
  contensou::RunReport report;
};

/// `interval` of the samples [s].
Curve follow(const Setting& setting, double interval = 1e-3);

constexpr double never = std::numeric_limits<double>::quiet_NaN();

/// The times LG03 5.4 gives, each `never` where it does not happen [s].
struct Times {
  double tip = never;           ///< the stick touches
  double upright_from = never;  ///< θ > `upright`, first
  double upright_to = never;    ///< last
  double turning = never;       ///< θ is largest, `settled` after the stick touched: re-inversion begins
  double body = never;          ///< the body touches
  double both_from = never;     ///< double contact
  double both_to = never;
};
/// "Almost completely upright" names no bound: this one is ours [rad].
constexpr double upright = 0.95 * 3.14159265358979323846;
/// [s]; earlier maxima are nutation.
constexpr double settled = 1;
/// The paper's; the re-inversion of t > 4 s begins where θ is largest.
constexpr Times printed{1.5, 1.6, 4, 4, 4.55, 4.65, 5.4};

/// From samples, as from Figs. 9 and 10: a gap below `closed` is taken for contact, and the body must have
/// risen by `risen` before it touches again.
Times read(const Curve& curve);
constexpr double closed = 1e-6;  // [m]
constexpr double risen = 1e-3;   // [m]

/// The first event of a kind after a time; `never` if there is none.
double first(const Curve& curve, contensou::EventKind kind, std::size_t contact, double since = 0);
/// One of the curve's columns at the first sample from t on; 0 <= t <= the end.
double at(const Curve& curve, const std::vector<double>& column, double t);
/// When θ first reaches a level, between samples by a straight line.
double reaches(const Curve& curve, double level);
/// Maxima of θ from one time to another, as a frequency [rad/s].
double nutation(const Curve& curve, double from, double to);

/// From located events. The bounces before the accumulation are not double contact.
Times located(const Curve& curve);

/// Root mean square of the differences to the paper's tip, body, both_from, both_to [s]; infinite where one
/// never happens. "Upright" is left out: what it means is not stated.
double deviation(const Times& times);
/// How many of the four are within `reading` of the paper's.
int agreeing(const Times& times);
constexpr double reading = 0.05;  // [s] half a unit of the figures' last digit, as they print 4.55

}  // namespace verify::story
