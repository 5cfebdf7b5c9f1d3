#include "contensou/granular/block_solver.hpp"

#include <algorithm>
#include <cmath>

#include "contensou/contact/blocks.hpp"
#include "contensou/contact/one_contact.hpp"

namespace contensou {
namespace {

constexpr int sweeps_between_looks = 16;

/// γ of a contact with its normal row counted from c.
template <int rows>
auto shifted_velocity(const ContactBlock<rows>& c, const std::vector<Twist>& twists) {
  auto gamma = c.velocity(twists);
  gamma[0] -= c.target;
  return gamma;
}

/// max |b| over all contacts.
double largest_speed(ContactSet& set, const std::vector<Twist>& free) {
  double speed = 0;
  set.for_each_run([&](const auto&, const ContactSet::Run&, auto blocks) {
    for (const auto& c : blocks) speed = std::max(speed, shifted_velocity(c, free).cwiseAbs().maxCoeff());
  });
  return speed;
}

void apply_all(ContactSet& set, const std::vector<Mobility>& mobility, std::vector<Twist>& twists) {
  set.for_each_run([&](const auto&, const ContactSet::Run&, auto blocks) {
    for (const auto& c : blocks) {
      if (!c.impulse.isZero(0)) c.apply(c.impulse, mobility, twists);
    }
  });
}

/// Solves each contact once; returns the largest change of a contact's own velocity.
double sweep(ContactSet& set, const std::vector<Mobility>& mobility, std::vector<Twist>& twists) {
  double largest = 0;
  set.for_each_run([&]<class Domain>(const Domain& domain, const ContactSet::Run& run, auto blocks) {
    for (auto& c : blocks) {
      const ContactVector<Domain> b = shifted_velocity(c, twists) - c.w * c.impulse;
      if (b[0] >= 0 && c.impulse.isZero(0)) continue;
      const auto exact = solve_one_contact<Domain>(domain, run.mu, c.w, b, c.impulse);
      if (exact.state == ContactState::unsolved) continue;
      const ContactVector<Domain> change = exact.impulse - c.impulse;
      if (change.isZero(0)) continue;
      c.impulse = exact.impulse;
      c.apply(change, mobility, twists);
      largest = std::max(largest, change.cwiseAbs().maxCoeff() / c.step);
    }
  });
  return largest;
}

double residual(ContactSet& set, const std::vector<Twist>& twists, double speed) {
  double largest = 0;
  set.for_each_run([&]<class Domain>(const Domain& domain, const ContactSet::Run& run, auto blocks) {
    for (const auto& c : blocks) {
      const ContactVector<Domain> gamma = shifted_velocity(c, twists);
      largest = std::max(largest, contact_residual<Domain>(domain, run.mu, c.impulse, gamma, c.step, speed));
    }
  });
  return largest;
}

}  // namespace

BlockReport BlockSolver::solve(ContactSet& set, const std::vector<Mobility>& mobility,
                               std::vector<Twist>& twists) {
  free_ = twists;
  const double speed = largest_speed(set, free_);
  BlockReport report;
  if (!std::isfinite(speed)) return {0, speed, false};
  if (speed == 0) {
    set.for_each_run([](const auto&, const ContactSet::Run&, auto blocks) {
      for (auto& c : blocks) c.impulse.setZero();
    });
    return report;
  }
  apply_all(set, mobility, twists);
  const double goal = tolerance_ * speed;
  report.solved = false;
  while (!report.solved && report.sweeps < most_sweeps_) {
    const double change = sweep(set, mobility, twists);
    ++report.sweeps;
    if (!(change <= goal || report.sweeps % sweeps_between_looks == 0 || report.sweeps == most_sweeps_))
      continue;
    twists = free_;  // takes away what rounding has added up
    apply_all(set, mobility, twists);
    report.residual = residual(set, twists, speed);
    report.solved = report.residual <= tolerance_;
    if (!std::isfinite(report.residual)) break;
  }
  return report;
}

}  // namespace contensou
