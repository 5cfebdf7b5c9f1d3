#include "nutation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "measure.hpp"

namespace verify::integrators {
namespace {

using namespace contensou;

constexpr double interval = 5e-4;  ///< of samples [s]; some 80 a period

Eigen::Vector3d axis_rate(const TippeTopModel& top, const Sample& s) {
  return top.spin(s.q, s.u).cross(top.axis(s.q));
}

}  // namespace

Nutation nutation(const TippeTopModel& top, const State& start, double duration, Method method,
                  double setting) {
  Nutation result;
  double sum = 0, count = 0;
  const Run r = run(
      top, start, start.t + duration, method, setting,
      [&](const Sample& s) {
        sum += axis_rate(top, s).squaredNorm();
        count += 1;
        const auto windows = static_cast<double>(result.middle.size());
        // Samples lie on multiples of the interval: half of it is rounding.
        if (s.t - start.t + interval / 2 < (windows + 1) * Nutation::window) return;
        result.middle.push_back((windows + 0.5) * Nutation::window);
        result.amplitude.push_back(std::sqrt(sum / count));
        sum = count = 0;
      },
      interval);
  result.finished = r.finished();
  result.why = r.why;
  result.end = r.end;
  result.report = r.report;
  return result;
}

double nutation_frequency(const TippeTopModel& top, const State& start, double duration) {
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  double angle = 0;
  const Run r = run(
      top, start, start.t + duration, Method::event_driven, 1e-12,
      [&](const Sample& s) {
        const Eigen::Vector3d now = axis_rate(top, s);
        if (last.norm() > 0) angle += std::atan2(last.cross(now).norm(), last.dot(now));
        last = now;
      },
      interval);
  return r.finished() ? angle / duration : NAN;
}

double rate_beside(const Nutation& measured, const Nutation& reference, double until) {
  double n = 0, st = 0, sy = 0, stt = 0, sty = 0;
  const std::size_t count = std::min(measured.amplitude.size(), reference.amplitude.size());
  for (std::size_t k = 0; k < count && measured.middle[k] < until; ++k) {
    const double t = measured.middle[k], y = std::log(measured.amplitude[k] / reference.amplitude[k]);
    n += 1, st += t, sy += y, stt += t * t, sty += t * y;
  }
  return n < 3 ? NAN : (n * sty - st * sy) / (n * stt - st * st);
}

}  // namespace verify::integrators
