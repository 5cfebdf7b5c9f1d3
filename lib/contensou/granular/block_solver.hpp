#pragma once

#include <vector>

#include "contensou/granular/contact_set.hpp"

namespace contensou {

/// What a solve reached.
struct [[nodiscard]] BlockReport {
  int sweeps = 0;
  double residual = 0;  ///< natural map, in units of the largest |b| of all contacts
  bool solved = true;
};

/// The inclusion (4.7)–(4.9) for all contacts of a step by block Gauss–Seidel on the velocities of the
/// bodies: contact after contact, each solved exactly for what the others do (one_contact.hpp), and its
/// impulse applied to its bodies at once. Memory and time of a sweep grow with the contacts.
class BlockSolver {
 public:
  /// tolerance: of the residual; most_sweeps >= 1.
  BlockSolver(double tolerance, int most_sweeps) : tolerance_(tolerance), most_sweeps_(most_sweeps) {}

  /// Solves for the impulses of `set`, from those it has. `twists`: free velocities on entry, those after the
  /// step on return. Bounded; allocates nothing once sets stop growing.
  BlockReport solve(ContactSet& set, const std::vector<Mobility>& mobility, std::vector<Twist>& twists);

 private:
  double tolerance_;
  int most_sweeps_;
  std::vector<Twist> free_;
};

}  // namespace contensou
