#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "contensou/integrate/contact_dynamics.hpp"
#include "contensou/integrate/motion_scales.hpp"

namespace contensou {

/// Finds the first event in a step and lands on it. Events are zeros of monitors, which are not negative as
/// long as nothing happens: the gap of an open contact, the normal force of a closed one, and in one that
/// sticks what is left of friction, 1 − gauge(λ_F)/(μλ_N).
///
/// A contact that has just opened has a gap of zero, of either sign by rounding: it is watched for closing at
/// zero only once it has risen by some ten thousand roundings (armed), and that far below zero before.
/// Forces are watched for passing zero by 1e-10 of their scale, so that at the event it is plain on which
/// side they are.
class EventSearch {
 public:
  struct Found {
    double theta;         ///< in steps; 0: at the start
    std::size_t contact;  ///< whose monitor it is
    std::size_t monitor;
    bool of_friction;  ///< what is left of friction; else gap or normal force
  };

  /// All arguments outlive the search; `modes` is looked at anew with each call.
  EventSearch(ContactDynamics& dynamics, const MotionScales& scales, const std::vector<ContactMode>& modes);

  // `dynamics` was evaluated last of all at the (t, y) meant, here and in find().
  /// A phase begins at (t, y).
  void begin(double t, const Eigen::VectorXd& y);
  /// Open contacts that touch have yet to rise.
  void disarm_touching(double t, const Eigen::VectorXd& q);
  /// No longer watches how much of friction a sticking contact has left: dependent constraints share their
  /// forces in more than one way, and one of them holds. Until watch_all().
  void relax(std::size_t contact) { relaxed_[contact] = true; }
  void watch_all() { relaxed_.assign(relaxed_.size(), false); }
  bool any_relaxed() const { return std::find(relaxed_.begin(), relaxed_.end(), true) != relaxed_.end(); }
  /// Whether a contact is open and has not risen yet.
  bool fresh(std::size_t contact) const { return modes_[contact] == ContactMode::open && !armed_[contact]; }

  /// The first event in the step of length h from time t that `stepper` has just tried. Monitors are looked
  /// at on its end and, where they come near to zero or a gap has a minimum, inside; then on the event found.
  std::optional<Found> find(OdeStep& stepper, double t, double h);
  /// The step had no event and was taken: its end is the next one's start.
  void accept(double t, const Eigen::VectorXd& y);

  /// Tries the step again so that it ends at the event: of the length found, then corrected by the secant
  /// rule until the monitor's own end is at zero. Returns the length; none where it does not get there,
  /// because the step was too long for its continuous extension.
  std::optional<double> land(OdeStep& stepper, double t, const Eigen::VectorXd& y,
                             const Eigen::VectorXd& rate, double h, const Eigen::VectorXd& scale,
                             const Found& found);

  /// Where in the step just tried the spin γ_τ of a contact that slips has a zero; none where its signs at
  /// the ends are the same. The motion is smooth there.
  std::optional<double> spin_reversal(OdeStep& stepper, double t, double h, std::size_t contact);

 private:
  void monitor(double t, const Eigen::VectorXd& y, std::vector<double>& values) const;
  bool evaluate_between(OdeStep& stepper, double t, double h, double theta);
  bool comes_near() const;
  std::optional<double> lowest(std::size_t contact, OdeStep& stepper, double t, double h);
  std::optional<double> dip_inside(OdeStep& stepper, double t, double h);
  std::optional<double> near_zero_inside(OdeStep& stepper, double t, double h);
  std::optional<Found> first_zero(OdeStep& stepper, double t, double h, const std::vector<double>& values,
                                  double last);
  double normal_velocity(std::size_t contact, double t, const Eigen::VectorXd& y);
  double risen(OdeStep& stepper, double t, double h, std::size_t contact, double last);
  double locate(OdeStep& stepper, double t, double h, std::size_t monitor, double left, double right);
  void note_spins(std::vector<double>& spins) const;

  ContactDynamics& dynamics_;
  const MotionScales& scales_;
  const std::vector<ContactMode>& modes_;
  std::vector<bool> armed_;
  std::vector<bool> relaxed_;
  std::vector<double> at_start_, at_end_, between_values_;
  std::vector<double> seen_;                         ///< monitors where zeros are looked for before
  std::vector<double> spin_at_start_, spin_at_end_;  ///< 0 where there is none
  std::vector<double> rise_at_start_;                ///< γ_N of open contacts [m/s]
  Eigen::VectorXd between_, between_rate_;
  ContactRows rows_;
};

}  // namespace contensou
