#include "measure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

namespace verify::integrators {

using namespace contensou;

Run run(const MechanicalSystem& system, const State& start, double t_end, Method method, double setting,
        const Observer& observer, double output_interval) {
  IntegratorOptions options;
  options.method = method;
  (has_fixed_step(method) ? options.step : options.tolerance) = setting;
  if (output_interval > 0) options.output_interval = output_interval;
  Run result;
  result.end = start;
  try {
    result.report = integrate(system, result.end, t_end, options, observer);
    result.why = result.report.message;
  } catch (const std::invalid_argument& reason) {
    result.refused = true;
    result.why = reason.what();
  }
  return result;
}

double difference(const MechanicalSystem& system, double rate, const State& a, const State& b) {
  Eigen::VectorXd scale(a.q.size());
  system.coordinate_scales(scale);
  Eigen::VectorXd speed = Eigen::VectorXd::Constant(a.u.size(), rate);
  speed.head(std::min<Eigen::Index>(3, speed.size())) *= system.length_scale();
  return std::max((a.q - b.q).cwiseQuotient(scale).lpNorm<Eigen::Infinity>(),
                  (a.u - b.u).cwiseQuotient(speed).lpNorm<Eigen::Infinity>());
}

std::optional<double> last_closing(const std::vector<Event>& events) {
  std::optional<double> last;
  for (const Event& event : events) {
    if (event.kind == EventKind::close || event.kind == EventKind::accumulation) last = event.t;
  }
  return last;
}

double energy(const MechanicalSystem& system, const State& state) {
  return system.kinetic_energy(state.q, state.u) + system.potential_energy(state.q);
}

double dissipated(const RunReport& report) {
  double sum = 0;
  for (const Dissipation& contact : report.dissipated) sum += contact.total();
  return sum;
}

double slope(const std::vector<double>& x, const std::vector<double>& y, double floor) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(y[i] > floor)) continue;
    const double a = std::log(x[i]), b = std::log(y[i]);
    n += 1, sx += a, sy += b, sxx += a * a, sxy += a * b;
  }
  if (n < 2) return std::numeric_limits<double>::quiet_NaN();
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

std::string text(double value, int digits) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.*g", digits, value);
  return buffer;
}

}  // namespace verify::integrators
