#include "contensou/integrate/printed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "contensou/contact/blocks.hpp"
#include "contensou/text/number.hpp"

namespace contensou {

PrintedContacts::PrintedContacts(const MechanicalSystem& system, const IntegratorOptions& options,
                                 RunReport& report)
    : system_(system),
      report_(report),
      tolerance_(options.solver_tolerance),
      given_r_(options.r),
      contacts_(system),
      kept_(system.contacts().size(), Eigen::Vector4d::Zero()),
      modes_(system.contacts().size(), ContactMode::open),
      momentum_(system.contacts().size(), Eigen::MatrixX3d::Zero(system.velocities(), 3)),
      driven_(system.contacts().size(), Eigen::Vector3d::Zero()),
      power_(static_cast<Eigen::Index>(system.works().size())),
      q_mid_(system.coordinates()),
      q_end_(system.coordinates()),
      u_end_(system.velocities()),
      rates_(system.coordinates()),
      free_(system.velocities()) {
  for (const SystemContact& contact : system.contacts()) {
    if (contact.restitution != 0)
      throw std::invalid_argument("contact " + contact.name + ": restitution " +
                                  to_text(contact.restitution) + ", expected 0 with " + name(options.method));
  }
  closed_.reserve(system.contacts().size());
}

void PrintedContacts::step(double t, const Eigen::VectorXd& q, const Eigen::VectorXd& u, double dt) {
  const double t_mid = t + dt / 2;
  t_mid_ = t_mid;
  dt_ = dt;
  system_.coordinate_rates(q, u, rates_);
  q_mid_ = q + dt / 2 * rates_;
  system_.free_acceleration(t_mid, q_mid_, u, free_);
  ++report_.evaluations;
  classify(t_mid);
  iterate(t, u, dt);
  for (std::size_t k = 0; k < closed_.size(); ++k)
    kept_[closed_[k]].head(contacts_.rows(k)) = impulse_.segment(contacts_.row(k), contacts_.rows(k));
  system_.coordinate_rates(q_mid_, u_end_, rates_);
  q_end_ = q_mid_ + dt / 2 * rates_;
  if (power_.size() > 0) u_mean_ = (u + u_end_) / 2;
}

/// I_N and the terms of its contacts at the midpoint.
void PrintedContacts::classify(double t) {
  closed_.clear();
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    if (system_.gap(i, t, q_mid_) <= 0) closed_.push_back(i);
  }
  contacts_.choose(closed_);
  contacts_.evaluate(t, q_mid_);
  const double norm = closed_.empty() ? 0 : row_sum_norm(contacts_.problem().delassus);
  r_ = given_r_ ? *given_r_ : natural_step(norm, 1);
}

void PrintedContacts::iterate(double t, const Eigen::VectorXd& u, double dt) {
  u_end_ = u + dt * free_;
  if (closed_.empty()) return;
  const ContactProblem& problem = contacts_.problem();
  impulse_.resize(contacts_.rows());
  gamma_.resize(contacts_.rows());
  for (std::size_t k = 0; k < closed_.size(); ++k)
    impulse_.segment(contacts_.row(k), contacts_.rows(k)) = kept_[closed_[k]].head(contacts_.rows(k));
  contacts_.velocity(u_end_, gamma_);
  const double speed = gamma_.lpNorm<Eigen::Infinity>();  // of Λ = 0: what residuals are measured by

  ++report_.contact_problems;
  bool converged = false;
  bool finite = true;
  double error = 0;
  for (int k = 0; !converged && finite && k < most_iterations; ++k) {
    ++report_.contact_iterations;
    u_end_ = u + dt * free_;
    u_end_.noalias() += contacts_.response() * impulse_;
    contacts_.velocity(u_end_, gamma_);
    double normal = 0;
    double friction = 0;
    for_each_contact(problem, [&]<class Domain>(const TypedGroup<Domain>& group, Eigen::Index i) {
      auto lambda = group.segment(impulse_, i);
      const ContactVector<Domain> x = lambda - r_ * group.segment(gamma_, i);
      finite = finite && x.allFinite();
      if (!finite) return;
      const ContactVector<Domain> projected = project_contact(group.domain, group.mu[i], x);
      normal += (projected[0] - lambda[0]) * (projected[0] - lambda[0]);
      friction += (projected - lambda).template tail<Domain::dimension>().squaredNorm();
      lambda = projected;
    });
    error = std::sqrt(normal) + std::sqrt(friction);
    converged = error < tolerance_;
  }
  if (!converged && failures_++ == 0) first_failure_ = t;
  if (!finite) u_end_.setConstant(std::numeric_limits<double>::quiet_NaN());
  if (error > 0) report_.worst_residual = std::max(report_.worst_residual, error / (r_ * speed));
}

void PrintedContacts::begin_whole_step() {
  std::fill(modes_.begin(), modes_.end(), ContactMode::open);
  for (auto& momentum : momentum_) momentum.setZero();
  std::fill(driven_.begin(), driven_.end(), Eigen::Vector3d::Zero());
}

void PrintedContacts::add(double weight) {
  if (power_.size() > 0) {
    system_.powers(t_mid_, q_mid_, u_mean_, power_);
    for (std::size_t i = 0; i < report_.work.size(); ++i)
      report_.work[i] += weight * dt_ * power_[static_cast<Eigen::Index>(i)];
  }
  for (std::size_t k = 0; k < closed_.size(); ++k) {
    const std::size_t i = closed_[k];
    const Eigen::Index first = contacts_.row(k);
    const Eigen::Index n = contacts_.rows(k);
    for (Eigen::Index row = 0; row < n; ++row) {
      const Eigen::Index kind = row == 0 ? 0 : row == 3 ? 2 : 1;
      const double lambda = weight * impulse_[first + row];
      momentum_[i].col(kind) += lambda * contacts_.directions().col(first + row);
      driven_[i][kind] += lambda * contacts_.drive()[first + row];
    }
    if (!(impulse_[first] > 0)) continue;
    const bool sticks = n > 1 && gamma_.segment(first + 1, n - 1).norm() <= tolerance_ / r_;
    if (!sticks) modes_[i] = ContactMode::slip;
    if (sticks && modes_[i] == ContactMode::open) modes_[i] = ContactMode::stick;
  }
}

void PrintedContacts::end_whole_step(const Eigen::VectorXd& u_start, const Eigen::VectorXd& u_end,
                                     const std::vector<ContactMode>& before) {
  bool impact = false;
  for (std::size_t i = 0; i < modes_.size(); ++i)
    impact = impact || (before[i] == ContactMode::open && modes_[i] != ContactMode::open);
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    const auto work = [&](Eigen::Index kind) {
      return -momentum_[i].col(kind).dot(u_start + u_end) / 2 - driven_[i][kind];
    };
    Dissipation& dissipated = report_.dissipated[i];
    dissipated.driven -= driven_[i].sum();
    if (impact) {
      dissipated.impact += work(0) + work(1) + work(2);
    } else {
      dissipated.sliding += work(1);
      dissipated.drilling += work(2);
    }
  }
}

std::string PrintedContacts::complaint() const {
  if (failures_ == 0) return {};
  return std::to_string(failures_) + " of " + std::to_string(report_.contact_problems) +
         " contact problems not converged after " + std::to_string(most_iterations) +
         " iterations, first at t = " + to_text(first_failure_) + " s";
}

}  // namespace contensou
