#include "run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "contensou/system/tippe_top_axis.hpp"
#include "contensou/system/tippe_top_euler.hpp"

namespace verify::story {
namespace {

using contensou::EventKind;

contensou::State start(const contensou::TippeTopModel& top, const Setting& s) {
  contensou::State state = top.start(s.theta, s.psi_dot, s.z_s);
  if (s.euler) {
    state.u[4] = s.phi_dot;
    return state;
  }
  state.u[5] += s.phi_dot;
  if (s.rolling) {
    contensou::ContactRows rows(top.velocities());
    top.contact_rows(0, 0, state.q, state.u, rows);
    state.u.head<2>() -= rows.velocity.segment<2>(1);  // γ_T = v_S + …
  }
  state.u.head<2>() += s.slide;
  return state;
}

/// Where the straight line between samples k − 1 and k has `level`.
double crossing(const Curve& c, const std::vector<double>& values, double level, std::size_t k) {
  const double part = (level - values[k - 1]) / (values[k] - values[k - 1]);
  return c.t[k - 1] + part * (c.t[k] - c.t[k - 1]);
}

void read_inclination(const Curve& c, Times& times) {
  std::size_t largest = 0;
  for (std::size_t k = 1; k < c.t.size(); ++k) {
    if (c.t[k] > times.tip + settled && c.theta[k] > c.theta[largest]) largest = k;
    const bool before = c.theta[k - 1] > upright, now = c.theta[k] > upright;
    if (before == now) continue;
    if (now && std::isnan(times.upright_from)) times.upright_from = crossing(c, c.theta, upright, k);
    if (before) times.upright_to = crossing(c, c.theta, upright, k);
  }
  const std::size_t k = largest;
  if (k == 0 || k + 1 >= c.t.size()) return;
  // The vertex of the parabola through three samples.
  const double left = c.theta[k] - c.theta[k - 1], right = c.theta[k] - c.theta[k + 1];
  if (left >= 0 && right > 0)
    times.turning = c.t[k] + (c.t[k + 1] - c.t[k]) * (left - right) / (2 * (left + right));
}

std::array<double, 4> contact_times(const Times& t) { return {t.tip, t.body, t.both_from, t.both_to}; }

}  // namespace

contensou::AnyFriction hertz() {
  return contensou::FrictionBall(contensou::SmoothPlate(contensou::HertzLaw{}));
}
contensou::AnyFriction uniform() {
  return contensou::FrictionBall(contensou::SmoothPlate(contensou::UniformLaw{}));
}

Curve follow(const Setting& s, double interval) {
  const auto contacts = contensou::tippe_top_contacts(s.friction, s.mu, s.radius);
  std::unique_ptr<contensou::TippeTopModel> top;
  if (s.euler) {
    top = std::make_unique<contensou::TippeTopEuler>(s.data, contacts);
  } else {
    top = std::make_unique<contensou::TippeTopAxis>(s.data, contacts);
  }
  contensou::State state = start(*top, s);
  contensou::IntegratorOptions options = s.options;
  options.output_interval = interval;
  Curve c;
  const auto seen = [&](const contensou::Sample& x) {
    const Eigen::Vector3d axis = top->axis(x.q), omega = top->spin(x.q, x.u);
    c.energy.push_back(top->kinetic_energy(x.q, x.u) + top->potential_energy(x.q));
    c.t.push_back(x.t);
    c.theta.push_back(top->inclination(x.q));
    c.gap_body.push_back(top->gap(0, x.t, x.q));
    c.gap_tip.push_back(top->gap(1, x.t, x.q));
    c.omega_z.push_back(omega[2]);
    c.spin.push_back(omega.dot(axis));
    c.axis.push_back(axis);
    c.body_sticks = x.modes[0] == contensou::ContactMode::stick;
  };
  c.report = contensou::integrate(*top, state, s.duration, options, seen);
  return c;
}

Times read(const Curve& c) {
  Times times;
  bool lifted = false;
  double since = never;  // double contact
  for (std::size_t k = 1; k < c.t.size(); ++k) {
    if (std::isnan(times.tip) && c.gap_tip[k] < closed) times.tip = crossing(c, c.gap_tip, closed, k);
    if (std::isnan(times.tip)) continue;
    lifted = lifted || c.gap_body[k] > risen;
    if (!lifted) continue;
    if (std::isnan(times.body) && c.gap_body[k] < closed) times.body = crossing(c, c.gap_body, closed, k);
    if (std::isnan(times.body)) continue;
    if (c.gap_body[k] < closed && c.gap_tip[k] < closed) {
      if (std::isnan(since)) since = c.t[k];
      continue;
    }
    constexpr double passing = 0.05;  // [s]; shorter ones are bounces
    if (c.t[k] - since >= passing) {
      times.both_from = since;
      times.both_to = c.t[k];
      break;
    }
    since = never;
  }
  read_inclination(c, times);
  return times;
}

double first(const Curve& c, EventKind kind, std::size_t contact, double since) {
  for (const contensou::Event& e : c.report.events) {
    if (e.kind == kind && e.contact == contact && e.t > since) return e.t;
  }
  return never;
}

double at(const Curve& c, const std::vector<double>& column, double t) {
  constexpr double rounding = 1e-9;
  const auto k = std::lower_bound(c.t.begin(), c.t.end(), t - rounding) - c.t.begin();
  return column[static_cast<std::size_t>(k)];
}

double reaches(const Curve& c, double level) {
  for (std::size_t k = 1; k < c.t.size(); ++k) {
    if (c.theta[k] >= level) return crossing(c, c.theta, level, k);
  }
  return never;
}

double nutation(const Curve& c, double from, double to) {
  std::size_t first = 0, last = 0, count = 0;
  for (std::size_t k = 1; k + 1 < c.t.size(); ++k) {
    if (!(c.t[k] > from && c.t[k] < to)) continue;
    if (!(c.theta[k] > c.theta[k - 1] && c.theta[k] >= c.theta[k + 1])) continue;
    if (count++ == 0) first = k;
    last = k;
  }
  if (count < 2) return never;
  return 2 * std::numbers::pi * static_cast<double>(count - 1) / (c.t[last] - c.t[first]);
}

Times located(const Curve& c) {
  Times times;
  times.tip = first(c, EventKind::close, 1);
  read_inclination(c, times);
  times.body = first(c, EventKind::close, 0, times.turning);
  times.both_from = first(c, EventKind::accumulation, 0, times.body);
  times.both_to = first(c, EventKind::open, 1, times.both_from);
  return times;
}

double deviation(const Times& times) {
  const auto ours = contact_times(times), paper = contact_times(printed);
  double sum = 0;
  for (std::size_t k = 0; k < ours.size(); ++k) sum += (ours[k] - paper[k]) * (ours[k] - paper[k]);
  return std::isnan(sum) ? std::numeric_limits<double>::infinity() : std::sqrt(sum / 4);
}

int agreeing(const Times& times) {
  const auto ours = contact_times(times), paper = contact_times(printed);
  int count = 0;
  for (std::size_t k = 0; k < ours.size(); ++k) count += std::abs(ours[k] - paper[k]) <= reading;
  return count;
}

}  // namespace verify::story
