#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "contensou/ball/friction_cylinder.hpp"
#include "contensou/contact/one_contact_states.hpp"

namespace contensou::detail {

/// A contact whose sliding and drilling friction are apart, by what its spin does:
///   held, γ_τ = 0: Λ_τ eliminated by it; W and b of the three rows left are those of a contact that spins
///     freely less what Λ_τ undoes;
///   spins with the sign s: Λ_τ = −s η_max μ Λ_N, which adds −s η_max μ times its column of W to that of
///     Λ_N. W is not symmetric then.
/// Each leaves one of Coulomb's contacts, OneContact<FrictionDisk>; the one that holds is the one after which
/// |Λ_τ| is not too large, or s γ_τ >= 0. For W symmetric and positive definite there is one; what cannot be
/// had so (a singular W, W_NN <= 0 or b_N >= 0 of the three rows, more than one of them possible) is left to
/// Newton's method and to bisection.
template <>
class OneContact<FrictionCylinder> {
 public:
  using Vector = ContactVector<FrictionCylinder>;
  using Matrix = ContactMatrix<FrictionCylinder>;
  using Solution = OneContactSolution<FrictionCylinder>;

  OneContact(const FrictionCylinder& domain, double mu, const Matrix& w, const Vector& b)
      : domain_(domain), mu_(mu), w_(w), b_(b), speed_(b.cwiseAbs().maxCoeff()) {}
  OneContact(const OneContact&) = delete;
  OneContact& operator=(const OneContact&) = delete;

  Solution solve(const Vector& guess) const {
    const Vector start = guess[0] > 0 ? guess : frictionless();
    const double spin = w_.row(3).dot(start) + b_[3];
    const double sign = spin < 0 ? -1 : 1;
    // What would hold it, if only Λ_τ were another.
    const double holding = start[3] - spin / w_(3, 3);
    const bool hold = std::abs(holding) <= limit(start[0]);
    const std::array<double, 3> order{hold ? 0 : sign, hold ? sign : 0, -sign};
    Solution best = unsolved();
    for (const double state : order) {
      Solution next = state == 0 ? held(guess) : spinning(state, guess);
      next.iterations += best.iterations;
      if (next.residual <= rounding) return next;
      if (next.residual < best.residual) {
        best = next;
      } else {
        best.iterations = next.iterations;
      }
    }
    best = polished(best);
    return best.residual <= rounding ? best : bracketed(best, guess);
  }

  /// The same with the last digits by Newton's method.
  Solution polished(const Solution& solution) const {
    return with_last_digits(domain_, mu_, w_, b_, frictionless(), solution);
  }

 private:
  using SlidingVector = ContactVector<FrictionDisk>;
  using SlidingMatrix = ContactMatrix<FrictionDisk>;
  using Sliding = OneContactSolution<FrictionDisk>;

  double limit(double normal) const { return domain_.half_height(friction_size(mu_, normal)); }

  Vector frictionless() const { return {-b_[0] / w_(0, 0), 0, 0, 0}; }

  Solution unsolved() const {
    return {Vector::Zero(), ContactState::unsolved, 0, std::numeric_limits<double>::infinity()};
  }

  Solution held(const Vector& guess) const {
    SlidingMatrix w = w_.topLeftCorner<3, 3>();
    SlidingVector b = b_.head<3>();
    const bool gives_way = w_(3, 3) > 0;
    if (gives_way) {
      const SlidingVector column = w_.topRightCorner<3, 1>() / w_(3, 3);
      w -= column * w_.bottomLeftCorner<1, 3>();
      b -= column * b_[3];
    }
    const Sliding sliding = solve_sliding(w, b, guess);
    const double velocity = w_.bottomLeftCorner<1, 3>().dot(sliding.impulse) + b_[3];
    const double most = limit(sliding.impulse[0]);
    return solution(sliding, gives_way ? std::clamp(-velocity / w_(3, 3), -most, most) : 0);
  }

