#include "smooth_top.hpp"

#include <algorithm>
#include <cmath>

#include "contensou/integrate/dop853.hpp"
#include "contensou/system/tippe_top_axis.hpp"

namespace verify::story {
namespace {

constexpr double mu = 0.3;

class Motion final : public contensou::OdeSystem {
 public:
  Motion(const SmoothTop& top, const contensou::TippeTopAxis& system)
      : top_(top), system_(system), rows_(6), acceleration_(6), q_(6), u_(6), rates_(6) {}

  Eigen::Index size() const override { return 12; }
  void derivative(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dy) override {
    const double weight = system_.data().m * system_.data().g;
    const double stiffness = weight / top_.sink;
    const double damping = 2 * std::sqrt(stiffness * system_.data().m);
    q_ = y.head<6>();
    u_ = y.tail<6>();
    system_.coordinate_rates(q_, u_, rates_);
    system_.free_acceleration(t, q_, u_, acceleration_);
    for (std::size_t i = 0; i < 2; ++i) {
      const double gap = system_.gap(i, t, q_);
      if (gap > 0) continue;
      system_.contact_rows(i, t, q_, u_, rows_);
      const double normal = -stiffness * gap - damping * rows_.velocity[0];
      if (!(normal > 0)) continue;
      const Eigen::Vector2d slip = rows_.velocity.segment<2>(1);
      const double v = slip.norm(), s = std::abs(rows_.velocity[3]);
      const contensou::Friction f = v == 0 && s == 0 ? contensou::Friction{0, 0} : top_.friction(v, s);
      Eigen::Vector4d force(normal, 0, 0, -mu * normal * std::copysign(f.eta, rows_.velocity[3]));
      if (v > 0) force.segment<2>(1) = -mu * normal * f.xi / v * slip;
      acceleration_ += rows_.response * force;
    }
    dy.head<6>() = rates_;
    dy.tail<6>() = acceleration_;
  }

 private:
  const SmoothTop& top_;
  const contensou::TippeTopAxis& system_;
  contensou::ContactRows rows_;
  Eigen::VectorXd acceleration_, q_, u_, rates_;
};

}  // namespace

Curve follow(const SmoothTop& top, double interval) {
  const contensou::TippeTopAxis system({}, contensou::tippe_top_contacts(hertz()));
  const contensou::State start = system.start(0.1, 180);
  Motion motion(top, system);
  contensou::Dop853 step;
  Eigen::VectorXd y(12), rate(12), scale(12), sample(12);
  y << start.q, start.u;
  const double length = system.length_scale();
  scale << length, length, length, 1, 1, 1, 1, 1, 1, 180, 180, 180;  // v of some m/s, ω of the start
  scale *= top.tolerance;

  Curve c;
  const auto show = [&](double t, const Eigen::VectorXd& at) {
    const Eigen::VectorXd q = at.head<6>();
    c.t.push_back(t);
    c.theta.push_back(system.inclination(q));
    c.gap_body.push_back(system.gap(0, t, q));
    c.gap_tip.push_back(system.gap(1, t, q));
  };
  show(0, y);
  double t = 0, h = 1e-5;
  motion.derivative(t, y, rate);
  while (t < top.duration) {
    const double error = step.attempt(motion, t, y, rate, h, scale);
    const double factor = 0.9 * std::pow(std::max(error, 1e-10), -1.0 / step.error_order());
    if (!(error <= 1)) {
      h *= std::isfinite(error) ? std::clamp(factor, 0.2, 1.0) : 0.2;
      if (h < 1e-12) {
        c.report.status = contensou::RunStatus::step_too_small;
        return c;
      }
      ++c.report.rejected;
      continue;
    }
    while (static_cast<double>(c.t.size()) * interval <= t + h) {
      const double shown = static_cast<double>(c.t.size()) * interval;
      step.interpolate(motion, (shown - t) / h, sample);
      show(shown, sample);
    }
    t += h;
    y = step.end();
    y.segment<3>(3).normalize();
    motion.derivative(t, y, rate);
    ++c.report.steps;
    h *= std::clamp(factor, 0.2, 5.0);
  }
  return c;
}

}  // namespace verify::story
