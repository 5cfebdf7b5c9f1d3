#include "summaries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "contact_summaries.hpp"
#include "html.hpp"
#include "names.hpp"
#include "number.hpp"
#include "selection.hpp"
#include "top_summaries.hpp"

namespace report {
namespace {

using contensou::Table;

std::string joined(const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "" : ", ") + item;
  return text;
}

// "1.2·10⁻¹⁵ (Φ), 2.1·10⁻¹⁵ (ξ)": the largest of `column` for each quantity, rounded up.
std::string by_quantity(const Selection& rows, std::string_view column, int digits) {
  std::vector<std::string> items;
  for (const std::string& quantity : rows.values("quantity")) {
    items.push_back(fmt::format("{} ({})",
                                rounded_up(rows.where("quantity", quantity).largest(column), digits),
                                quantity_name(quantity)));
  }
  return joined(items);
}

std::string accuracy(const Table& table) {
  const Selection all(table);
  std::string text;
  for (const std::string& pressure : all.values("pressure")) {
    const Selection rows = all.where("pressure", pressure);
    text += fmt::format("{}, exact: at most {} ulp; in batches: {}. ", pressure_name(pressure),
                        by_quantity(rows.where("method", "exact"), "max_ulp", 3),
                        by_quantity(rows.where("method", "exact_batch"), "max_ulp", 3));
  }
  return text;
}

std::string accuracy_loss(const Table& table) {
  const Selection rows(table);
  double factor = 1;
  for (const auto& row : table.rows) {
    const double u = number(row[table.column("u")]).value_or(NAN);
    const double predicted = number(row[table.column("predicted")]).value_or(NAN);
    factor = std::max({factor, u / predicted, predicted / u});
  }
  return fmt::format(
      "{} losses of digits by cancellation, each within a factor {} of the <i>u</i> that rounding analysis "
      "predicts.",
      rows.count(), rounded_up(factor, 2));
}

std::string accuracy_power(const Table& table) {
  const Selection rows(table);
  return fmt::format("Pressure ∝ (1 − ρ²/R²)<sup>n</sup>, {} exponents: relative errors of at most {}.",
                     rows.values("n").size(), by_quantity(rows, "max", 2));
}

std::string quadrature(const Table& table) {
  const Selection rows(table);
  return fmt::format(
      "{} integrals, whose own error estimates are at most {}: the exact laws differ by at most {}, the "
      "general "
      "power law by {} (relative). As printed, Hertz differs by up to {}.",
      rows.count(), rounded_up(rows.largest("estimate"), 2), rounded_up(rows.largest_there_is("exact"), 2),
      rounded_up(rows.largest_there_is("power"), 2),
      rounded(rows.where("pressure", "hertz").largest_there_is("printed"), 2));
}

std::string quadrature_radial(const Table& table) {
  const Selection rows(table);
  std::string text =
      fmt::format("{} integrals over {} tabulated pressures: the law for any pressure differs by at most {}",
                  rows.count(), rows.values("pressure").size(), rounded_up(rows.largest("radial"), 2));
  // Compiling bounds the errors of ξ and η; curvature, its derivative, is in the table, too.
  for (const std::string& column : table.columns) {
    if (constexpr std::string_view prefix = "compiled_"; column.starts_with(prefix)) {
      const double xi = rows.where("quantity", "xi").largest(column);
      const double eta = rows.where("quantity", "eta").largest(column);
      text += fmt::format(", compiled to {} by {} in <i>ξ</i>, {} in <i>η</i>",
                          cell(column.substr(prefix.size())), rounded_up(xi, 2), rounded_up(eta, 2));
    }
  }
  return text + " (relative).";
}

std::string quadrature_vectors(const Table& table) {
  const Selection rows(table);
  return fmt::format(
      "{} contacts with signs and units: force and torque differ from the sum over the surface by at most {} "
      "of "
      "<i>μλ<sub>N</sub></i>, Hessians by {}.",
      rows.count(), rounded_up(rows.largest("error_force"), 2), rounded_up(rows.largest("error_hessian"), 2));
}

std::string plates(const Table& table) {
  const Selection all(table);
  std::string text = "Largest distance from the exact border, in <i>μλ<sub>N</sub></i>. ";
  for (const std::string& pressure : all.values("pressure")) {
    const Selection rows = all.where("pressure", pressure);
    const Selection series = rows.where("method", "series");
    const auto all_terms = series.values("terms");
    const std::string terms = all_terms.empty() ? "" : all_terms.back();
    text += fmt::format("{}: {} as printed, {} corrected, {} with {} terms. ", pressure_name(pressure),
                        rounded(rows.where("method", "printed").first("max_error"), 2),
                        rounded(rows.where("method", "corrected").first("max_error"), 2),
                        rounded(series.where("terms", terms).first("max_error"), 2), terms);
  }
  return text;
}

std::string nanoseconds(double seconds) { return fmt::format("{:.3g} ns", seconds * 1e9); }

std::string cost_laws(const Table& table) {
  const Selection all(table);
  std::string text;
  for (const std::string& pressure : all.values("pressure")) {
    const Selection exact = all.where("pressure", pressure).where("method", "exact");
    const Selection one = exact.where("setting", "one by one"), batch = exact.where("setting", "batch");
    text += fmt::format("{}, exact: {} for Φ, <i>ξ</i> and <i>η</i>, {} in batches, errors of at most {}. ",
                        pressure_name(pressure), nanoseconds(one.first("seconds")),
                        nanoseconds(batch.first("seconds")), rounded_up(exact.largest("error"), 2));
  }
  return text;
}

std::string cost_front(const Table& table) {
  const Selection all(table);
  std::string text;
  for (const std::string& pressure : all.values("pressure")) {
    const Selection rows = all.where("pressure", pressure).where("among", "all");
    std::vector<std::string> methods;
    for (const std::string& method : rows.values("method")) {
      methods.push_back(method_name(method) + ", " + escape(rows.where("method", method).text("setting")));
    }
    text += fmt::format("{}: no method is both faster and more accurate than {}. ", pressure_name(pressure),
                        joined(methods));
  }
  return text;
}

std::string cost_ratios(const Table& table) {
  const Selection all(table);
  const auto ratio = [&](const char* name) { return rounded(all.where("ratio", name).first("value"), 2); };
  return fmt::format(
      "Batches are {} (uniform) and {} (Hertz) times faster than one by one. One by one, all three "
      "quantities "
      "together take {} (uniform) and {} (Hertz) of the time of one K and one E.",
      ratio("uniform, one by one / batch"), ratio("hertz, one by one / batch"),
      ratio("uniform / (K + E), throughput"), ratio("hertz / (K + E), throughput"));
}

std::string scenes(const Table& table) {
  int held = 0;
  double largest = 0;
  const auto errors = table.numbers("error"), bounds = table.numbers("bound");
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (errors[i] <= bounds[i]) ++held;
    if (bounds[i] > 0) largest = std::max(largest, errors[i] / bounds[i]);
  }
  return fmt::format(
      "{} numbers of {} scenes beside their answers: {} within their bounds, the largest error {} of its "
      "bound.",
      errors.size(), Selection(table).values("scene").size(), held, rounded_up(largest, 2));
}

