#pragma once

#include <vector>

#include "contensou/granular/anderson.hpp"
#include "contensou/granular/contact_set.hpp"
#include "contensou/granular/worker_team.hpp"

namespace contensou {

/// What a solve reached.
struct [[nodiscard]] BlockReport {
  int sweeps = 0;
  double residual = 0;  ///< natural map, in units of the largest |b| of all contacts
  bool solved = true;
};

/// The inclusion (4.7)–(4.9) for all contacts of a step by block Gauss–Seidel on the velocities of the
/// bodies: contact after contact, each solved exactly for what the others do (one_contact.hpp), and its
/// impulse applied to its bodies at once; accelerated by Anderson's method (anderson.hpp) with impulses
/// weighted by √W_ii, each of its steps projected on the friction cones: in piles that takes a quarter of
/// the sweeps. Memory and time of a sweep grow with the contacts.
///
/// The residual (that of contact_problem.hpp, V = max |b| over all contacts) is looked at when a sweep
/// changes velocities by little enough, and every 16 sweeps; the result is the best that was looked at. Where
/// looks find no better, sweeps go on without acceleration for a while: it can be caught in a cycle where
/// contacts stick and slip in turn, the more so the larger μ is.
///
/// Contacts of one colour are shared among the team where there are enough of them; all sums are in an order
/// that does not depend on how many share.
class BlockSolver {
 public:
  /// tolerance: of the residual; most_sweeps >= 1. The team outlives it.
  BlockSolver(double tolerance, int most_sweeps, WorkerTeam& team);

  /// Solves for the impulses of `set`, from those it has. `twists`: free velocities on entry, those after the
  /// step on return. Bounded; allocates nothing once sets stop growing.
  BlockReport solve(ContactSet& set, const std::vector<Mobility>& mobility, std::vector<Twist>& twists);

 private:
  template <class Work>
  double largest_of(ContactSet& set, bool in_colours, Work&& work);
  double largest_speed(ContactSet& set);
  void apply_all(ContactSet& set, const std::vector<Mobility>& mobility, std::vector<Twist>& twists);
  double sweep(ContactSet& set, const std::vector<Mobility>& mobility, std::vector<Twist>& twists);
  double residual(ContactSet& set, const std::vector<Twist>& twists, double speed);
  void gather(ContactSet& set, Eigen::VectorXd& x);
  void scatter(const Eigen::VectorXd& x, ContactSet& set);

  double tolerance_;
  int most_sweeps_;
  WorkerTeam& team_;
  std::vector<double> largest_;  ///< of each worker
  std::vector<Twist> free_;
  Eigen::VectorXd x_, g_, best_x_;
  Anderson anderson_;
};

}  // namespace contensou
