#include "contensou/integrate/step_accounts.hpp"

#include <algorithm>

namespace contensou {

StepAccounts::StepAccounts(const MechanicalSystem& system)
    : system_(system),
      drives_(system.driven()),
      dissipated_(system.contacts().size()),
      work_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(system.works().size()))),
      power_(work_) {}

void StepAccounts::clear() {
  std::fill(dissipated_.begin(), dissipated_.end(), Dissipation{});
  work_.setZero();
  left_out_ = {};
}

void StepAccounts::add_power(const ImplicitStage& stage, double weight) {
  const StepContacts& contacts = stage.contacts();
  for (std::size_t k = 0; k < contacts.chosen().size(); ++k) {
    const Eigen::Index first = contacts.row(k);
    const Eigen::Index n = contacts.rows(k);
    const auto power = [&](Eigen::Index row) {
      return -weight * stage.impulse()[first + row] * stage.gamma()[first + row];
    };
    Dissipation& d = dissipated_[contacts.chosen()[k]];
    if (n > 1) d.sliding += power(1) + power(2);
    if (n > 3) d.drilling += power(3);
    if (drives_) add_driven(stage, k, weight);
    if (contacts.is_point(k)) add_left_out(stage, k, weight);
  }
}

void StepAccounts::add_impulses(const ImplicitStage& stage, const Eigen::VectorXd& u_start, bool landing) {
  const StepContacts& contacts = stage.contacts();
  gamma_start_.resize(contacts.rows());
  contacts.velocity(u_start, gamma_start_);
  for (std::size_t k = 0; k < contacts.chosen().size(); ++k) {
    const Eigen::Index first = contacts.row(k);
    const Eigen::Index n = contacts.rows(k);
    const auto work = [&](Eigen::Index row) {
      return -stage.impulse()[first + row] * (gamma_start_[first + row] + stage.gamma()[first + row]) / 2;
    };
    Dissipation& d = dissipated_[contacts.chosen()[k]];
    if (landing) {
      for (Eigen::Index row = 0; row < n; ++row) d.impact += work(row);
    } else {
      if (n > 1) d.sliding += work(1) + work(2);
      if (n > 3) d.drilling += work(3);
    }
    if (drives_) add_driven(stage, k, 1);
    if (contacts.is_point(k)) add_left_out(stage, k, 1);
  }
}

/// −weight Λ·w̃.
void StepAccounts::add_driven(const ImplicitStage& stage, std::size_t k, double weight) {
  const StepContacts& contacts = stage.contacts();
  const Eigen::Index first = contacts.row(k);
  const Eigen::Index n = contacts.rows(k);
  dissipated_[contacts.chosen()[k]].driven -=
      weight * stage.impulse().segment(first, n).dot(contacts.drive().segment(first, n));
}

void StepAccounts::add_left_out(const ImplicitStage& stage, std::size_t k, double weight) {
  const StepContacts& contacts = stage.contacts();
  const double size = system_.contacts()[contacts.chosen()[k]].mu * stage.impulse()[contacts.row(k)];
  ++left_out_.as_coulomb;
  left_out_.friction = std::max(left_out_.friction, stage.left_out(k));
  left_out_.impulse += weight * stage.left_out(k) * size;
}

void StepAccounts::add_work(double t, double dt, const Eigen::VectorXd& q, const Eigen::VectorXd& u0,
                            const Eigen::VectorXd& u1) {
  if (work_.size() == 0) return;
  u_mean_ = (u0 + u1) / 2;
  system_.powers(t, q, u_mean_, power_);
  work_ += dt * power_;
}

void StepAccounts::add_to(RunReport& run) const {
  for (std::size_t i = 0; i < run.dissipated.size(); ++i) {
    const Dissipation& taken = dissipated_[i];
    run.dissipated[i].sliding += taken.sliding;
    run.dissipated[i].drilling += taken.drilling;
    run.dissipated[i].impact += taken.impact;
    run.dissipated[i].driven += taken.driven;
  }
  for (std::size_t i = 0; i < run.work.size(); ++i) run.work[i] += work_[static_cast<Eigen::Index>(i)];
  run.left_out.as_coulomb += left_out_.as_coulomb;
  run.left_out.friction = std::max(run.left_out.friction, left_out_.friction);
  run.left_out.impulse += left_out_.impulse;
}

}  // namespace contensou
