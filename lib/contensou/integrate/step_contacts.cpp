#include "contensou/integrate/step_contacts.hpp"

namespace contensou {
namespace {

const AnyFriction& point_friction() {
  static const AnyFriction friction{FrictionDisk{}};
  return friction;
}

}  // namespace

StepContacts::StepContacts(const MechanicalSystem& system)
    : system_(system), contact_(system.velocities()), at_rest_(Eigen::VectorXd::Zero(system.velocities())) {
  chosen_.reserve(system.contacts().size());
  load_dependent_.reserve(system.contacts().size());
}

void StepContacts::choose(const std::vector<std::size_t>& contacts) {
  if (contacts == chosen_) return;
  chosen_ = contacts;
  points_.assign(chosen_.size(), 0);
  lay_out();
}

void StepContacts::take_for_points(const std::vector<char>& points) {
  if (points == points_) return;
  points_ = points;
  lay_out();
  drilling_directions_.resize(system_.velocities(), static_cast<Eigen::Index>(points_.size()));
  drilling_drive_.resize(static_cast<Eigen::Index>(points_.size()));
}

void StepContacts::lay_out() {
  first_row_.assign(1, 0);
  problem_.groups.clear();
  load_dependent_.clear();
  radius_.assign(chosen_.size(), 0);
  for (std::size_t k = 0; k < chosen_.size(); ++k) {
    const SystemContact& contact = system_.contacts()[chosen_[k]];
    const AnyFriction& friction = is_point(k) ? point_friction() : contact.friction;
    if (follows_load(contact) && !is_point(k)) load_dependent_.push_back(k);
    first_row_.push_back(first_row_.back() + contensou::rows(friction));
    problem_.groups.push_back({&friction, {contact.mu}});
  }
  directions_.resize(system_.velocities(), rows());
  response_.resize(system_.velocities(), rows());
  drive_.resize(rows());
  problem_.delassus.resize(rows(), rows());
  problem_.free_velocity.resize(rows());
}

void StepContacts::evaluate(double t, ConstVector q) {
  for (std::size_t k = 0; k < chosen_.size(); ++k) {
    system_.contact_rows(chosen_[k], t, q, at_rest_, contact_);
    directions_.middleCols(row(k), rows(k)) = contact_.directions.leftCols(rows(k));
    response_.middleCols(row(k), rows(k)) = contact_.response.leftCols(rows(k));
    drive_.segment(row(k), rows(k)) = contact_.velocity.head(rows(k));
    if (!is_point(k)) continue;
    const auto column = static_cast<Eigen::Index>(k);
    drilling_directions_.col(column) = contact_.directions.col(3);
    drilling_drive_[column] = contact_.velocity[3];
  }
  for (const std::size_t k : load_dependent_) {
    const double factor = radius_[k] / system_.contacts()[chosen_[k]].radius;
    directions_.col(row(k) + 3) *= factor;
    response_.col(row(k) + 3) *= factor;
    drive_[row(k) + 3] *= factor;
  }
  for (Eigen::Index j = 0; j < rows(); ++j) {
    for (Eigen::Index i = j; i < rows(); ++i) {
      problem_.delassus(i, j) = directions_.col(i).dot(response_.col(j));
      problem_.delassus(j, i) = problem_.delassus(i, j);
    }
  }
}

double StepContacts::drilling_velocity(std::size_t k, ConstVector u) const {
  const auto column = static_cast<Eigen::Index>(k);
  return drilling_drive_[column] + drilling_directions_.col(column).dot(u);
}

void StepContacts::velocity(ConstVector u, VectorRef gamma) const {
  gamma = drive_;
  gamma.noalias() += directions_.transpose() * u;
}

}  // namespace contensou
