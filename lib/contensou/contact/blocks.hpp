#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <variant>

#include "contensou/contact/contact_problem.hpp"

namespace contensou {

/// A force, impulse or velocity of one contact, (N, T1, T2, τ) as far as the contact has them.
template <class Domain>
using ContactVector = Eigen::Matrix<double, 1 + Domain::dimension, 1>;
/// A block of W between two contacts of a kind.
template <class Domain>
using ContactMatrix = Eigen::Matrix<double, 1 + Domain::dimension, 1 + Domain::dimension>;

/// A group of contacts whose kind of friction is known to the compiler: fixed-size pieces of the problem's
/// vectors and matrices. Contacts count from 0 within the group.
template <class Domain>
struct TypedGroup {
  using DomainType = Domain;
  static constexpr int rows = 1 + Domain::dimension;

  const Domain& domain;
  const double* mu;
  Eigen::Index count;
  Eigen::Index first_contact;  ///< of the group, in the whole problem
  Eigen::Index first_row;

  Eigen::Index row(Eigen::Index contact) const { return first_row + rows * contact; }
  /// The contact's piece of an impulse or velocity; assignable.
  template <class Vector>
  auto segment(Vector& x, Eigen::Index contact) const {
    return x.template segment<rows>(row(contact));
  }
  /// The contact's block W_ii.
  template <class Matrix>
  auto block(Matrix& w, Eigen::Index contact) const {
    return w.template block<rows, rows>(row(contact), row(contact));
  }
};

/// Calls function(TypedGroup<Domain>) for each group in order. The kind of friction is looked up here, once
/// for each group.
template <class Function>
void for_each_group(const ContactProblem& problem, Function&& function) {
  Eigen::Index contact = 0;
  Eigen::Index row = 0;
  for (const ContactGroup& group : problem.groups) {
    std::visit(
        [&]<class Domain>(const Domain& domain) {
          const auto count = static_cast<Eigen::Index>(group.mu.size());
          function(TypedGroup<Domain>{domain, group.mu.data(), count, contact, row});
          contact += count;
          row += TypedGroup<Domain>::rows * count;
        },
        *group.friction);
  }
}

/// Calls function(group, i) for each contact i of each TypedGroup, in order.
template <class Function>
void for_each_contact(const ContactProblem& problem, Function&& function) {
  for_each_group(problem, [&](const auto& group) {
    for (Eigen::Index i = 0; i < group.count; ++i) function(group, i);
  });
}

/// The size μΛ_N of the friction domain, kept finite.
inline double friction_size(double mu, double normal) {
  return std::min(mu * normal, std::numeric_limits<double>::max());
}

/// Π(x), LG03 (4.16) with footnote 1: the normal part on R+, then the friction on B(μΠ_N). x finite, else
/// std::domain_error.
template <class Domain>
ContactVector<Domain> project_contact(const Domain& domain, double mu, const ContactVector<Domain>& x) {
  ContactVector<Domain> p = ContactVector<Domain>::Zero();
  if (!(x[0] > 0)) return p;
  p[0] = x[0];
  if constexpr (Domain::dimension > 0) {
    constexpr int dimension = Domain::dimension;
    p.template tail<dimension>() =
        domain.project(x.template tail<dimension>(), friction_size(mu, x[0])).point;
  }
  return p;
}

/// The same, and an element of its generalised Jacobian ∂Π/∂x: not symmetric, since friction depends on the
/// normal part, μ ∂Π_F/∂(μΠ_N).
template <class Domain>
ContactVector<Domain> project_contact(const Domain& domain, double mu, const ContactVector<Domain>& x,
                                      ContactMatrix<Domain>& jacobian) {
  jacobian.setZero();
  ContactVector<Domain> p = ContactVector<Domain>::Zero();
  if (!(x[0] > 0)) return p;
  p[0] = x[0];
  jacobian(0, 0) = 1;
  if constexpr (Domain::dimension > 0) {
    constexpr int dimension = Domain::dimension;
    const Eigen::Matrix<double, dimension, 1> force = x.template tail<dimension>();
    const double size = friction_size(mu, x[0]);
    const auto q = domain.project(force, size);
    const auto d = domain.derivative(q, force, size);
    p.template tail<dimension>() = q.point;
    jacobian.template bottomRightCorner<dimension, dimension>() = d.force;
    jacobian.template bottomLeftCorner<dimension, 1>() = mu * d.size;
  }
  return p;
}

/// Largest sum of |entries| in a row of W_ii: at least its spectral radius.
template <class Matrix>
double row_sum_norm(const Matrix& w) {
  return w.cwiseAbs().rowwise().sum().maxCoeff();
}

/// r_i [kg] of a contact with ‖W_ii‖ = `norm`; `fallback` where that is zero or below the normal numbers.
inline double natural_step(double norm, double fallback) {
  return norm >= std::numeric_limits<double>::min() ? 1 / norm : fallback;
}

/// What is said of impulses whose residual has this computed value, and whose rounding moves γ by `rounding`,
/// both in units of V. Where that is so large that Λ − rγ is about Λ, whatever γ, the computed value may be
/// zero where there is no solution at all: then at least `rounding`.
inline double believable(double residual, double rounding) {
  constexpr double meaningless = 1e-6;
  return rounding > meaningless ? std::max(residual, rounding) : residual;
}

/// One contact's part in natural_map_residual: ‖Λ − Π(Λ − rγ)‖/(rV), V = `speed` >= 0, as far as the rounding
/// of Λ itself leaves it `believable`. V = 0 leaves 0 and infinity. Not finite input gives infinity, never an
/// exception.
template <class Domain>
double contact_residual(const Domain& domain, double mu, const ContactVector<Domain>& lambda,
                        const ContactVector<Domain>& gamma, double r, double speed) {
  const ContactVector<Domain> x = lambda - r * gamma;
  if (!x.allFinite()) return std::numeric_limits<double>::infinity();
  const ContactVector<Domain> difference = lambda - project_contact(domain, mu, x);
  const bool zero = difference.isZero(0);
  if (speed == 0) return zero ? 0 : std::numeric_limits<double>::infinity();
  const double residual = zero ? 0 : (difference / r / speed).norm();
  return believable(residual, std::numeric_limits<double>::epsilon() * (lambda / r / speed).norm());
}

/// r_i [kg] of each contact: 1/‖W_ii‖ in the row-sum norm; where W_ii is zero (or below the normal numbers),
/// 1/(largest ‖W_jj‖), and 1 kg where all are. `step` is resized to the number of contacts.
void natural_steps(const ContactProblem& problem, Eigen::VectorXd& step);

/// γ = WΛ + b, summed in long double: for certificates. Where large impulses balance, the rounding of sums in
/// double would hide what is left of them. `velocity` has the right size; allocates nothing.
void certified_velocity(const ContactProblem& problem, const Eigen::VectorXd& impulse,
                        Eigen::VectorXd& velocity);

/// natural_map_residual where γ = WΛ + b and r are at hand; allocates nothing. Not finite input gives
/// infinity, never an exception.
double natural_map_residual(const ContactProblem& problem, const Eigen::VectorXd& impulse,
                            const Eigen::VectorXd& velocity, const Eigen::VectorXd& step);

}  // namespace contensou
