#include "contact/inclusion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <variant>
#include <vector>

#include "contact/potential.hpp"
#include "worst.hpp"

namespace random_contact {
namespace {

using namespace contensou;

/// max over unit directions of (t, τ)·(sin ψ, cos ψ) − size Φ(sin ψ, cos ψ): the distance of an outer point.
template <class Domain>
double excess(const Domain& domain, double t, double tau, double size) {
  constexpr int directions = 256;
  const auto at = [&](double psi) {
    const double v = std::sin(psi);
    const double s = std::abs(std::cos(psi));
    return t * v + tau * s - size * Potential{}(domain, v, s);
  };
  if constexpr (Domain::dimension == 2) return t - size;
  const double spacing = std::numbers::pi / 2 / directions;
  int best = 0;
  for (int i = 1; i <= directions; ++i) {
    if (at(i * spacing) > at(best * spacing)) best = i;
  }
  double low = std::max(0, best - 1) * spacing;
  double high = std::min(directions, best + 1) * spacing;
  double found = at(best * spacing);
  constexpr double golden = 0.3819660112501051;
  for (int i = 0; i < 60; ++i) {
    const double left = low + golden * (high - low);
    const double right = high - golden * (high - low);
    const double at_left = at(left);
    const double at_right = at(right);
    found = std::max({found, at_left, at_right});
    (at_left > at_right ? high : low) = at_left > at_right ? right : left;
  }
  return found;
}

struct Scales {
  double speed;  ///< V
  double r;      ///< 1/‖W_ii‖
};

template <class Domain>
void add_friction_errors(const Domain& domain, double mu, const Scales& scales, double normal_impulse,
                         const Eigen::VectorXd& force, const Eigen::VectorXd& slip, verify::Worst& worst) {
  const double size = mu * std::max(0.0, normal_impulse);
  const double t = force.head<2>().norm();
  const double v = slip.head<2>().norm();
  const double tau = Domain::dimension == 3 ? std::abs(force[2]) : 0;
  const double s = Domain::dimension == 3 ? std::abs(slip[2]) : 0;
  worst.add(excess(domain, t, tau, size) / (scales.r * scales.speed * (1 + mu)));
  const double gap = force.dot(slip) + size * Potential{}(domain, v, s);
  const double unit =
      scales.speed * (force.norm() + size + scales.r * (1 + mu) * (scales.speed + slip.norm()));
  worst.add(std::abs(gap) / unit);
}

/// Calls function(friction, mu, first row, rows) for each contact.
template <class Function>
void for_each(const ContactProblem& problem, const Function& function) {
  Eigen::Index row = 0;
  for (const ContactGroup& group : problem.groups) {
    const int count = rows(*group.friction);
    for (const double mu : group.mu) {
      function(*group.friction, mu, row, count);
      row += count;
    }
  }
}

/// Largest row sum of W_ii, of all blocks where that is zero, 1 where all are: the r of natural_map_residual.
double norm_of(const ContactProblem& problem, Eigen::Index row, int count) {
  const auto norm = [&](Eigen::Index at, int size) {
    return problem.delassus.block(at, at, size, size).cwiseAbs().rowwise().sum().maxCoeff();
  };
  const double own = norm(row, count);
  if (own >= std::numeric_limits<double>::min()) return own;
  double largest = 0;
  for_each(problem, [&](const AnyFriction&, double, Eigen::Index at, int size) {
    largest = std::max(largest, norm(at, size));
  });
  return largest >= std::numeric_limits<double>::min() ? largest : 1;
}

}  // namespace

double inclusion_residual(const ContactProblem& problem, const Eigen::VectorXd& impulse) {
  Eigen::VectorXd velocity(impulse.size());
  for (Eigen::Index i = 0; i < impulse.size(); ++i) {
    long double sum = problem.free_velocity[i];
    for (Eigen::Index j = 0; j < impulse.size(); ++j) {
      sum += static_cast<long double>(problem.delassus(i, j)) * impulse[j];
    }
    velocity[i] = static_cast<double>(sum);
  }
  const double speed = problem.free_velocity.cwiseAbs().maxCoeff();
  if (speed == 0) return impulse.isZero(0) ? 0 : std::numeric_limits<double>::infinity();
  verify::Worst worst;
  for_each(problem, [&](const AnyFriction& friction, double mu, Eigen::Index row, int count) {
    const Scales scales{speed, 1 / norm_of(problem, row, count)};
    worst.add(std::isnan(velocity[row]) ? velocity[row]
                                        : std::abs(std::min(velocity[row], impulse[row] / scales.r)) / speed);
    std::visit(
        [&]<class Domain>(const Domain& domain) {
          if constexpr (Domain::dimension > 0) {
            add_friction_errors(domain, mu, scales, impulse[row], impulse.segment(row + 1, Domain::dimension),
                                velocity.segment(row + 1, Domain::dimension), worst);
          }
        },
        friction);
  });
  return worst.value();
}

double rounding_spread(const ContactProblem& problem, const Eigen::VectorXd& impulse) {
  constexpr int patterns = 32;
  std::mt19937_64 random(5);
  const long double speed = problem.free_velocity.cwiseAbs().maxCoeff();
  std::vector<long double> shift(static_cast<std::size_t>(impulse.size()));
  verify::Worst worst;
  for (int k = 0; k < patterns; ++k) {
    for (std::size_t j = 0; j < shift.size(); ++j) {
      const long double half_ulp = 0x1p-53L * impulse[static_cast<Eigen::Index>(j)];
      shift[j] = random() >> 63 == 0 ? half_ulp : -half_ulp;
    }
    for (Eigen::Index i = 0; i < impulse.size(); ++i) {
      long double sum = 0;
      for (std::size_t j = 0; j < shift.size(); ++j) {
        sum += static_cast<long double>(problem.delassus(i, static_cast<Eigen::Index>(j))) * shift[j];
      }
      worst.add(static_cast<double>(std::abs(sum) / speed));
    }
  }
  for_each(problem, [&](const AnyFriction&, double, Eigen::Index row, int count) {
    const double length = 0x1p-53 * impulse.segment(row, count).norm();
    worst.add(length * norm_of(problem, row, count) / static_cast<double>(speed));
  });
  return worst.value();
}

}  // namespace random_contact
