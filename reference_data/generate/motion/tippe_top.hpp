#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "extrapolation.hpp"
#include "slip_law.hpp"

namespace reference {

/// The tippe-top of LG03 5.4 once more, from Newton and Euler: place and velocity of S, axis e, angular
/// momentum L about S, all in the floor's axes.
///     ω = L/I_1 + (1/I_3 − 1/I_1)(L·e)e,   ė = L × e/I_1,   L̇ = Σ s_i × F_i + τ_i e_3,   s_i = a_i e − r_i
///     e_3.
/// A closed contact slips: F_i = λ_i φ_i, τ_i = λ_i τ̂_i with φ, τ̂ given by the velocity, so that the normal
/// forces are linear equations; it never sticks here (a motion that comes near that is refused). Where one
/// contact is open, its distance is carried along as a variable of its own: it keeps its digits through ever
/// smaller impacts.
template <class Real>
using Vec3 = std::array<Real, 3>;

template <class Real>
Vec3<Real> cross(const Vec3<Real>& a, const Vec3<Real>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// An event, as the library's tables name it.
template <class Real>
struct Happening {
  Real t;
  std::string event;
  int contact;  ///< 0 body, 1 tip
};

/// What is seen at a sample.
template <class Real>
struct Seen {
  Real t, theta, gap_body, gap_tip;
};

template <class Real, std::size_t columns>
class TippeTopMotion {
 public:
  /// x_S, y_S, z_S, v_S, e, L, distance of the open contact.
  using State = std::array<Real, 13>;

  /// tolerance: of the change in the last column of a step, in units of scales; seed: of perturb().
  TippeTopMotion(Pressure pressure, const Real& radius, double tolerance, std::uint64_t seed = 0)
      : law_(pressure), radius_(radius), tolerance_(tolerance), random_(0x9e3779b97f4a7c15u * (seed + 1)) {
    using std::acos;
    using std::cos;
    using std::sin;
    using std::sqrt;
    // Parsed as decimals, not as the doubles nearest to them.
    m_ = Real(6) / 1000;
    i1_ = Real(8) / 10000000;
    i3_ = Real(7) / 10000000;
    mu_ = Real(3) / 10;
    g_ = Real(981) / 100;
    a_ = {Real(3) / 1000, Real(16) / 1000};
    r_ = {Real(15) / 1000, Real(5) / 1000};
    const Real theta = Real(1) / 10, spin = 180;
    x_.fill(0);
    x_[7] = -sin(theta);
    x_[8] = cos(theta);
    x_[2] = r_[0] - a_[0] * x_[8];
    for (int k = 0; k < 3; ++k) x_[9 + k] = i3_ * spin * x_[6 + k];
    x_[12] = x_[2] - (r_[1] - a_[1] * x_[8]);
    closed_ = {true, false};

    // What one unit of error is: the library's length of the top, energy, and what that energy can move.
    const Real length = a_[1] + r_[1];
    const Real energy = i3_ * spin * spin / 2;
    const Real speed = sqrt(2 * energy / m_), turning = sqrt(2 * energy * i1_);
    for (int k = 0; k < 3; ++k) {
      scale_[k] = length;
      scale_[3 + k] = speed;
      scale_[6 + k] = 1;
      scale_[9 + k] = turning;
    }
    scale_[12] = length;
    h_ = Real(1) / 1000;
  }

  /// Moves on to t, through all that happens on the way.
  void advance(const Real& t) {
    while (t_ < t) step(t - t_);
  }

  /// Every component off by ±size, at random, in units of its scale, as far as closed contacts allow: how
  /// errors that are made here come out later. Nothing while a distance is too small to bear it.
  void perturb(const Real& size) {
    if (closed_[0] != closed_[1] && x_[12] < 1e-9) return;
    const Real axis = x_[8];
    for (std::size_t i = 0; i < 12; ++i) x_[i] += (coin() ? 1 : -1) * size * scale_[i];
    if (closed_[0] && closed_[1]) {
      x_[8] = axis;
      const Vec3<Real> e = part(x_, 6), across{e[1], -e[0], 0};
      const Real turning =
          (x_[9] * across[0] + x_[10] * across[1]) / (across[0] * across[0] + across[1] * across[1]);
      for (int k = 0; k < 2; ++k) x_[9 + k] -= turning * across[k];
    }
    restore();
    if (closed_[0] != closed_[1]) x_[12] += opening_speed() * (x_[8] - axis);
  }

  Seen<Real> seen() const {
    using std::atan2;
    using std::sqrt;
    return {t_, atan2(sqrt(x_[6] * x_[6] + x_[7] * x_[7]), x_[8]), gap(0), gap(1)};
  }
  const std::vector<Happening<Real>>& events() const { return events_; }
  std::int64_t steps() const { return steps_; }

 private:
  using V = Vec3<Real>;

  struct Contact {
    V phi;  ///< F/λ_N
    V w;    ///< L̇/λ_N
  };

  bool coin() {
    random_ ^= random_ << 13;
    random_ ^= random_ >> 7;
    random_ ^= random_ << 17;
    return (random_ >> 32 & 1) != 0;
  }

  static V part(const State& x, std::size_t first) { return {x[first], x[first + 1], x[first + 2]}; }

  Real gap(int i) const { return closed_[i] ? Real(0) : x_[12]; }

  V angular_velocity(const V& l, const V& e) const {
    const Real along = (l[0] * e[0] + l[1] * e[1] + l[2] * e[2]) * (1 / i3_ - 1 / i1_);
    return {l[0] / i1_ + along * e[0], l[1] / i1_ + along * e[1], l[2] / i1_ + along * e[2]};
  }
  /// ė_3.
  Real rise(const V& l, const V& e) const { return cross(l, e)[2] / i1_; }

  Contact contact(int i, const V& v, const V& e, const V& l) const {
    using std::sqrt;
    const V omega = angular_velocity(l, e);
    const V s{a_[i] * e[0], a_[i] * e[1], a_[i] * e[2] - r_[i]};
    const V turn = cross(omega, s);
    const Real v1 = v[0] + turn[0], v2 = v[1] + turn[1];
    const Real sliding = sqrt(v1 * v1 + v2 * v2), spin = omega[2] * radius_,
               size = spin < 0 ? Real(-spin) : spin;
    if (!(sliding + size > slowest())) throw std::runtime_error("a contact that nearly sticks");
    const Slip<Real> f = law_.at(sliding, size);
    Contact c;
    c.phi = {0, 0, 1};
    if (sliding > 0) {
      c.phi[0] = -mu_ * f.xi * v1 / sliding;
      c.phi[1] = -mu_ * f.xi * v2 / sliding;
    }
    c.w = cross(s, c.phi);
    c.w[2] -= mu_ * f.eta * radius_ * (spin < 0 ? -1 : 1);
    return c;
  }
  /// Slip that an explicit method can follow: friction's rate there is about μg/slowest, 1e5/s.
  static double slowest() { return 3e-5; }

  /// λ_N (or, for impacts, Λ_N) from free_i + Σ_j response_ij λ_j = 0 over the closed contacts.
  std::array<Real, 2> normal(const std::array<bool, 2>& closed, const std::array<Contact, 2>& c, const V& e,
                             const std::array<Real, 2>& free) const {
    const auto response = [&](int i, int j) { return 1 / m_ + a_[i] * cross(c[j].w, e)[2] / i1_; };
    std::array<Real, 2> lambda{0, 0};
    if (closed[0] && closed[1]) {
      const Real d00 = response(0, 0), d01 = response(0, 1), d10 = response(1, 0), d11 = response(1, 1);
      const Real det = d00 * d11 - d01 * d10;
      lambda = {(d01 * free[1] - d11 * free[0]) / det, (d10 * free[0] - d00 * free[1]) / det};
    } else {
      const int i = closed[0] ? 0 : 1;
      lambda[i] = -free[i] / response(i, i);
    }
    return lambda;
  }

  struct Forces {
    std::array<Contact, 2> contact{};
    std::array<Real, 2> lambda;
    V e_rate;
  };

  Forces forces(const State& x) const {
    const V v = part(x, 3), e = part(x, 6), l = part(x, 9);
    Forces f;
    f.e_rate = cross(l, e);
    for (Real& rate : f.e_rate) rate /= i1_;
    // g̈_i = z̈ + a_i ë_3,  ë = (L̇ × e + L × ė)/I_1.
    const Real bend = cross(l, f.e_rate)[2] / i1_;
    for (int i = 0; i < 2; ++i) {
      if (closed_[i]) f.contact[i] = contact(i, v, e, l);
    }
    f.lambda = normal(closed_, f.contact, e, {-g_ + a_[0] * bend, -g_ + a_[1] * bend});
    return f;
  }

  State rate(const State& x) const {
    const Forces f = forces(x);
    State dx;
    for (int k = 0; k < 3; ++k) {
      dx[k] = x[3 + k];
      dx[3 + k] = k == 2 ? Real(-g_) : Real(0);
      dx[6 + k] = f.e_rate[k];
      dx[9 + k] = 0;
    }
    for (int i = 0; i < 2; ++i) {
      if (!closed_[i]) continue;
      for (int k = 0; k < 3; ++k) {
        dx[3 + k] += f.lambda[i] * f.contact[i].phi[k] / m_;
        dx[9 + k] += f.lambda[i] * f.contact[i].w[k];
      }
    }
    dx[12] = 0;
    if (closed_[0] != closed_[1]) dx[12] = opening_speed() * f.e_rate[2];
    return dx;
  }
  /// ġ of the open contact over ė_3, the other being closed.
  Real opening_speed() const { return closed_[0] ? Real(a_[1] - a_[0]) : Real(a_[0] - a_[1]); }

  /// Back to what the closed contact asks for, and |e| = 1.
  void restore() {
    using std::sqrt;
    const Real length = sqrt(x_[6] * x_[6] + x_[7] * x_[7] + x_[8] * x_[8]);
    for (int k = 6; k < 9; ++k) x_[k] /= length;
    const int i = closed_[0] ? 0 : 1;
    x_[2] = r_[i] - a_[i] * x_[8];
    x_[5] = -a_[i] * rise(part(x_, 9), part(x_, 6));
  }

  struct Trial {
    State end;
    Real error;
  };
  Trial attempt(const Real& h) const {
    State change;
    Trial trial;
    trial.end = extrapolated_step<columns>([this](const State& x) { return rate(x); }, x_, h, change);
    trial.error = 0;
    for (std::size_t i = 0; i < change.size(); ++i) {
      const Real size = (change[i] < 0 ? Real(-change[i]) : change[i]) / scale_[i];
      if (!(size <= trial.error)) trial.error = size;
    }
    return trial;
  }

  /// What must not become negative: the distance of the open contact; with both closed, the tip's force.
  /// A distance that begins at zero is divided by the time since.
  Real watched(const State& x, const Real& h) const {
    if (closed_[0] && closed_[1]) return forces(x).lambda[1];
    return leaving_ ? Real(x[12] / h) : x[12];
  }

  void step(const Real& most) {
    using std::pow;
    for (;;) {
      Real h = h_ < most ? h_ : most;
      if (leaving_) {  // not beyond twice the time at which the open contact comes back
        const State dx = rate(x_);
        const Real speed = dx[12], slope = second_derivative(x_);
        if (slope < 0 && -4 * speed / slope < h) h = -4 * speed / slope;
      }
      const Trial trial = attempt(h);
      const double ratio = static_cast<double>(trial.error) / tolerance_;
      const double factor = 0.8 * std::pow(std::max(ratio, 1e-300), -1.0 / (2 * columns - 1));
      if (!(ratio <= 1)) {
        h_ = h * (factor > 0.1 ? std::min(factor, 0.8) : 0.1);
        if (!(h_ > 1e-25)) throw std::runtime_error("steps below rounding");
        continue;
      }
      if (watched(trial.end, h) < 0) return locate(h);
      ++steps_;
      x_ = trial.end;
      t_ += h;
      leaving_ = false;
      restore();
      if (h == h_)
        h_ = std::min(Real(h * std::min(factor, 4.0)), longest());
      else if (factor < 1)
        h_ = h * factor;
      const Forces f = forces(x_);
      for (int i = 0; i < 2; ++i) {
        if (closed_[i] && f.lambda[i] < 0) throw std::runtime_error("a contact opens that was not watched");
      }
      return;
    }
  }
  /// A tenth of a nutation, so that no touch-down is stepped over.
  static Real longest() { return Real(4) / 1000; }

  Real second_derivative(const State& x) const {
    const Forces f = forces(x);
    V l_rate{0, 0, 0};
    for (int i = 0; i < 2; ++i) {
      for (int k = 0; k < 3; ++k) {
        if (closed_[i]) l_rate[k] += f.lambda[i] * f.contact[i].w[k];
      }
    }
    return opening_speed() * (cross(l_rate, part(x, 6))[2] + cross(part(x, 9), f.e_rate)[2]) / i1_;
  }

  /// Something happens within h of now: the root of `watched`, by Ridders' method down to rounding.
  void locate(const Real& h) {
    using std::sqrt;
    const auto value = [&](const Real& tau) { return watched(attempt(tau).end, tau); };
    Real left = leaving_ ? Real(h / 1024) : Real(0), right = h;
    Real at_left = left > 0 ? value(left) : watched(x_, 1), at_right = value(right);
    if (at_left < 0) throw std::runtime_error("nothing to locate");
    Real root = right;
    for (int k = 0; k < 60 && at_left != 0; ++k) {
      const Real middle = (left + right) / 2, at_middle = value(middle);
      const Real denominator = sqrt(at_middle * at_middle - at_left * at_right);
      const Real next = denominator > 0 ? middle + (middle - left) * at_middle / denominator : middle;
      const Real moved = next - root;
      root = next;
      const Real at_root = value(root);
      if (at_root == 0 || (moved < 0 ? Real(-moved) : moved) <= rounding() * h) break;
      if (at_middle < 0) {
        right = middle;
        at_right = at_middle;
      } else {
        left = middle;
        at_left = at_middle;
      }
      if (at_root < 0 && root < right) {
        right = root;
        at_right = at_root;
      } else if (at_root > 0 && root > left) {
        left = root;
        at_left = at_root;
      }
    }
    x_ = attempt(root).end;
    t_ += root;
    ++steps_;
    restore();
    if (closed_[0] && closed_[1]) {
      closed_[1] = false;
      x_[12] = 0;  // and grows like τ³: its force just vanished
      events_.push_back({t_, "open", 1});
    } else {
      impact();
    }
    h_ = Real(1) / 10000;
  }
  static Real rounding() { return std::numeric_limits<Real>::epsilon() * 16; }

  /// The open contact has come down: an impact without restitution.
  void impact() {
    const int hit = closed_[0] ? 1 : 0, other = 1 - hit;
    x_[12] = 0;
    if (accumulated(hit)) return;
    std::array<bool, 2> alone{hit == 0, hit == 1};
    const auto [v, l, impulses] = after(alone);
    const Real away = v[2] + a_[other] * rise(l, part(x_, 6));
    if (!(impulses[hit] > 0 && away > 0)) throw std::runtime_error("an impact after which both stay closed");
    for (int k = 0; k < 3; ++k) {
      x_[3 + k] = v[k];
      x_[9 + k] = l[k];
    }
    closed_ = alone;
    leaving_ = true;
    restore();
    events_.push_back({t_, "close", hit});
    events_.push_back({t_, "open", other});
  }

  struct After {
    V v, l;
    std::array<Real, 2> impulse;
  };
  /// Friction impulses point against the velocity after the impact: iterated until they do.
  After after(const std::array<bool, 2>& closed) const {
    const V v = part(x_, 3), e = part(x_, 6), l = part(x_, 9);
    const std::array<Real, 2> approach{v[2] + a_[0] * rise(l, e), v[2] + a_[1] * rise(l, e)};
    After now{v, l, {0, 0}};
    Real last_change = 1;
    for (int k = 0; k < 2000; ++k) {
      std::array<Contact, 2> c{};
      for (int i = 0; i < 2; ++i) {
        if (closed[i]) c[i] = contact(i, now.v, e, now.l);
      }
      After next{v, l, normal(closed, c, e, approach)};
      Real change = 0;
      for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 2; ++i) {
          if (!closed[i]) continue;
          next.v[j] += next.impulse[i] * c[i].phi[j] / m_;
          next.l[j] += next.impulse[i] * c[i].w[j];
        }
        const Real dv = next.v[j] - now.v[j], dl = next.l[j] - now.l[j];
        change += dv * dv / (scale_[3] * scale_[3]) + dl * dl / (scale_[9] * scale_[9]);
      }
      now = next;
      const Real least = rounding() * rounding();
      if (change <= least || (change >= last_change && change < least * 1e4)) {
        return now;
      }
      last_change = change;
    }
    throw std::runtime_error("friction of an impact not found");
  }

