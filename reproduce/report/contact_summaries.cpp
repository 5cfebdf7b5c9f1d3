#include "contact_summaries.hpp"

#include <fmt/format.h>

#include <cmath>

#include "html.hpp"
#include "names.hpp"
#include "number.hpp"
#include "selection.hpp"

namespace report {

using contensou::Table;

std::string ball_summary(const Table& table) {
  const Selection all(table);
  const auto worst = [&](const char* law, const char* property) {
    return rounded_up(all.where("law", law).where("property", property).largest("worst"), 2);
  };
  const auto points = all.where("law", "uniform").where("property", "non_expansive").first("points");
  return fmt::format(
      "{:.0f} random forces a law, of all sizes and next to every special place: what is left beside the "
      "normal is at most {} ulp of the scale (uniform) and {} (Hertz), the nearest "
      "point "
      "at most {} and {} ulp off the border; at most {} border points are looked at for one projection.",
      points, worst("uniform", "parallel"), worst("hertz", "parallel"), worst("uniform", "border"),
      worst("hertz", "border"), all.largest_there_is("iterations_max"));
}

std::string robustness_summary(const Table& table) {
  const Selection all(table);
  const Selection automatic = all.where("method", "automatic");
  std::string others;
  for (const std::string& method : all.values("method")) {
    if (method == "automatic") continue;
    const Selection rows = all.where("method", method);
    others += fmt::format("; {} leaves {} of {}", method_name(method), rows.first("unsolved"),
                          rows.first("problems"));
  }
  return fmt::format(
      "Of {:.0f} random problems the default solver leaves {} unsolved at 10<sup>−10</sup>, {} of them "
      "because doubles have no better impulses{}. The inclusions "
      "as "
      "written, without a projection, hold to {} in all it solved.",
      automatic.first("problems"), automatic.first("unsolved"), automatic.first("at_rounding"), others,
      rounded_up(automatic.first("worst_inclusion"), 2));
}

std::string consistency_summary(const Table& table) {
  const Selection rows = Selection(table).where("rows", "all");
  const auto worst = [&](const char* check) {
    return rounded_up(rows.where("check", check).first("worst"), 2);
  };
  const auto beyond = [&](const char* check) {
    const Selection row = rows.where("check", check);
    return fmt::format("{} of {}", row.first("beyond"), row.first("problems"));
  };
  return fmt::format(
      "Power that friction creates at a solution: at most {} of its scale; power beside −Φ: {}. Energy "
      "gained "
      "by an impact without restitution: in {} problems; with restitution 0.8 and friction: in {} of one "
      "contact, which is Newton’s impact law, not the solver (Kane and Levinson). Another order of the "
      "contacts "
      "changes velocities beyond their bound in {} problems whose solution is provably unique.",
      worst("created"), worst("potential"), beyond("impact_inelastic"), beyond("impact_friction_one"),
      beyond("order"));
}

std::string siconos_coulomb_summary(const Table& table) {
  const Selection hard = Selection(table).where("family", "hard");
  std::string theirs;
  for (const std::string& solver : hard.where("origin", "siconos").values("solver")) {
    const Selection row = hard.where("origin", "siconos").where("solver", solver);
    theirs += fmt::format("{}{} {}", theirs.empty() ? "" : ", ", escape(solver), row.first("unsolved"));
  }
  const Selection ours = hard.where("origin", "contensou").where("solver", "automatic");
  return fmt::format(
      "Of the hard Coulomb problems ours leaves {} unsolved; Siconos’s solvers, by name (onecontact: of "
      "those with one "
      "contact): {}. In Siconos’s "
      "own "
      "measure our solutions have an error of at most {}.",
      ours.first("unsolved"), theirs, rounded_up(ours.first("siconos_error"), 2));
}

std::string siconos_ball_summary(const Table& table) {
  const Selection rings = Selection(table).where("set", "rings");
  const auto last = rings.values("points").back();
  return fmt::format(
      "The ball of {} points on rings is {} (uniform) and {} (Hertz) from ours, in "
      "<i>μλ<sub>N</sub></i>.",
      last, rounded(rings.where("pressure", "uniform").where("points", last).first("error"), 2),
      rounded(rings.where("pressure", "hertz").where("points", last).first("error"), 2));
}

std::string aims_summary(const Table& table) {
  const auto duration = [](double seconds) {
    return seconds < 1e-4 ? fmt::format("{:.0f} ns", seconds * 1e9) : fmt::format("{:.0f} ms", seconds * 1e3);
  };
  const std::size_t unit = table.column("unit"), aim = table.column("aim"), reached = table.column("reached");
  std::string yes, no;
  for (const auto& row : table.rows) {
    if (row[aim] == "-") continue;
    const double value = number(row[table.column("value")]).value_or(NAN);
    const std::string text = row[unit] == "s" ? duration(value) : rounded(value, 2);
    std::string& list = row[reached] == "yes" ? yes : no;
    list += fmt::format("{}{}: {}", list.empty() ? "" : "; ", escape(row[table.column("quantity")]), text);
  }
  return fmt::format("Aims reached: {}. Not reached: {}.", yes.empty() ? "none" : yes,
                     no.empty() ? "none" : no);
}

}  // namespace report
