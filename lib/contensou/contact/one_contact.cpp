#include "contensou/contact/one_contact.hpp"

#include <cmath>
#include <limits>

#include "contensou/contact/natural_newton.hpp"
#include "contensou/contact/reduced_contact.hpp"
#include "contensou/contact/slip_search.hpp"
#include "contensou/contact/small_linear.hpp"

namespace contensou {
namespace {

template <class Domain>
using FrictionVector = Eigen::Matrix<double, Domain::dimension, 1>;

/// A residual that rounding may leave: the search is not repeated for less.
constexpr double rounding = 1e-13;

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
        c_(detail::reduce_contact<dimension>(mu, w, b, speed_)),
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
  Solution polished(Solution solution) const {
    Vector z = solution.impulse;
    if (solution.state == ContactState::unsolved) z = impulse(c_.n0, Friction::Zero());
    const double residual =
        detail::polish(domain_, c_.mu, w_, b_, rounding * speed_, z, solution.iterations) / speed_;
    if (!(residual < solution.residual && z[0] > 0)) return solution;
    if (solution.state == ContactState::unsolved) solution.state = ContactState::slip;
    solution.impulse = z;
    solution.residual = residual;
    return solution;
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
      x = -detail::solve_pivoted<dimension>(c_.a, c_.b, 0);
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
    const auto end = detail::search_slip(domain_, c_, secular_, gamma);
    if (!end.found) return unsolved();
    if (end.sticks) return sticking(end.normal, end.friction, end.iterations);
    return slipping(end.normal, end.friction, end.direction, end.iterations);
  }

  const Domain& domain_;
  const Matrix& w_;
  const Vector& b_;
  double speed_;  ///< V
  double unit_;   ///< V/W_NN
  detail::ReducedContact<dimension> c_;
  detail::Secular<dimension> secular_;
};

/// The proximal point method: a compliance δ is added that makes the problem easy, and its effect taken away
/// by the friction of the last iterate.
template <class Domain>
void approach(const Domain& domain, double mu, const ContactMatrix<Domain>& w, const ContactVector<Domain>& b,
              OneContactSolution<Domain>& best) {
  using Vector = ContactVector<Domain>;
  constexpr int most_iterations = 30;
  constexpr double compliance = 0x1p-18;
  Vector delta = compliance * w.diagonal();
  delta[0] = 0;
  const ContactMatrix<Domain> stiff = w + ContactMatrix<Domain>(delta.asDiagonal());
  const double speed = b.cwiseAbs().maxCoeff();
  Vector z = best.state == ContactState::unsolved ? Vector(Vector::Zero()) : best.impulse;
  for (int i = 0; i < most_iterations; ++i) {
    const Vector shift = delta.cwiseProduct(z);
    const Vector shifted = b - shift;
    auto next = OneContact<Domain>(domain, mu, stiff, shifted).solve(z);
    if (next.state == ContactState::unsolved) return;
    const double residual = next.residual + (delta.cwiseProduct(next.impulse) - shift).norm() / speed;
    z = next.impulse;
    const int iterations = best.iterations + next.iterations;
    if (residual < best.residual) {
      best = next;
      best.residual = residual;
    }
    best.iterations = iterations;
    if (best.residual <= rounding) return;
  }
}

}  // namespace

template <class Domain>
OneContactSolution<Domain> solve_one_contact(const Domain& domain, double mu, const ContactMatrix<Domain>& w,
                                             const ContactVector<Domain>& b,
                                             const ContactVector<Domain>& guess) {
  const ContactVector<Domain> zero = ContactVector<Domain>::Zero();
  if (b[0] >= 0) return {zero, ContactState::open, 0, 0};
  if (!(w(0, 0) > 0)) return {zero, ContactState::unsolved, 0, std::numeric_limits<double>::infinity()};
  const OneContact<Domain> contact(domain, mu, w, b);
  auto best = contact.solve(guess);
  if (best.residual <= rounding) return best;
  approach(domain, mu, w, b, best);
  return best.residual <= rounding ? best : contact.polished(best);
}

template <>
OneContactSolution<NoFriction> solve_one_contact(const NoFriction&, double,
                                                 const ContactMatrix<NoFriction>& w,
                                                 const ContactVector<NoFriction>& b,
                                                 const ContactVector<NoFriction>&) {
  if (b[0] >= 0) return {ContactVector<NoFriction>::Zero(), ContactState::open, 0, 0};
  const ContactVector<NoFriction> impulse(-b[0] / w(0, 0));
  if (impulse[0] > 0 && std::isfinite(impulse[0])) return {impulse, ContactState::stick, 0, 0};
  return {ContactVector<NoFriction>::Zero(), ContactState::unsolved, 0,
          std::numeric_limits<double>::infinity()};
}

#define CONTENSOU_ONE_CONTACT(DOMAIN)                                                                        \
  template OneContactSolution<DOMAIN> solve_one_contact(const DOMAIN&, double, const ContactMatrix<DOMAIN>&, \
                                                        const ContactVector<DOMAIN>&,                        \
                                                        const ContactVector<DOMAIN>&);
CONTENSOU_ONE_CONTACT(FrictionDisk)
CONTENSOU_ONE_CONTACT(FrictionBall<SmoothPlate<UniformLaw>>)
CONTENSOU_ONE_CONTACT(FrictionBall<SmoothPlate<HertzLaw>>)
CONTENSOU_ONE_CONTACT(FrictionBall<SmoothPlate<CompiledLaw>>)
CONTENSOU_ONE_CONTACT(FrictionBall<SmoothPlate<EllipsoidLaw>>)
#undef CONTENSOU_ONE_CONTACT

}  // namespace contensou
