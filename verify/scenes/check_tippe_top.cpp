#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "checks.hpp"
#include "contensou/output/table.hpp"
#include "shipped.hpp"
#include "worst.hpp"

namespace verify::answers {
namespace {

using contensou::EventKind;
using contensou::Table;

/// What an error bar `error` and a sensitivity `spread` of the reference allow a run of tolerance 1e-12, as
/// tests/figures/compare_motions.cpp derives it: at most √16 tolerance a millisecond, coherent over 80 of
/// them.
double allowed(double error, double spread, double scale) {
  constexpr double tolerance = 1e-12, components = 16, coherent = 80;
  constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
  return error + tolerance * std::sqrt(components * coherent) * spread +
         (rounding + tolerance * std::sqrt(components)) * scale;
}

/// Until the impacts of the rocking accumulate: closings and openings, in order of time, then of name.
std::vector<std::pair<double, std::string>> happenings(const Shipped& run, double until) {
  std::vector<std::pair<double, std::string>> found;
  for (const EventKind kind : {EventKind::close, EventKind::open}) {
    for (const std::string contact : {"body", "tip"}) {
      for (const double t : run.times(kind, contact)) {
        if (t < until) found.emplace_back(t, std::string(contensou::name(kind)) + ' ' + contact);
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

void check_tippe_top_bodies(Sheet& sheet) {
  const std::string file = "tippe_top_bodies";
  const std::filesystem::path motions = CONTENSOU_REFERENCE_DATA "/motions";
  const Table events = contensou::read_table(motions / "tippe_top_hertz_5e-4_events.tsv");
  const Table curve = contensou::read_table(motions / "tippe_top_hertz_5e-4.tsv");
  const auto kinds = events.texts("event"), contacts = events.texts("contact");
  const auto times = events.numbers("t"), errors = events.numbers("t_error"),
             spreads = events.numbers("t_spread");
  const auto rest = std::find(kinds.begin(), kinds.end(), "accumulation");
  const double until = times.at(static_cast<std::size_t>(rest - kinds.begin()));
  std::vector<std::pair<double, std::size_t>> order;  // of the reference, as happenings() sorts
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] < until && (kinds[i] == "close" || kinds[i] == "open")) order.emplace_back(times[i], i);
  }
  std::stable_sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
    const auto name = [&](std::size_t i) { return kinds[i] + ' ' + contacts[i]; };
    return std::make_pair(a.first, name(a.second)) < std::make_pair(b.first, name(b.second));
  });

  const std::vector<std::string> fine{accurate, "output.interval=0.02"};
  const Shipped bodies(file, fine), model("tippe_top", fine);
  // The last of the series, resolved or summed as each integrator does, within this before its end.
  constexpr double summed = 1e-3;
  const auto ours = happenings(bodies, until - summed);
  while (!order.empty() && order.back().first >= until - summed) order.pop_back();
  Worst worst, between;
  for (std::size_t k = 0; k < std::min(ours.size(), order.size()); ++k) {
    const std::size_t i = order[k].second;
    const bool same = ours[k].second == kinds[i] + ' ' + contacts[i];
    worst.add(same ? std::abs(ours[k].first - times[i]) / allowed(errors[i], spreads[i], 0.04)
                   : std::numeric_limits<double>::infinity());
  }
  sheet.compare(
      {"top.count", file, "closings and openings until a millisecond before the rocking comes to rest",
       "reference_data/motions", static_cast<double>(order.size()), static_cast<double>(ours.size()), 0, 0});
  sheet.add({"top.events", file, "their times, largest error over what the tolerance of the steps allows",
             "quadruple precision: reference_data/motions", 0, worst.value(), worst.value(), 1});
  const auto at = curve.numbers("t"), theta = curve.numbers("theta"), error = curve.numbers("theta_error"),
             spread = curve.numbers("theta_spread");
  Worst inclination;
  for (std::size_t i = 0, k = 0; i < at.size(); ++i) {
    while (k + 1 < bodies.rows() && bodies.at("t", k) < at[i] - 1e-9) ++k;
    const double bound = allowed(error[i], spread[i], 4);
    inclination.add(std::abs(bodies.at("top.tilt", k) - theta[i]) / bound);
    between.add(std::abs(bodies.at("top.tilt", k) - model.at("theta", k)) / (2 * bound));
  }
  sheet.add({"top.inclination", file, "inclination all the way, largest error over what is allowed",
             "as above", 0, inclination.value(), inclination.value(), 1});
  sheet.add({"top.model", file,
             "inclination beside that of tippe_top.toml, largest difference over what is allowed",
             "the same motion", 0, between.value(), between.value(), 1});
  sheet.compare({"top.stick", file, "the stick touches at [s]", "reference_data/motions", times.at(0),
                 bodies.measured("stick_touches"), 0, allowed(errors.at(0), spreads.at(0), 0.04)});
}

}  // namespace verify::answers
