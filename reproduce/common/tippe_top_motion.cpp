#include "tippe_top_motion.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "contensou/law/hertz.hpp"
#include "contensou/law/uniform.hpp"
#include "curves.hpp"

namespace reproduce {
namespace {

using contensou::EventKind;

constexpr double shortest_told = 1e-5;  // [s] before an accumulation

contensou::AnyFriction friction(Pressure pressure) {
  if (pressure == Pressure::hertz) {
    return contensou::FrictionBall(contensou::SmoothPlate(contensou::HertzLaw()));
  }
  return contensou::FrictionBall(contensou::SmoothPlate(contensou::UniformLaw()));
}

}  // namespace

contensou::TippeTopAxis tippe_top(Pressure pressure, double radius) {
  return {{}, contensou::tippe_top_contacts(friction(pressure), 0.3, radius)};
}

contensou::RunReport move_tippe_top(const contensou::TippeTopAxis& top, double interval,
                                    const contensou::Observer& seen, double t_end) {
  contensou::IntegratorOptions options;
  options.tolerance = motion_tolerance;
  options.output_interval = interval;
  contensou::State state = top.start(0.1, 180);
  contensou::RunReport report = contensou::integrate(top, state, t_end, options, seen);
  if (report.status != contensou::RunStatus::finished) throw std::runtime_error(report.message);
  return report;
}

contensou::Table motion_table(const std::string& figure, const std::string& what, const std::string& units,
                              std::vector<std::string> columns) {
  contensou::Table table = curve_table(figure, what, units, "exact", std::move(columns));
  table.comments.insert(std::prev(table.comments.end()),
                        "integrator: event_driven, tolerance " + contensou::to_text(motion_tolerance));
  return table;
}

contensou::Table event_table(const std::string& figure, const std::string& what) {
  return motion_table(figure, what + "; impacts less than 1e-5 s before their accumulation left out", "s",
                      {"run", "t", "event", "contact"});
}

void add_events(contensou::Table& table, const std::string& run, const contensou::RunReport& report) {
  const auto last = std::find_if(report.events.rbegin(), report.events.rend(),
                                 [](const auto& e) { return e.kind == EventKind::accumulation; });
  for (const auto& e : report.events) {
    const bool impact = e.kind == EventKind::close || e.kind == EventKind::open;
    if (impact && last != report.events.rend() && e.t <= last->t && e.t >= last->t - shortest_told) continue;
    table.add({run, e.t, std::string(name(e.kind)), std::string(e.contact == 0 ? "body" : "tip")});
  }
}

}  // namespace reproduce
