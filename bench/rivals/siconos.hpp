#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

namespace rivals {

/// A contact problem as Siconos knows it: 3-D Coulomb friction at n contacts, rows (N, T1, T2) each,
///     u = W r + q,   0 <= u_N ⊥ r_N >= 0,   −u_T ∈ N(r_T) of the disk of radius μ r_N;
/// the same order and the same signs as contensou::ContactProblem with friction disks alone. W need not be
/// symmetric. [W] = 1/kg, [q] = m/s, [r] = Ns.
class SiconosProblem {
 public:
  /// How Siconos stores W: as one matrix, or as 3 × 3 blocks, which suits its Gauss–Seidel methods.
  enum class Storage { dense, blocks };

  /// Copies what it is given: W 3n × 3n, q 3n, mu n. Throws std::invalid_argument for other sizes.
  SiconosProblem(const Eigen::MatrixXd& w, const Eigen::VectorXd& q, const std::vector<double>& mu,
                 Storage storage = Storage::dense);
  ~SiconosProblem();
  SiconosProblem(SiconosProblem&&) noexcept;
  SiconosProblem& operator=(SiconosProblem&&) noexcept;

  /// Another right-hand side of the same size, for a series of problems.
  void set_free_velocity(const Eigen::VectorXd& q);
  int contacts() const;

  /// Siconos's own measure of a reaction, fc3d_compute_error: ‖r − P_K(r − u − μ‖u_T‖ e_N)‖ over the largest
  /// of ‖q‖, ‖r‖ and ‖u‖, with the projection P_K on Coulomb's cones (De Saxcé). It adds metres per second to
  /// newton seconds.
  double error(const Eigen::VectorXd& reaction) const;

 private:
  friend class SiconosSolver;
  struct Data;
  std::unique_ptr<Data> data_;
};

/// What a solver of Siconos says of its own work.
struct SiconosOutcome {
  int info;        ///< 0: it believes that it has converged
  int iterations;  ///< as it counts them; not every solver does
};

struct SiconosMethod {
  std::string name;  ///< after Siconos's own identifiers; of Gauss–Seidel with the solver of one contact
  bool one_contact;  ///< takes a single contact only
  SiconosProblem::Storage storage;  ///< of W, on which it is fastest, or runs at all
};

/// The solvers of Siconos Numerics 4.4 that can be called on such a problem without more ado, in the version
/// that Debian 12 compiles (assertions on). Left out are those that end the program, at once (NSGSV with its
/// default local solver, PFP, SOCLCP) or where rounding lets an assertion fail (NSN_FB); that do not end
/// (HP); that solve no problem as delivered (NSN_NM, the projection as one-contact solver); and what needs
/// GAMS or PATH.
const std::vector<SiconosMethod>& siconos_methods();

/// A solver of Siconos.
class SiconosSolver {
 public:
  /// `name` is one of siconos_methods(); the tolerance is of its own measure of error. max_iterations = 0:
  /// its own limit. Throws std::invalid_argument for an unknown name.
  explicit SiconosSolver(const std::string& name, double tolerance, int max_iterations = 0);
  ~SiconosSolver();
  SiconosSolver(SiconosSolver&&) noexcept;
  SiconosSolver& operator=(SiconosSolver&&) noexcept;

  /// `reaction` and `velocity` of size 3n; on entry the guess, on return what was found. One solver serves
  /// problems of one size.
  SiconosOutcome solve(SiconosProblem& problem, Eigen::VectorXd& reaction, Eigen::VectorXd& velocity);

 private:
  struct Options;
  std::unique_ptr<Options> options_;
};

/// While it lives, nothing that anybody in this process writes to standard output or standard error is seen:
/// Siconos prints its warnings whatever one asks for.
class Silence {
 public:
  Silence();
  ~Silence();
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int output_;
  int error_;
};

}  // namespace rivals
