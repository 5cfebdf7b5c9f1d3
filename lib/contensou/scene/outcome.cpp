#include "contensou/scene/outcome.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "contensou/scene/columns.hpp"

namespace contensou {
namespace {

using Kind = MeasureScene::Kind;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// One column of a trajectory against time.
class Curve {
 public:
  Curve(const Outcome& outcome, const std::string& column)
      : rows_(outcome.rows), width_(outcome.columns.size()), count_(outcome.row_count()) {
    const auto found = std::find(outcome.columns.begin(), outcome.columns.end(), column);
    if (found == outcome.columns.end())
      throw std::invalid_argument("outcome: the trajectory has no column " + column);
    index_ = static_cast<std::size_t>(found - outcome.columns.begin());
  }

  std::size_t count() const { return count_; }
  double time(std::size_t row) const { return rows_[row * width_]; }
  double value(std::size_t row) const { return rows_[row * width_ + index_]; }

 private:
  const std::vector<double>& rows_;
  std::size_t width_, count_;
  std::size_t index_ = 0;
};

/// When the curve is first at the level or on its other side.
double crossing(const Curve& curve, double level) {
  for (std::size_t i = 0; i < curve.count(); ++i) {
    const double now = curve.value(i) - level;
    if (now == 0) return curve.time(i);
    if (i == 0) continue;
    const double before = curve.value(i - 1) - level;
    if ((before < 0) != (now < 0) && !std::isnan(before) && !std::isnan(now))
      return curve.time(i - 1) + (curve.time(i) - curve.time(i - 1)) * (before / (before - now));
  }
  return none;
}

/// √(1/T ∫ f² dt) of what is linear between rows; value(i) at time(i).
template <class Value>
double root_mean_square(const Curve& curve, std::size_t count, const Value& value) {
  if (count == 0) return none;
  if (count == 1) return std::abs(value(0));
  double sum = 0;
  for (std::size_t i = 1; i < count; ++i) {
    const double a = value(i - 1), b = value(i);
    sum += (curve.time(i) - curve.time(i - 1)) * (a * a + a * b + b * b) / 3;
  }
  const double duration = curve.time(count - 1) - curve.time(0);
  return duration > 0 ? std::sqrt(sum / duration) : std::abs(value(0));
}

bool is(const Event& event, const MeasureScene& measure, const Outcome& outcome) {
  return outcome.contacts[event.contact] == measure.contact && name(event.kind) == measure.event;
}

double event_time(const MeasureScene& measure, const Outcome& outcome) {
  int left = measure.occurrence;
  for (const Event& event : outcome.report.events) {
    if (is(event, measure, outcome) && --left == 0) return event.t;
  }
  return none;
}

double event_count(const MeasureScene& measure, const Outcome& outcome) {
  const auto& events = outcome.report.events;
  return static_cast<double>(std::count_if(events.begin(), events.end(),
                                           [&](const Event& event) { return is(event, measure, outcome); }));
}

}  // namespace

const char* name(Kind kind) {
  switch (kind) {
    case Kind::final:
      return "final";
    case Kind::minimum:
      return "minimum";
    case Kind::maximum:
      return "maximum";
    case Kind::crossing:
      return "crossing";
    case Kind::event:
      return "event";
    case Kind::count:
      return "count";
    case Kind::trajectory:
      return "trajectory";
  }
  return "";
}

std::vector<MeasureScene> last_values(const Scene& scene) {
  std::vector<MeasureScene> measures;
  for (const std::string& column : columns(scene)) {
    MeasureScene& measure = measures.emplace_back();
    measure.name = measure.column = column;
  }
  return measures;
}

double evaluate(const MeasureScene& measure, const Outcome& outcome) {
  if (measure.kind == Kind::event) return event_time(measure, outcome);
  if (measure.kind == Kind::count) return event_count(measure, outcome);
  const Curve curve(outcome, measure.column);
  if (curve.count() == 0) return none;
  switch (measure.kind) {
    case Kind::crossing:
      return crossing(curve, measure.value);
    case Kind::trajectory:
      return root_mean_square(curve, curve.count(), [&](std::size_t i) { return curve.value(i); });
    case Kind::minimum:
    case Kind::maximum: {
      double most = curve.value(0);
      for (std::size_t i = 1; i < curve.count(); ++i)
        most =
            measure.kind == Kind::minimum ? std::min(most, curve.value(i)) : std::max(most, curve.value(i));
      return most;
    }
    default:
      return curve.value(curve.count() - 1);
  }
}

double difference(const MeasureScene& measure, const Outcome& a, const Outcome& b) {
  if (measure.kind != Kind::trajectory) {
    const double x = evaluate(measure, a), y = evaluate(measure, b);
    return std::isnan(x) && std::isnan(y) ? 0 : std::abs(y - x);
  }
  const Curve first(a, measure.column), second(b, measure.column);
  // Both have rows at multiples of one interval; one that ended early ends with a row of its own.
  std::size_t count = 0;
  while (count < std::min(first.count(), second.count()) && first.time(count) == second.time(count)) ++count;
  return root_mean_square(first, count, [&](std::size_t i) { return second.value(i) - first.value(i); });
}

}  // namespace contensou
