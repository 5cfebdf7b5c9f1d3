#pragma once

#include <string>
#include <vector>

#include "contensou/scene/outcome.hpp"

namespace verify::answers {

/// A shipped scene, run.
class Shipped {
 public:
  /// "sliding_disc", and what to change, as `--set` takes it. Throws SceneError and what compose() and run()
  /// throw; std::runtime_error where the run does not reach its end.
  explicit Shipped(const std::string& scene, const std::vector<std::string>& changes = {});

  const contensou::Outcome& outcome() const { return outcome_; }
  const contensou::RunReport& report() const { return outcome_.report; }
  const contensou::State& end() const { return end_; }

  /// What [outcome.NAME] says; throws std::invalid_argument where the scene has none.
  double measured(const std::string& name) const;
  std::size_t rows() const { return outcome_.row_count(); }
  double at(const std::string& column, std::size_t row) const;
  /// Times of the rows before `end` [s].
  std::vector<double> times_until(double end) const;
  double last(const std::string& column) const { return at(column, rows() - 1); }
  /// Of all its events of this kind (by contact, where one is named) [s].
  std::vector<double> times(contensou::EventKind kind, const std::string& contact = "") const;

  /// What the steps can have added up to, relative to the motion's scales: each at most the tolerance.
  double steps_error() const { return static_cast<double>(report().steps) * tolerance_; }

 private:
  std::vector<contensou::MeasureScene> measures_;
  contensou::Outcome outcome_;
  contensou::State end_{};
  double tolerance_ = 0;
};

}  // namespace verify::answers