  Solution spinning(double sign, const Vector& guess) const {
    SlidingMatrix w = w_.topLeftCorner<3, 3>();
    w.col(0) -= sign * mu_ * domain_.eta_max() * w_.topRightCorner<3, 1>();
    const Sliding sliding = solve_sliding(w, b_.head<3>(), guess);
    return solution(sliding, -sign * limit(sliding.impulse[0]));
  }

  /// How far Λ_τ = t is above what the law of spin makes of it, on Coulomb's contact under that t.
  double too_much(double t, const Vector& guess, Sliding& sliding) const {
    const SlidingVector b = b_.head<3>() + t * w_.topRightCorner<3, 1>();
    sliding = b[0] < 0 ? solve_sliding(w_.topLeftCorner<3, 3>(), b, guess)
                       : Sliding{SlidingVector::Zero(), ContactState::open, 0, 0};
    const double spin = w_.bottomLeftCorner<1, 3>().dot(sliding.impulse) + w_(3, 3) * t + b_[3];
    const double most = limit(sliding.impulse[0]);
    return t - std::clamp(t - spin / w_(3, 3), -most, most);
  }

  /// By bisection for Λ_τ: for W positive definite t γ_τ > 0 for all large |t|, so there is a root between,
  /// but where what slides jumps. Slow and safe.
  Solution bracketed(Solution best, const Vector& guess) const {
    constexpr int most_growth = 40;
    constexpr int bisections = 40;
    Sliding sliding;
    double most = (std::abs(b_[3]) + speed_) / w_(3, 3);
    const auto outside = [&](double t) { return t * too_much(t, guess, sliding) > 0; };
    for (int i = 0; i < most_growth && !(outside(-most) && outside(most)); ++i) most *= 4;
    double low = -most;
    double high = most;
    if (!std::isfinite(high)) return best;
    for (int i = 0; i < bisections; ++i) {
      const double t = low + (high - low) / 2;
      (too_much(t, guess, sliding) > 0 ? high : low) = t;
      best.iterations += sliding.iterations;
    }
    Solution found = solution(sliding, low + (high - low) / 2);
    found.iterations = best.iterations;
    found = polished(found);
    best.iterations = found.iterations;
    return found.residual < best.residual ? found : best;
  }

  Sliding solve_sliding(const SlidingMatrix& w, const SlidingVector& b, const Vector& guess) const {
    if (!(b[0] < 0 && w(0, 0) > 0 && w.allFinite() && b.allFinite())) {
      return {SlidingVector::Zero(), ContactState::unsolved, 0, 0};
    }
    return OneContact<FrictionDisk>(FrictionDisk{}, mu_, w, b).solve(guess.head<3>());
  }

  /// The largest error of γ in the laws, by the rows as they were given.
  Solution solution(const Sliding& sliding, double drilling) const {
    Vector z;
    z << sliding.impulse, drilling;
    if (sliding.state == ContactState::unsolved || !z.allFinite()) return unsolved();
    const Vector gamma = (w_ * z + b_) / speed_;
    Eigen::Vector2d slip = gamma.segment<2>(1);
    if (sliding.state == ContactState::slip) {
      const Eigen::Vector2d direction = -sliding.impulse.tail<2>().stableNormalized();
      slip -= std::max(0.0, slip.dot(direction)) * direction;
      if (friction_size(mu_, z[0]) == 0) slip.setZero();  // a law of nothing
    }
    const double most = limit(z[0]);
    double spin = gamma[3];
    if (drilling == -most && spin > 0) spin = 0;
    if (drilling == most && spin < 0) spin = 0;
    const bool sticks = sliding.state == ContactState::stick && std::abs(drilling) < most;
    return {z, sticks ? ContactState::stick : ContactState::slip, sliding.iterations,
            std::max(sliding.residual, std::hypot(gamma[0], slip.norm(), spin))};
  }

  const FrictionCylinder& domain_;
  double mu_;
  const Matrix& w_;
  const Vector& b_;
  double speed_;  ///< V
};

}  // namespace contensou::detail
