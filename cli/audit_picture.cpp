#include "audit_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "audit_table.hpp"
#include "contensou/text/quoted.hpp"
#include "svg.hpp"

namespace cli {
namespace {

using contensou::Audit;
using contensou::AuditRow;
using contensou::Variation;
using Align = Svg::Align;

constexpr std::size_t most_outcomes = 5;
constexpr double line_height = 22, top = 84, below = 46, labels = 300, panel = 190, gap = 34, right = 30;

/// A logarithmic axis over whole decades.
struct Axis {
  double left;   ///< [px]
  int from, to;  ///< powers of ten
  double at(double value) const {
    const double share = (std::log10(value) - from) / (to - from);
    return left + panel * std::clamp(share, 0.0, 1.0);
  }
};

/// The decades that hold all of these, at least `least` of them; values that are no positive numbers do not
/// count.
Axis axis_of(const std::vector<double>& values, double left, int from, int to) {
  bool any = false;
  for (const double value : values) {
    if (!(value > 0 && std::isfinite(value))) continue;
    const int low = static_cast<int>(std::floor(std::log10(value)));
    const int high = static_cast<int>(std::ceil(std::log10(value)));
    from = any ? std::min(from, low) : low;
    to = any ? std::max(to, high) : high;
    any = true;
  }
  return {left, from, std::max(to, from + 1)};
}

std::string power(int exponent) {
  if (exponent == 0) return "1";
  if (exponent == 1) return "10";
  if (exponent == -1) return "0.1";
  static const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) text += digits[digit - '0'];
  return text;
}

class Picture {
 public:
  Picture(const Audit& audit, const contensou::Scene& scene)
      : audit_(audit),
        outcomes_(std::min(audit.measures.size(), most_outcomes)),
        height_(top + line_height * static_cast<double>(audit.rows.size()) + below),
        svg_(labels + (panel + gap) * static_cast<double>(outcomes_ + 1) + right, height_,
             "What each effect is worth: " + scene.name) {
    svg_.text(16, 26, "What each effect is worth: " + scene.name, Align::left, Svg::ink, 16);
    svg_.text(labels + panel + gap, 26, "relative change of", Align::left, Svg::grey);
  }

  std::string drawn() {
    stripes();
    times();
    for (std::size_t k = 0; k < outcomes_; ++k) outcome(k);
    if (outcomes_ < audit_.measures.size())
      svg_.text(16, height_ - 10,
                "the first " + std::to_string(outcomes_) + " of " + std::to_string(audit_.measures.size()) +
                    " outcomes; the table has all",
                Align::left, Svg::grey, 12);
    return svg_.finished();
  }

 private:
  double y(std::size_t i) const { return top + line_height * (static_cast<double>(i) + 0.5); }
  double bottom() const { return height_ - below; }

  void stripes() {
    for (std::size_t i = 0; i < audit_.rows.size(); ++i) {
      if (i % 2 == 0) svg_.rectangle(0, y(i) - line_height / 2, 4000, line_height, Svg::pale);
      const Variation& variation = audit_.variations[i];
      std::string label = i == 0 ? "the scene as it is" : variation.effect + ": " + variation.variant;
      if (!variation.contacts.empty() && audit_.rows.size() > 1) label += " (" + variation.contacts + ')';
      if (variation.against != 0) label += " *";
      svg_.text(16, y(i) + 4.5, label);
    }
    const auto marked = [](const Variation& variation) { return variation.against != 0; };
    const auto found = std::find_if(audit_.variations.begin(), audit_.variations.end(), marked);
    if (found == audit_.variations.end()) return;
    const Variation& other = audit_.variations[found->against];
    svg_.text(labels + panel + gap, height_ - 10,
              "* compared with " + other.effect + ' ' + other.variant + ", which can do it", Align::left,
              Svg::grey, 12);
  }

  void frame(const Axis& axis, const std::string& title, const std::string& what) {
    svg_.text(axis.left, top - 24, title, Align::left, Svg::ink, 14);
    svg_.text(axis.left, top - 8, what, Align::left, Svg::grey, 12);
    const int every = 1 + (axis.to - axis.from - 1) / 5;
    for (int decade = axis.from; decade <= axis.to; ++decade) {
      const double x = axis.at(std::pow(10.0, decade));
      svg_.line(x, top, x, bottom(), {decade == 0 ? Svg::grey : Svg::light, 1});
      if (decade % every == 0) svg_.text(x, bottom() + 16, power(decade), Align::middle, Svg::grey, 12);
    }
  }

  void times() {
    std::vector<double> ratios{1};
    for (const AuditRow& row : audit_.rows) ratios.push_back(row.time_ratio);
    const Axis axis = axis_of(ratios, labels, -1, 1);
    frame(axis, "time", "of a run, ratio");
    for (std::size_t i = 0; i < audit_.rows.size(); ++i) {
      const double ratio = audit_.rows[i].time_ratio;
      if (!(ratio > 0)) {
        svg_.text(axis.left + 4, y(i) + 4.5, "not finished", Align::left, Svg::vermilion, 12);
        continue;
      }
      const double x = axis.at(ratio), one = axis.at(1);
      svg_.rectangle(std::min(x, one), y(i) - 5, std::max(std::abs(x - one), 1.0), 10,
                     ratio <= 1 ? Svg::green : Svg::vermilion);
    }
  }

  void outcome(std::size_t k) {
    const contensou::MeasureScene& measure = audit_.measures[k];
    std::vector<double> changes;
    for (const AuditRow& row : audit_.rows) changes.push_back(relative_change(row.outcomes[k]));
    const double left = labels + (panel + gap) * static_cast<double>(k + 1);
    const Axis axis = axis_of(changes, left, -3, 0);
    const std::string of = measure.column.empty() ? measure.event + ' ' + measure.contact : measure.column;
    frame(axis, contensou::shortened(measure.name),
          std::string(name(measure.kind)) + " of " + contensou::shortened(of));
    for (std::size_t i = 1; i < audit_.rows.size(); ++i) {
      if (!audit_.rows[i].finished()) continue;
      const double change = changes[i];
      if (change > 0 && std::isfinite(change)) {
        svg_.line(axis.left, y(i), axis.at(change), y(i), {Svg::blue, 1.4});
        svg_.circle(axis.at(change), y(i), 4, Svg::blue);
      } else {
        svg_.text(axis.left + 4, y(i) + 4.5, reason(audit_.rows[i].outcomes[k]), Align::left, Svg::grey, 12);
      }
    }
  }

  static std::string reason(const contensou::OutcomeChange& change) {
    if (change.change == 0) return "none";
    if (std::isfinite(change.change)) return "from 0";
    if (std::isnan(change.value)) return "no longer there";
    return std::isnan(change.reference) ? "only here" : "no number";
  }

  const Audit& audit_;
  std::size_t outcomes_;
  double height_;
  Svg svg_;
};

}  // namespace

std::string audit_picture(const Audit& audit, const contensou::Scene& scene) {
  return Picture(audit, scene).drawn();
}

}  // namespace cli
