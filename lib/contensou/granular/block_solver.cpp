#include "contensou/granular/block_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contensou/contact/blocks.hpp"
#include "contensou/contact/one_contact.hpp"

namespace contensou {
namespace {

constexpr int sweeps_between_looks = 16;
/// Looks that find nothing better than before, after which acceleration has been caught in a cycle of
/// contacts that stick and slip in turn, and sweeps without it that lead out. By trial: piles of 48 balls, μ
/// 0.2 to 1.
constexpr int most_vain_looks = 2;
constexpr int plain_sweeps = 80;
/// Fewer contacts than this in a run are not worth waiting for each other.
constexpr std::size_t worth_sharing = 64;

/// γ of a contact with its normal row counted from c.
template <int rows>
auto shifted_velocity(const ContactBlock<rows>& c, const std::vector<Twist>& twists) {
  auto gamma = c.velocity(twists);
  gamma[0] -= c.target;
  return gamma;
}

/// The one contact's solution; at once where its rows know nothing of each other.
template <class Domain>
ContactVector<Domain> solved_alone(const Domain& domain, double mu,
                                   const ContactBlock<1 + Domain::dimension>& c,
                                   const ContactVector<Domain>& b) {
  if constexpr (std::is_same_v<Domain, FrictionDisk>) {
    if (c.plain) {
      ContactVector<Domain> impulse = ContactVector<Domain>::Zero();
      if (b[0] >= 0) return impulse;
      impulse[0] = -b[0] / c.w(0, 0);
      const Eigen::Vector2d stick = -b.template tail<2>() / c.w(1, 1);
      const double length = stick.norm();
      const double most = mu * impulse[0];
      impulse.template tail<2>() = length <= most ? stick : Eigen::Vector2d(most / length * stick);
      return impulse;
    }
  }
  const auto exact = solve_one_contact<Domain>(domain, mu, c.w, b, c.impulse);
  return exact.state == ContactState::unsolved ? c.impulse : exact.impulse;
}

}  // namespace

BlockSolver::BlockSolver(double tolerance, int most_sweeps, WorkerTeam& team)
    : tolerance_(tolerance),
      most_sweeps_(most_sweeps),
      team_(team),
      largest_(static_cast<std::size_t>(team.size())) {}

/// The largest of work(domain, run, blocks), each worker having a part of the blocks of each run. With
/// in_colours, a run begins when the one before has ended.
template <class Work>
double BlockSolver::largest_of(ContactSet& set, bool in_colours, Work&& work) {
  if (team_.size() == 1 || set.largest_run() < worth_sharing) {
    double largest = 0;
    set.for_each_run([&](const auto& domain, const ContactSet::Run& run, auto blocks) {
      largest = std::max(largest, work(domain, run, blocks));
    });
    return largest;
  }
  const auto workers = static_cast<std::size_t>(team_.size());
  team_.run([&](int k) {
    const auto worker = static_cast<std::size_t>(k);
    double largest = 0;
    set.for_each_run([&](const auto& domain, const ContactSet::Run& run, auto blocks) {
      const std::size_t n = blocks.size();
      if (n < worth_sharing || run.colour == Colouring::rest) {
        if (worker == 0) largest = std::max(largest, work(domain, run, blocks));
      } else {
        const std::size_t first = n * worker / workers;
        const std::size_t last = n * (worker + 1) / workers;
        largest = std::max(largest, work(domain, run, blocks.subspan(first, last - first)));
      }
      if (in_colours) team_.meet();
    });
    largest_[worker] = largest;
  });
  return *std::max_element(largest_.begin(), largest_.end());
}

/// max |b| over all contacts.
double BlockSolver::largest_speed(ContactSet& set) {
  return largest_of(set, false, [&](const auto&, const ContactSet::Run&, auto blocks) {
    double speed = 0;
    for (const auto& c : blocks) speed = std::max(speed, shifted_velocity(c, free_).cwiseAbs().maxCoeff());
    return speed;
  });
}

/// The velocities of all impulses, anew: also takes away what rounding has added up.
void BlockSolver::apply_all(ContactSet& set, const std::vector<Mobility>& mobility,
                            std::vector<Twist>& twists) {
  twists = free_;
  largest_of(set, true, [&](const auto&, const ContactSet::Run&, auto blocks) {
    for (const auto& c : blocks) {
      if (!c.impulse.isZero(0)) c.apply(c.impulse, mobility, twists);
    }
    return 0.0;
  });
}

/// Solves each contact once; returns the largest change of a contact's own velocity.
double BlockSolver::sweep(ContactSet& set, const std::vector<Mobility>& mobility,
                          std::vector<Twist>& twists) {
  return largest_of(set, true,
                    [&]<class Domain>(const Domain& domain, const ContactSet::Run& run, auto blocks) {
                      double largest = 0;
                      for (auto& c : blocks) {
                        const ContactVector<Domain> b = shifted_velocity(c, twists) - c.w * c.impulse;
                        if (b[0] >= 0 && c.impulse.isZero(0)) continue;
                        const ContactVector<Domain> impulse = solved_alone(domain, run.mu, c, b);
                        const ContactVector<Domain> change = impulse - c.impulse;
                        if (change.isZero(0)) continue;
                        c.impulse = impulse;
                        c.apply(change, mobility, twists);
                        largest = std::max(largest, change.cwiseAbs().maxCoeff() / c.step);
                      }
                      return largest;
                    });
}

double BlockSolver::residual(ContactSet& set, const std::vector<Twist>& twists, double speed) {
  return largest_of(
      set, false, [&]<class Domain>(const Domain& domain, const ContactSet::Run& run, auto blocks) {
        double largest = 0;
        for (const auto& c : blocks) {
          const ContactVector<Domain> gamma = shifted_velocity(c, twists);
          const double part = contact_residual<Domain>(domain, run.mu, c.impulse, gamma, c.step, speed);
          if (!(part <= largest)) largest = part;
        }
        return largest;
      });
}

void BlockSolver::gather(ContactSet& set, Eigen::VectorXd& x) {
  Eigen::Index k = 0;
  set.for_each_run([&]<class Domain>(const Domain&, const ContactSet::Run&, auto blocks) {
    constexpr int rows = 1 + Domain::dimension;
    for (const auto& c : blocks) {
      x.segment<rows>(k) = c.impulse / c.weight;
      k += rows;
    }
  });
}

void BlockSolver::scatter(const Eigen::VectorXd& x, ContactSet& set) {
  Eigen::Index k = 0;
  set.for_each_run([&]<class Domain>(const Domain& domain, const ContactSet::Run& run, auto blocks) {
    constexpr int rows = 1 + Domain::dimension;
    for (auto& c : blocks) {
      c.impulse =
          project_contact<Domain>(domain, run.mu, ContactVector<Domain>(c.weight * x.segment<rows>(k)));
      k += rows;
    }
  });
}

BlockReport BlockSolver::solve(ContactSet& set, const std::vector<Mobility>& mobility,
                               std::vector<Twist>& twists) {
  free_ = twists;
  const double speed = largest_speed(set);
  BlockReport report;
  if (!std::isfinite(speed)) return {0, speed, false};
  if (speed == 0) {
    set.for_each_run([](const auto&, const ContactSet::Run&, auto blocks) {
      for (auto& c : blocks) c.impulse.setZero();
    });
    return report;
  }
  const Eigen::Index n = set.rows();
  if (x_.size() < n) {
    x_.resize(n);
    g_.resize(n);
    best_x_.resize(n);
  }
  anderson_.restart(n);
  apply_all(set, mobility, twists);
  const double goal = tolerance_ * speed;
  report.solved = false;
  double best = std::numeric_limits<double>::infinity();
  int vain_looks = 0;
  int plain = 0;
  while (true) {
    gather(set, x_);
    const double change = sweep(set, mobility, twists);
    ++report.sweeps;
    const bool last = report.sweeps == most_sweeps_ || !std::isfinite(change);
    if (change <= goal || last || report.sweeps % sweeps_between_looks == 0) {
      apply_all(set, mobility, twists);
      report.residual = residual(set, twists, speed);
      report.solved = report.residual <= tolerance_;
      if (report.solved) return report;
      if (report.residual < best) {
        if (report.residual < best / 2) vain_looks = 0;
        best = report.residual;
        gather(set, best_x_);
      } else {
        ++vain_looks;
      }
      if (last) {
        if (best < report.residual) {
          scatter(best_x_, set);
          apply_all(set, mobility, twists);
          report.residual = residual(set, twists, speed);
        }
        return report;
      }
      if (vain_looks >= most_vain_looks && plain == 0) {
        vain_looks = 0;
        plain = plain_sweeps;
        anderson_.restart(n);
      }
    }
    if (plain > 0) {
      --plain;
      continue;
    }
    gather(set, g_);
    anderson_.step(g_, x_);
    scatter(x_, set);
    apply_all(set, mobility, twists);
  }
}

}  // namespace contensou
