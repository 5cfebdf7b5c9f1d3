#include "contensou/integrate/point_contacts.hpp"

#include <algorithm>
#include <cmath>

namespace contensou {

PointContacts::PointContacts(const MechanicalSystem& system, const IntegratorOptions& options)
    : system_(system), rows_(options.fidelity ? system.velocities() : 0) {
  if (!options.fidelity) return;
  for (const SystemContact& contact : system.contacts())
    limits_.emplace_back(contact.friction, *options.fidelity);
  slip_.resize(limits_.size());
}

void PointContacts::forget(std::size_t chosen) {
  points_.assign(chosen, 0);
  left_out_.assign(chosen, 0);
  std::fill(slip_.begin(), slip_.end(), Eigen::Vector2d::Constant(std::nan("")));
}

void PointContacts::take_none() { std::fill(points_.begin(), points_.end(), char{0}); }

bool PointContacts::any() const {
  return std::any_of(points_.begin(), points_.end(), [](char point) { return point != 0; });
}

/// What γ_τ as the system writes it is to be multiplied by.
double PointContacts::drilling_factor(std::size_t contact, double lambda_n) const {
  const SystemContact& c = system_.contacts()[contact];
  return follows_load(c) ? c.load_radius->at(lambda_n) / c.radius : 1;
}

void PointContacts::find(const StepContacts& contacts, double t, const Eigen::VectorXd& q,
                         const Eigen::VectorXd& u, const std::vector<Eigen::Vector4d>& force) {
  constexpr double margin = 1.25;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const std::size_t i = contacts.chosen()[k];
    const double least = limits_[i].slip_ratio();
    if (std::isinf(least)) continue;
    Eigen::Vector2d& slip = slip_[i];
    if (std::isnan(slip[0])) {
      system_.contact_rows(i, t, q, u, rows_);
      const double drilling = rows_.velocity[3] * drilling_factor(i, force[i][0]);
      slip = {rows_.velocity.segment<2>(1).norm(), std::abs(drilling)};
    }
    points_[k] = slip[0] > 0 && slip[0] >= margin * least * slip[1];
  }
}

bool PointContacts::hold(const StepContacts& contacts, double w, const Eigen::VectorXd& u,
                         const Eigen::VectorXd& impulse, const Eigen::VectorXd& gamma, double uncertain) {
  bool all = true;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const std::size_t i = contacts.chosen()[k];
    const double least = limits_[i].slip_ratio();
    if (std::isinf(least)) continue;
    const Eigen::Index row = contacts.row(k);
    const bool point = contacts.is_point(k);
    const double drilling =
        point ? contacts.drilling_velocity(k, u) * drilling_factor(i, impulse[row] / w) : gamma[row + 3];
    Eigen::Vector2d& slip = slip_[i];
    slip = {gamma.segment<2>(row + 1).norm(), std::abs(drilling)};
    left_out_[k] = 0;
    if (!point || !(impulse[row] > 0)) continue;
    const bool holds = slip[0] > uncertain && slip[0] >= least * slip[1];
    if (holds) left_out_[k] = limits_[i].bound(slip[0], slip[1]);
    all = all && holds;
  }
  return all;
}

}  // namespace contensou