// "107 sentences: holds 77, misprint 6."
std::string verdicts(const Table& table, const char* what) {
  const Selection rows(table);
  std::vector<std::string> counts;
  for (const std::string& verdict : rows.values("verdict")) {
    counts.push_back(fmt::format("{} {}", escape(verdict), rows.where("verdict", verdict).count()));
  }
  return fmt::format("{} {}: {}.", rows.count(), what, joined(counts));
}

std::string claims(const Table& table) { return verdicts(table, "claims"); }
std::string integrator_orders(const Table& table) { return verdicts(table, "errors of seven schemes"); }
std::string ledger(const Table& table) { return verdicts(table, "equations and sentences"); }

}  // namespace

std::string summary(const std::string& name, const Table& table) {
  static const std::map<std::string, std::string (*)(const Table&)> sentences{
      {"accuracy", accuracy},
      {"accuracy_loss", accuracy_loss},
      {"accuracy_power", accuracy_power},
      {"verify_quadrature", quadrature},
      {"verify_quadrature_radial", quadrature_radial},
      {"verify_quadrature_vectors", quadrature_vectors},
      {"plates", plates},
      {"cost_laws", cost_laws},
      {"cost_laws_front", cost_front},
      {"cost_ratios", cost_ratios},
      {"cost_projection_aims", aims_summary},
      {"cost_solver_ratios", aims_summary},
      {"cost_integrators_aims", aims_summary},
      {"ball", ball_summary},
      {"robustness", robustness_summary},
      {"consistency", consistency_summary},
      {"siconos_coulomb", siconos_coulomb_summary},
      {"siconos_ball", siconos_ball_summary},
      {"integrator_orders", integrator_orders},
      {"fig09_events", top_events_summary},
      {"fig12_events", radius_events_summary},
      {"stability_growth", growth_summary},
      {"fig11_simulated", magnus_summary},
      {"scenes", scenes},
      {"claims", claims},
      {"ledger", ledger}};
  const auto sentence = sentences.find(name);
  return sentence == sentences.end() || table.rows.empty() ? "" : sentence->second(table);
}

}  // namespace report
