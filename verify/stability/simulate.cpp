#include "simulate.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "contensou/integrate/dop853.hpp"

namespace verify::stability {
namespace {

/// Local error of a step, relative to the deviation at hand. Ten thousand steps of it stay below 1e-7.
constexpr double tolerance = 1e-11;
/// u at the start is about this, so that after an e²-fold growth the law is still linear to
/// 3/8 (7.4e-4)² = 2e-7 (Hertz).
constexpr double small_u = 1e-4;
/// And for a fate, which may grow e⁸-fold, u stays below 1e-2.
constexpr double tiny_u = 3e-6;

/// A stiff contact takes some thousand steps a second.
constexpr double longest = 2;  // [s]

double small_inclination(const Setting& s, double u) { return u * s.radius / s.r(); }

/// What errors are measured by: the deviation; the third components and the place carry no deviation.
void set_scale(const Setting& s, const Eigen::VectorXd& y, Eigen::VectorXd& scale) {
  const double theta = inclination(s, y);
  const double omega = std::abs(spin(s, y));
  scale << 1, 1, s.r(), theta, theta, 1, s.r() * omega * theta, s.r() * omega * theta, s.r() * omega,
      omega * theta, omega * theta, omega;
  scale *= tolerance;
}

}  // namespace

Watch simulate(SlippingTop& top, Eigen::VectorXd& y, double duration, int count,
               const std::function<void(double, const Eigen::VectorXd&)>& seen) {
  const Setting& s = top.setting();
  contensou::Dop853 step;
  Eigen::VectorXd rate(12), scale(12), sample(12);
  Watch watch;
  double t = 0;
  double h = 0.01 / std::abs(spin(s, y));
  top.derivative(t, y, rate);
  seen(0, y);
  int next = 1;
  while (next <= count) {
    const bool last = t + h >= duration;
    if (last) h = duration - t;
    set_scale(s, y, scale);
    const double error = step.attempt(top, t, y, rate, h, scale);
    const double factor = 0.9 * std::pow(std::max(error, 1e-10), -1.0 / step.error_order());
    if (!(error <= 1)) {
      h *= std::isfinite(error) ? std::clamp(factor, 0.2, 1.0) : 0.2;
      if (h < 1e-14 * duration) return watch;
      continue;
    }
    for (; next <= count && (last || duration * next / count <= t + h); ++next) {
      step.interpolate(top, std::min(1.0, (duration * next / count - t) / h), sample);
      seen(duration * next / count, sample);
    }
    t += h;
    y = step.end();
    top.derivative(t, y, rate);
    watch.steps += 1;
    watch.least_normal = std::min(watch.least_normal, top.normal_force() / s.weight());
    watch.largest_u = std::max(watch.largest_u, top.slip().head<2>().norm() / std::abs(top.slip()[2]));
    watch.largest_gap = std::max(watch.largest_gap, std::abs(top.gap(y)) / (s.r() * inclination(s, y)));
    if (!(watch.least_normal > 0)) return watch;
    h *= std::clamp(factor, 0.2, 5.0);
  }
  watch.finished = true;
  return watch;
}

Growth growth(const Setting& setting, double spin_at_start, const SlowMode& mode) {
  SlippingTop top(setting);
  Eigen::VectorXd y = state(setting, spin_at_start, mode, small_inclination(setting, small_u));
  const double slowing = std::abs(spin_rate(setting, spin_at_start));
  double duration = std::min(longest, 2 / std::abs(mode.rate));
  // What rounding and second order put into faster growing modes (1e-7 at most) must not catch up.
  if (mode.outgrown > 0) duration = std::min(duration, 2 / mode.outgrown);
  if (slowing > 0) duration = std::min(duration, 0.01 * std::abs(spin_at_start) / slowing);
  constexpr int count = 400;
  std::vector<double> logarithms;
  const Watch watch = simulate(top, y, duration, count, [&](double, const Eigen::VectorXd& at) {
    logarithms.push_back(std::log(inclination(setting, at)));
  });
  // Σ(t − t̄)(ln θ)/Σ(t − t̄)² on t = −1 ... 1.
  double product = 0, square = 0;
  for (std::size_t k = 0; k < logarithms.size(); ++k) {
    const double x = 2.0 * static_cast<double>(k) / count - 1;
    product += x * logarithms[k];
    square += x * x;
  }
  const double spin_at_end = spin(setting, y);
  return {product / square / (duration / 2), (spin_at_start + spin_at_end) / 2, spin_at_end - spin_at_start,
          duration, watch};
}

Fate fate(const Setting& setting, double spin_at_start, double duration) {
  SlippingTop top(setting);
  const double tilt = small_inclination(setting, tiny_u);
  Eigen::VectorXd y = state(setting, spin_at_start, Deviation{0, 0, tilt, 0, 0, 0});
  double last = tilt;
  const Watch watch = simulate(top, y, duration, 64,
                               [&](double, const Eigen::VectorXd& at) { last = inclination(setting, at); });
  return {last / tilt, watch};
}

}  // namespace verify::stability
