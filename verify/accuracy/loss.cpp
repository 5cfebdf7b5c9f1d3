#include "loss.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "contensou/output/table.hpp"
#include "errors.hpp"
#include "rivals/elliptic.hpp"
#include "rivals/printed.hpp"
#include "series_oracle.hpp"

namespace accuracy {
namespace {

constexpr std::array thresholds{1e-12, 1e-8, 1e-4, 1.0};

/// A difference of large terms. With S the sum of their moduli and q the result,
/// S/q → κ u^power, rounding of the terms leaves a relative error of about κ
/// u^power 2⁻⁵³. power > 0: digits are lost for u → ∞; power < 0: for u → 0.
struct Cancellation {
  const char* pressure;
  const char* method;
  const char* quantity;
  const char* where;
  const rivals::ClosedForm* form;
  double kappa;
  int power;
};

// κ from K, E → π/2, B, D → π/4, arcsin(1/u) → 1/u and the limits of the law: for u → ∞ f → u, ξ → 1,
// η → 1/(2(2+n)u), f″ → 1/(2(2+n)u³); for u → 0 of the uniform law ξ → u, f″ → 1.
// Example (3.18): terms 3u⁴ arcsin(1/u) → 3u³ and 3u²√(u²−1) → 3u³, result (64/3)/(5u): κ u⁴ = 6u³·15u/64.
const std::array cancellations{
    Cancellation{"hertz", "printed", "phi", "LG03 (3.14)", &rivals::printed_hertz, 3.0 / 32, 2},
    Cancellation{"hertz", "printed", "xi", "LG03 (3.17)", &rivals::printed_hertz, 3.0 / 8, 2},
    Cancellation{"hertz", "printed", "eta", "LG03 (3.18)", &rivals::printed_hertz, 45.0 / 32, 4},
    Cancellation{"hertz", "printed", "f2", "d/du LG03 (3.17)", &rivals::printed_hertz, 45.0 / 8, 4},
    Cancellation{"uniform", "textbook_ke_boost", "phi", "textbook K, E", &rivals::textbook_boost, 4.0 / 9, 2},
    Cancellation{"uniform", "textbook_ke_boost", "xi", "textbook K, E", &rivals::textbook_boost, 4.0 / 3, 2},
    Cancellation{"uniform", "textbook_ke_boost", "xi", "textbook K, E", &rivals::textbook_boost, 4.0 / 3, -2},
    Cancellation{"uniform", "textbook_ke_boost", "eta", "textbook K, E", &rivals::textbook_boost, 32.0 / 9,
                 4},
    Cancellation{"uniform", "textbook_ke_boost", "f2", "textbook K, E", &rivals::textbook_boost, 32.0 / 3, 4},
    Cancellation{"uniform", "textbook_ke_boost", "f2", "textbook K, E", &rivals::textbook_boost, 4.0 / 3, -2},
    Cancellation{"uniform", "textbook_ke_boost_promoted", "eta", "textbook K, E",
                 &rivals::textbook_boost_promoted, 32.0 / 9, 4},
    Cancellation{"uniform", "textbook_ke_gsl", "phi", "textbook K, E", &rivals::textbook_gsl, 4.0 / 9, 2},
    Cancellation{"uniform", "textbook_ke_gsl", "xi", "textbook K, E", &rivals::textbook_gsl, 4.0 / 3, 2},
    Cancellation{"uniform", "textbook_ke_gsl", "xi", "textbook K, E", &rivals::textbook_gsl, 4.0 / 3, -2},
    Cancellation{"uniform", "textbook_ke_gsl", "eta", "textbook K, E", &rivals::textbook_gsl, 32.0 / 9, 4},
    Cancellation{"uniform", "textbook_ke_gsl", "f2", "textbook K, E", &rivals::textbook_gsl, 32.0 / 3, 4},
    Cancellation{"uniform", "textbook_ke_gsl", "f2", "textbook K, E", &rivals::textbook_gsl, 4.0 / 3, -2},
    Cancellation{"uniform", "carlson_boost", "eta", "Carlson R_D", &rivals::carlson_boost, 8.0 / 9, 2},
    Cancellation{"uniform", "carlson_boost", "f2", "Carlson R_D", &rivals::carlson_boost, 8.0 / 3, 2},
};

struct Point {
  double u;
  double error;
};

double evaluate(const Cancellation& c, double u) {
  const std::string_view quantity = c.quantity;
  if (quantity == "f2") return c.form->second(u);
  const contensou::Reduced reduced = c.form->at(u);
  return quantity == "phi" ? reduced.phi : quantity == "xi" ? reduced.xi : reduced.eta;
}

const Quad& exact(const Cancellation& c, const ReferenceRow& row) {
  const std::string_view quantity = c.quantity;
  return quantity == "phi" ? row.phi : quantity == "xi" ? row.xi : quantity == "eta" ? row.eta : row.second;
}

void check_oracle(double n, const std::string& pressure, const std::filesystem::path& reference,
                  verify::Record& record) {
  double worst = 0;
  double worst_u = 0;
  for (const ReferenceRow& row : read_reference(reference / "accuracy" / (pressure + ".tsv"))) {
    if (row.u > 0.5 && row.u < 2) continue;
    const ReferenceRow ours = series_oracle(n, row.u);
    for (Quad ReferenceRow::*q :
         {&ReferenceRow::phi, &ReferenceRow::xi, &ReferenceRow::eta, &ReferenceRow::second}) {
      const double error = static_cast<double>(abs((ours.*q - row.*q) / (row.*q)));
      if (!(error <= worst)) {
        worst = error;
        worst_u = row.u;
      }
    }
  }
  // 60 terms, each with a few roundings of 1e-34.
  record.add({.id = "accuracy.oracle." + pressure,
              .where = "reference_data/accuracy",
              .claim = "Gauss's series in 113 bits meets the stored table away from u = 1; relative error, "
                       "obtained: where the worst is",
              .expected = 0,
              .obtained = worst_u,
              .error = worst,
              .bound = 1e-31});
}

/// Relative errors ordered from the seam outwards; the first to pass each threshold.
std::array<std::optional<double>, thresholds.size()> passages(const std::vector<Point>& points) {
  std::array<std::optional<double>, thresholds.size()> found;
  for (std::size_t t = 0; t < thresholds.size(); ++t) {
    const auto it = std::find_if(points.begin(), points.end(),
                                 [&](const Point& p) { return !(p.error <= thresholds[t]); });
    if (it != points.end()) found[t] = it->u;
  }
  return found;
}

std::string short_text(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", x);
  return buffer;
}

}  // namespace

void measure_loss(const std::filesystem::path& reference, const std::filesystem::path& data,
                  verify::Record& record) {
  contensou::Table table{
      {"Where formulas lose their digits in double: u at which the relative error first passes a threshold",
       "scanned from u = 2 out to 1e9 (towards = infinity) and from 1/2 in to 1e-9 (towards = zero), 200 "
       "points a decade; "
       "no row: never passed",
       "predicted: u = (threshold/(kappa 2^-53))^(1/power), from the sum of the moduli of the terms over the "
       "result, "
       "kappa u^power"},
      {"pressure", "method", "quantity", "towards", "threshold", "u", "predicted", "power"},
      {}};
  check_oracle(0, "uniform", reference, record);
  check_oracle(0.5, "hertz", reference, record);
  const std::array<std::vector<ReferenceRow>, 2> uniform{series_scan(0, false), series_scan(0, true)};
  const std::array<std::vector<ReferenceRow>, 2> hertz{series_scan(0.5, false), series_scan(0.5, true)};

  for (const Cancellation& c : cancellations) {
    const bool outwards = c.power > 0;
    const std::string side = outwards ? "infinity" : "zero";
    const std::string id = std::string(c.pressure) + "." + c.method + "." + c.quantity + "." + side;
    std::vector<Point> points;
    for (const ReferenceRow& row : (std::string_view(c.pressure) == "uniform" ? uniform : hertz)[outwards]) {
      points.push_back({row.u, relative_error(evaluate(c, row.u), exact(c, row))});
    }
    const auto found = passages(points);

    double decades = 0;
    double lost_at = std::nan("");
    double lost_predicted = 0;
    std::string measured;
    for (std::size_t t = 0; t < thresholds.size(); ++t) {
      const double predicted = std::pow(thresholds[t] / (c.kappa * 0x1p-53), 1.0 / c.power);
      const double u = found[t].value_or(std::nan(""));
      if (found[t])
        table.add({c.pressure, c.method, c.quantity, side, thresholds[t], u, predicted, double(c.power)});
      const double off = std::abs(c.power * std::log10(u / predicted));
      if (!(off <= decades)) decades = off;
      measured += (t > 0 ? ", " : "") + short_text(u);
      lost_at = u;
      lost_predicted = predicted;
    }
    // The analysis counts the terms, not the roundings in each nor how they happen to add up: a factor 10.
    record.add({.id = "loss." + id,
                .where = c.where,
                .claim = std::string(c.quantity) + " (" + c.method + ", " + c.pressure +
                         ") loses digits like u^" + std::to_string(c.power) +
                         ": its relative error passes 1e-12, 1e-8, 1e-4, 1 at u = " + measured +
                         "; error: decades between measured and predicted relative error, expected, "
                         "obtained: u where all digits are lost",
                .expected = lost_predicted,
                .obtained = lost_at,
                .error = decades,
                .bound = 1});
    if (outwards && std::string_view(c.quantity) != "f2" && c.form != &rivals::carlson_boost) {
      Point worst{};
      for (const Point& p : points) {
        if (p.u <= 1e6 && !(p.error <= worst.error)) worst = p;
      }
      record.add(
          {.id = "loss." + id + ".to_1e6",
           .where = c.where,
           .claim =
               std::string(c.quantity) + " (" + c.method + ", " + c.pressure +
               ") has a relative error of at most 1e-12 for all u up to 1e6; obtained: where the worst is",
           .expected = 0,
           .obtained = worst.u,
           .error = worst.error,
           .bound = 1e-12,
           .should_hold = false});
    }
    std::printf("  %-52s 1e-12, 1e-8, 1e-4, 1 at u = %s (%.2f decades off)\n", id.c_str(), measured.c_str(),
                decades);
  }
  contensou::write_table(table, data / "accuracy_loss.tsv");
}

}  // namespace accuracy
