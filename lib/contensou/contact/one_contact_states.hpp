#pragma once

#include <cmath>
#include <limits>

#include "contensou/contact/natural_newton.hpp"
#include "contensou/contact/one_contact.hpp"
#include "contensou/contact/reduced_contact.hpp"
#include "contensou/contact/slip_search.hpp"
#include "contensou/contact/small_linear.hpp"

namespace contensou::detail {

template <class Domain>
using FrictionVector = Eigen::Matrix<double, Domain::dimension, 1>;

/// A residual that rounding may leave: the search is not repeated for less.
inline constexpr double rounding = 1e-13;

/// `solution`, or where Newton's method on the natural map makes it better, that; `start` is where it begins
/// if there is no solution yet.
template <class Domain>
OneContactSolution<Domain> with_last_digits(const Domain& domain, double mu, const ContactMatrix<Domain>& w,
                                            const ContactVector<Domain>& b,
                                            const ContactVector<Domain>& start,
                                            OneContactSolution<Domain> solution) {
  const bool unsolved = solution.state == ContactState::unsolved;
  const double speed = b.cwiseAbs().maxCoeff();
  ContactVector<Domain> z = unsolved ? start : solution.impulse;
  const double residual = polish(domain, mu, w, b, rounding * speed, z, solution.iterations) / speed;
  if (!(residual < solution.residual && z[0] > 0)) return solution;
  if (unsolved) solution.state = ContactState::slip;
  solution.impulse = z;
  solution.residual = residual;
  return solution;
}

/// One contact that closes, b_N < 0 < W_NN, by the equations of its states (one_contact.hpp). What it is
/// given outlives it.
template <class Domain>
class OneContact {
 public:
  static constexpr int dimension = Domain::dimension;
  using Vector = ContactVector<Domain>;
  using Matrix = ContactMatrix<Domain>;
  using Friction = FrictionVector<Domain>;
  using Solution = OneContactSolution<Domain>;

  OneContact(const Domain& domain, double mu, const Matrix& w, const Vector& b)
      : domain_(domain),
        w_(w),
        b_(b),
        speed_(b.cwiseAbs().maxCoeff()),
        unit_(speed_ / w(0, 0)),
        c_(reduce_contact<dimension>(mu, w, b, speed_)),
        secular_(c_) {}
  OneContact(const OneContact&) = delete;
  OneContact& operator=(const OneContact&) = delete;

  Solution solve(const Vector& guess) const {
    Solution stick = try_stick();
    if (stick.residual <= rounding) return stick;
    Solution slip = friction_is_weak() ? slide_along(c_.b) : search(guess);
    const Solution best = slip.residual < stick.residual ? slip : stick;
    return best.residual <= rounding ? best : polished(best);
  }

  /// The same with the last digits by Newton's method.
  Solution polished(const Solution& solution) const {
    return with_last_digits(domain_, c_.mu, w_, b_, impulse(c_.n0, Friction::Zero()), solution);
  }

 private:
  Vector velocity(const Vector& impulse) const { return w_ * impulse + b_; }

  Solution unsolved() const {
    return {Vector::Zero(), ContactState::unsolved, 0, std::numeric_limits<double>::infinity()};
  }

  Vector impulse(double normal, const Friction& friction) const {
    Vector z;
    z << unit_ * normal, unit_ * friction;
    return z;
  }

  Solution sticking(double normal, const Friction& friction, int iterations) const {
    const Vector z = impulse(normal, friction);
    return {z, ContactState::stick, iterations, velocity(z).norm() / speed_};
  }

  Solution slipping(double normal, const Friction& friction, const Friction& direction,
                    int iterations) const {
    const Vector z = impulse(normal, friction);
    const Vector gamma = velocity(z) / speed_;
    const Friction slip = gamma.template tail<dimension>();
    const double along = std::max(0.0, slip.dot(direction));
    return {z, ContactState::slip, iterations, std::hypot(gamma[0], (slip - along * direction).norm())};
  }

  /// Whether friction changes the direction of slip by less than rounding: also where μ = 0.
  bool friction_is_weak() const {
    const double largest = c_.mu * c_.n0 * row_sum_norm(c_.a);
    return largest <= 0x1p-60 * c_.b.cwiseAbs().maxCoeff() || largest == 0;
  }

  Solution slide_along(const Friction& gamma) const {
    const Friction direction = gamma.stableNormalized();
    Friction unit = Friction::Zero();
    if (c_.mu > 0) unit = border(direction);
    const double normal = c_.n0 / (1 + c_.mu * c_.g.dot(unit));
    if (!(normal > 0)) return unsolved();
    return slipping(normal, -c_.mu * normal * unit, direction, 0);
  }

  Friction border(const Friction& direction) const {
    if constexpr (dimension == 2) {
      return direction;
    } else {
      return domain_.boundary_point(1, direction);
    }
  }

  /// The friction that stops the contact, if the domain has it.
  Solution try_stick() const {
    // By Cramer's rule, which loses what the determinant does.
    constexpr double regular = 1e-2;
    constexpr double near_singular = 1e-6;
    const auto [p, det] = secular_.polynomials().value(0, 0);
    const double reference = c_.a.diagonal().prod();
    Friction x = p / -det;
    if (det > near_singular * reference && certainly_slips(x)) return unsolved();
    if (c_.b.isZero(0)) {
      x.setZero();
    } else if (!(det > regular * reference)) {
      x = -solve_pivoted<dimension>(c_.a, c_.b, 0);
    }
    const double normal = c_.normal(x);
    if (!(normal > 0 && x.allFinite()) || !domain_.contains(x, friction_size(c_.mu, normal)))
      return unsolved();
    return sticking(normal, x, 0);
  }

  /// Whether friction near x is beyond the domain; false for some that is. Allows for what Cramer's rule
  /// loses.
  bool certainly_slips(const Friction& x) const {
    constexpr double margin = 1 + 1e-6;
    const double size = margin * friction_size(c_.mu, c_.normal(x));
    if constexpr (dimension == 2) {
      return x.squaredNorm() > size * size;
    } else {
      const double t = std::sqrt(x[0] * x[0] + x[1] * x[1]);
      return size > 0 && domain_.plate().beyond_tangents({t, std::abs(x[2])}, size);
    }
  }

  Solution search(const Vector& guess) const {
    Friction gamma = c_.b;
    if (guess[0] > 0) {
      const Friction warm = velocity(guess).template tail<dimension>() / speed_;
      if (warm.squaredNorm() > 0) gamma = warm;
    }
    const auto end = search_slip(domain_, c_, secular_, gamma);
    if (!end.found) return unsolved();
    if (end.sticks) return sticking(end.normal, end.friction, end.iterations);
    return slipping(end.normal, end.friction, end.direction, end.iterations);
  }

  const Domain& domain_;
  const Matrix& w_;
  const Vector& b_;
  double speed_;  ///< V
  double unit_;   ///< V/W_NN
  ReducedContact<dimension> c_;
  Secular<dimension> secular_;
};

}  // namespace contensou::detail
