#pragma once

#include <Eigen/Core>
#include <vector>

#include "contensou/contact/contact_problem.hpp"
#include "contensou/integrate/mechanical_system.hpp"

namespace contensou {

/// The contacts that take part in a time-step, as one contact problem on velocity level: each a group of its
/// own, in the order of their indices. n rows in all.
class StepContacts {
 public:
  explicit StepContacts(const MechanicalSystem& system);

  /// Chooses contacts, indices ascending, all rows of theirs. Allocates only where they are others than
  /// before.
  void choose(const std::vector<std::size_t>& contacts);
  /// Which of the chosen contacts, by k, until others are chosen, are taken for point contacts: FrictionDisk
  /// and no drilling row. May allocate where these are others than before.
  void take_for_points(const std::vector<char>& points);
  bool is_point(std::size_t k) const { return points_[k] != 0; }
  /// γ_τ of a contact taken for a point contact, with what was last evaluated, as the system writes it.
  double drilling_velocity(std::size_t k, ConstVector u) const;
  const std::vector<std::size_t>& chosen() const { return chosen_; }
  bool empty() const { return chosen_.empty(); }

  /// First row and number of rows of chosen()[k].
  Eigen::Index row(std::size_t k) const { return first_row_[k]; }
  Eigen::Index rows(std::size_t k) const { return first_row_[k + 1] - first_row_[k]; }
  Eigen::Index rows() const { return first_row_.back(); }

  /// The chosen contacts, by k, whose radius follows the load.
  const std::vector<std::size_t>& load_dependent() const { return load_dependent_; }
  const LoadRadius& load_radius(std::size_t k) const { return *system_.contacts()[chosen_[k]].load_radius; }
  /// R [m] of one of these from the next evaluate() on: its drilling row, which the system writes in
  /// SystemContact::radius, is multiplied by the quotient. Zero unless set.
  void set_radius(std::size_t k, double radius) { radius_[k] = radius; }
  double radius(std::size_t k) const { return radius_[k]; }

  /// W, M⁻¹W, w̃ and with them the Delassus matrix at (t, q).
  void evaluate(double t, ConstVector q);
  /// γ = Wᵀu + w̃ with what was last evaluated.
  void velocity(ConstVector u, VectorRef gamma) const;

  const Eigen::MatrixXd& directions() const { return directions_; }  ///< W, f × n
  const Eigen::MatrixXd& response() const { return response_; }      ///< M⁻¹W, f × n
  const Eigen::VectorXd& drive() const { return drive_; }            ///< w̃, n
  /// Its free_velocity is left to the caller.
  ContactProblem& problem() { return problem_; }

 private:
  void lay_out();

  const MechanicalSystem& system_;
  std::vector<std::size_t> chosen_;
  std::vector<char> points_;
  std::vector<Eigen::Index> first_row_{0};
  std::vector<std::size_t> load_dependent_;
  std::vector<double> radius_;  ///< of each chosen contact; used where it depends on the load
  ContactRows contact_;
  Eigen::MatrixXd drilling_directions_;  ///< w_τ of contacts taken for point contacts, f × chosen
  Eigen::VectorXd drilling_drive_;       ///< and w̃_τ
  Eigen::VectorXd at_rest_;              ///< u = 0
  Eigen::MatrixXd directions_;
  Eigen::MatrixXd response_;
  Eigen::VectorXd drive_;
  ContactProblem problem_;
};

}  // namespace contensou
