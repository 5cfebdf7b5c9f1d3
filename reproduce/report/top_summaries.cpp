#include "top_summaries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "html.hpp"
#include "names.hpp"
#include "number.hpp"
#include "selection.hpp"

namespace report {
namespace {

using contensou::Table;

struct Occurrence {
  const char* event;
  const char* contact;
};

// The first one of a run, at or after a time.
std::optional<double> time_of(const Table& table, const std::string& run, const Occurrence& what,
                              double from = 0) {
  const Selection rows =
      Selection(table).where("run", run).where("event", what.event).where("contact", what.contact);
  for (const std::string& t : rows.values("t")) {
    if (const double at = number(t).value_or(NAN); at >= from) return at;
  }
  return std::nullopt;
}

std::string seconds(const std::optional<double>& t) {
  return t ? fmt::format("{:.4f} s", *t) : "not in this time";
}

}  // namespace

// When, for each pressure, beside the paper's times.
std::string top_events_summary(const Table& table) {
  std::string text;
  for (const std::string& run : Selection(table).values("run")) {
    const auto stick = time_of(table, run, {"close", "tip"});
    const auto accumulated = time_of(table, run, {"accumulation", "body"});
    // The top is on its stick from when the body last leaves the floor before it comes back to rock.
    std::optional<double> body;
    for (const std::string& t :
         Selection(table).where("run", run).where("event", "close").where("contact", "body").values("t")) {
      const double at = number(t).value_or(NAN);
      if (!body && stick && at > *stick + 1) body = at;
    }
    text += fmt::format(
        "{}: the stick touches at {}, the body comes back at {}, the impacts of the rocking accumulate at "
        "{}, the stick "
        "leaves at {}. ",
        pressure_name(run), seconds(stick), seconds(body), seconds(accumulated),
        accumulated ? seconds(time_of(table, run, {"open", "tip"}, *accumulated)) : "no time of these");
  }
  return text + "LG03 tells 1.5, 4.55, 4.65 and 5.4 s.";
}

std::string radius_events_summary(const Table& table) {
  std::string text;
  for (const std::string& run : Selection(table).values("run")) {
    text += fmt::format("{}{} m: {}", text.empty() ? "" : "; ", cell(run),
                        seconds(time_of(table, run, {"close", "tip"})));
  }
  return fmt::format("The stick first touches, by contact radius: {}.", text);
}

std::string growth_summary(const Table& table) {
  const Selection rows(table);
  const auto worst = [&](const char* a, const char* b) {
    double largest = 0;
    for (const auto& row : table.rows) {
      const double x = number(row[table.column(a)]).value_or(NAN),
                   y = number(row[table.column(b)]).value_or(NAN);
      if (std::isfinite(x) && std::isfinite(y)) largest = std::max(largest, std::abs(x - y) / std::abs(y));
    }
    return rounded_up(largest, 2);
  };
  return fmt::format(
      "{} rates of growth and decay, each measured in the nonlinear top: without drilling torque they differ "
      "from the "
      "roots of (5.31) by at most {} (relative), with it from the linear rates that take it into account by "
      "at most {}.",
      rows.count(), worst("simulated_531", "rate_531"), worst("simulated", "expected"));
}

std::string magnus_summary(const Table& table) {
  const Selection rows(table);
  return fmt::format(
      "{} points of Figure 11 simulated without drilling torque: at {} the top does what the diagram says. "
      "With the "
      "drilling torque, of which the diagram knows nothing: at {}.",
      rows.count(), rows.where("agrees", "1").count(), rows.where("agrees_drilling", "1").count());
}

}  // namespace report
