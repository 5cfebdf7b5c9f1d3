#include "contensou/scene/audit.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "contensou/scene/outcome.hpp"
#include "contensou/text/number.hpp"

namespace contensou {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// A variation may take so much longer than the scene itself before it is given up.
constexpr double most_times = 50;
constexpr double least_limit = 30;  // [s]

constexpr double short_pass = 0.02;  // of one variation [s]

struct GivenUp : std::runtime_error {
  using std::runtime_error::runtime_error;
};

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

class Auditor {
 public:
  Auditor(const SceneDocument& document, const AuditOptions& options)
      : options_(options), scene_(read_scene(document)) {
    audit_.measures = scene_.measures;
    audit_.named = !scene_.measures.empty();
    if (!audit_.named) audit_.measures = last_values(scene_);
    audit_.variations = variations(document, scene_);
    audit_.rows.resize(audit_.variations.size());
    outcomes_.resize(audit_.variations.size());
    for (const Variation& variation : audit_.variations)
      if (variation.against != 0) references_.push_back(variation.against);
  }

  Audit all() {
    const int repeat = std::max(options_.repeat, 1);
    const std::size_t count = audit_.variations.size();
    for (int pass = 0; pass < repeat; ++pass) {
      for (std::size_t i = 0; i < count; ++i) {
        if (options_.progress)
          options_.progress(static_cast<std::size_t>(pass) * count + i,
                            static_cast<std::size_t>(repeat) * count, audit_.variations[i]);
        if (pass == 0) {
          first(i);
        } else if (audit_.rows[i].finished()) {
          again(i);
        }
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      const AuditRow& other = audit_.rows[audit_.variations[i].against];
      AuditRow& row = audit_.rows[i];
      row.time_ratio = row.finished() && other.finished() ? row.seconds / other.seconds : none;
    }
    return std::move(audit_);
  }

 private:
  Outcome run_once(std::size_t i) {
    Simulation simulation = compose(read_variation(audit_.variations[i], scene_));
    const Clock::time_point begin = Clock::now();
    const double limit = i == 0 ? std::numeric_limits<double>::infinity()
                                : std::max(least_limit, most_times * audit_.rows[0].seconds);
    return run(simulation, [&](double t) {
      if (seconds_since(begin) > limit) throw GivenUp("given up at t = " + to_text(t) + " s, too slow");
    });
  }

  /// The first run gives outcomes, too.
  void first(std::size_t i) {
    AuditRow& row = audit_.rows[i];
    row.outcomes.assign(audit_.measures.size(), {none, none, none});
    Outcome outcome;
    try {
      outcome = run_once(i);
    } catch (const std::exception& error) {
      if (i == 0) throw;
      row.status = error.what();
      return;
    }
    row.seconds = outcome.wall_seconds;
    row.steps = outcome.report.steps;
    if (outcome.report.status != RunStatus::finished) {
      row.status = std::string(name(outcome.report.status)) + " at t = " + to_text(outcome.t) + " s";
      if (!outcome.report.message.empty()) row.status += ": " + outcome.report.message;
      if (i == 0) throw std::runtime_error("the scene itself ended before its end: " + row.status);
      return;
    }
    const std::size_t against = audit_.variations[i].against;
    compare(i == against ? outcome : outcomes_[against], outcome, row);
    const bool wanted = i == 0 || std::find(references_.begin(), references_.end(), i) != references_.end();
    if (wanted) outcomes_[i] = std::move(outcome);
  }

  void compare(const std::optional<Outcome>& reference, const Outcome& outcome, AuditRow& row) {
    for (std::size_t k = 0; k < audit_.measures.size(); ++k) {
      const MeasureScene& measure = audit_.measures[k];
      const auto has = [&](const Outcome& of) {
        return measure.column.empty() ||
               std::find(of.columns.begin(), of.columns.end(), measure.column) != of.columns.end();
      };
      OutcomeChange& change = row.outcomes[k];
      if (has(outcome)) change.value = evaluate(measure, outcome);
      if (reference && has(*reference)) change.reference = evaluate(measure, *reference);
      if (reference && has(outcome) && has(*reference))
        change.change = difference(measure, *reference, outcome);
    }
  }

  /// A short run is soon disturbed: as many as fit into some milliseconds, composing included.
  void again(std::size_t i) {
    double& least = audit_.rows[i].seconds;
    const Clock::time_point begin = Clock::now();
    do {
      least = std::min(least, run_once(i).wall_seconds);
    } while (seconds_since(begin) < short_pass);
  }

  const AuditOptions& options_;
  Scene scene_;
  Audit audit_;
  std::vector<std::optional<Outcome>> outcomes_;  ///< of those that others are compared with
  std::vector<std::size_t> references_;
};

}  // namespace

Audit audit(const SceneDocument& document, const AuditOptions& options) {
  return Auditor(document, options).all();
}

}  // namespace contensou