  /// The body's impacts in turn with the tip's become ever shorter, by the same factor: once they are shorter
  /// than `shortest`, what is left is the rest of a geometric series.
  bool accumulated(int hit) {
    impacts_.push_back(t_);
    const std::size_t n = impacts_.size();
    if (n >= 5) {
      const Real last = impacts_[n - 1] - impacts_[n - 3], before = impacts_[n - 3] - impacts_[n - 5];
      if (last < shortest() && last < before) {
        const Real rest = last * last / (before - last);
        // Both stay closed from now on: on average, that is what the impacts do until they end, and a
        // thousand or a million times longer impacts give the same motion to 1e-13 s. What they still
        // approach with may have any sign: it is less than counts.
        const auto [v, l, impulse] = after({true, true});
        closed_ = {true, true};
        for (int k = 0; k < 3; ++k) {
          x_[3 + k] = v[k];
          x_[9 + k] = l[k];
        }
        leaving_ = false;
        restore();
        events_.push_back({t_, "close", hit});
        events_.push_back({t_ + rest, "accumulation", 0});
        events_.push_back({t_ + rest, "accumulation", 1});
        impacts_.clear();
        return true;
      }
    }
    return false;
  }
  /// [s]
  static double shortest() { return 1e-12; }

  SlipLaw<Real> law_;
  Real radius_;
  double tolerance_;
  std::uint64_t random_;
  Real m_, i1_, i3_, mu_, g_;
  std::array<Real, 2> a_, r_;
  Real t_ = 0, h_;
  State x_, scale_;
  std::array<bool, 2> closed_;
  bool leaving_ = false;  ///< the open contact's distance has just begun, at zero
  std::int64_t steps_ = 0;
  std::vector<Happening<Real>> events_;
  std::vector<Real> impacts_;
};

}  // namespace reference
