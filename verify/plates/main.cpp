// The friction plates of LG03 (2.18) and (3.19), printed and corrected, and their series carried on, against
// the exact border. Writes plates.tsv.   verify_plates [--out FOLDER]

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "border.hpp"
#include "common/program.hpp"
#include "contensou/law/hertz.hpp"
#include "contensou/law/uniform.hpp"
#include "contensou/output/table.hpp"
#include "ledger/elimination.hpp"
#include "record.hpp"

namespace verify::plates {
namespace {

using contensou::plate_series;

constexpr int most_terms = 40;

// A vertex of 4000 on a convex border lies on the hull up to
// the rounding of η near the vertical ends: √(1e-16) of slope.
constexpr double flat = 1e-12;

struct Judged {
  int terms;
  Deviation deviation;
  double jump;
  double gap;
};

Judged judge(const PlateSeries& plate, const Border& exact) {
  return {static_cast<int>(plate.inner.size()), largest_deviation(plate, exact), jump(plate),
          hull_gap(plate)};
}

struct Pressure {
  std::string name;
  std::string equation;
  double n;
  PlateSeries printed;
  PlateSeries corrected;  ///< as printed but with the right coefficients and seam
  Border exact;
};

std::vector<Pressure> pressures() {
  const auto border = [](auto law) {
    return [law](double psi) { return law.at(std::sin(psi), std::cos(psi)); };
  };
  return {{"uniform", "(2.18)", 0.0, contensou::printed_uniform_plate(), plate_series(0, 3),
           border(contensou::UniformLaw{})},
          {"hertz", "(3.19)", 0.5, contensou::printed_hertz_plate(), plate_series(0.5, 3),
           border(contensou::HertzLaw{})}};
}

/// The library's coefficients against exact elimination in rational numbers, in ulp of each.
double coefficient_error(const Pressure& pressure, int terms) {
  const auto count = static_cast<std::size_t>(terms) + 1;
  const bool uniform = pressure.name == "uniform";
  const PlateSeries plate = plate_series(pressure.n, terms);
  const auto inner = ledger::plate_inner(uniform ? ledger::uniform_inner(count) : ledger::hertz_inner(count));
  const auto outer = ledger::plate_outer(uniform ? ledger::uniform_outer(count) : ledger::hertz_outer(count));
  double worst = 0;
  const auto compare = [&](double obtained, double expected) {
    const double ulp = std::nextafter(std::abs(expected), 1e300) - std::abs(expected);
    worst = std::max(worst, std::abs(obtained - expected) / ulp);
  };
  double scale = 1;  // Hertz: exact coefficients are those of (ξ/ξ*)²ᵏ
  for (std::size_t k = 0; k + 1 < count; ++k) {
    if (!uniform) scale *= plate.seam * plate.seam;
    compare(plate.inner[k], static_cast<double>(inner[k]) / scale);
    compare(plate.outer[k], static_cast<double>(outer[k]));
  }
  return worst;
}

class Report {
 public:
  void add(const Pressure& pressure, const std::string& method, const Judged& j) {
    table_.add({method, static_cast<double>(j.terms), pressure.name, std::abs(j.deviation.distance),
                j.deviation.xi, j.deviation.u, j.deviation.distance, j.jump,
                std::string(j.gap <= flat ? "yes" : "no"), j.gap, std::string(j.jump <= 0 ? "yes" : "no")});
    if (method == "series" && j.terms > 5 && j.terms % 10 != 0) return;  // the table has them all
    std::printf("%-8s %-9s %2d terms: largest deviation %9.2e at xi = %.4f, jump %9.2e\n",
                pressure.name.c_str(), method.c_str(), j.terms, j.deviation.distance, j.deviation.xi, j.jump);
  }

  const contensou::Table& table() const { return table_; }

 private:
  contensou::Table table_{{"The friction plates of LG03 (2.18) and (3.19) against the exact border; forces "
                           "in units of mu*lambda_N.",
                           "method: printed = coefficients and seam of the paper; corrected = its three "
                           "terms with the right coefficients and "
                           "seam; series = exact elimination "
                           "of u, any number of terms, exact seam.",
                           "max_error: largest distance between the borders along the exact normal; "
                           "where_xi, where_u: there; signed_error > 0: too large.",
                           "jump: eta just outside the seam less eta just inside; hull_gap: how far the "
                           "border lies below its convex hull."},
                          {"method", "terms", "pressure", "max_error", "where_xi", "where_u", "signed_error",
                           "jump", "convex", "hull_gap", "closed"},
                          {}};
};

/// Σ_{k > count} k^{−power} growth^{−k}: what is left of a series whose coefficients behave so.
double tail(int count, double power, double growth) {
  double sum = 0;
  for (int k = 100000; k > count; --k) sum += std::pow(k, -power) * std::pow(growth, -k);
  return sum;
}

void claim_series(const Pressure& pressure, const std::vector<Judged>& series, Record& record) {
  const std::string id = "plates." + pressure.name;
  const std::string where = "LG03 " + pressure.equation;
  int worse = 0;
  for (std::size_t k = 1; k < series.size(); ++k) {
    if (!(std::abs(series[k].deviation.distance) < std::abs(series[k - 1].deviation.distance))) ++worse;
  }
  // Not so: the coefficients change sign about the seventh, and the sum overshoots before it comes back.
  record.add(Claim{id + ".terms", where,
                   "each further term, from 1 to " + std::to_string(most_terms) +
                       ", brings the border nearer to the exact one",
                   0, static_cast<double>(worse), static_cast<double>(worse), 0, false});

  // How fast they come. dη/dξ = −u, so η(ξ) is one order smoother than u(ξ). Uniform: ξ(u) has (1 − u)² log
  // |1 − u|, hence η(ξ) has δ³ log δ at the seam on either side: coefficients k⁻⁴. Hertz: outside δ^{7/2},
  // k^{−9/2}; inside, u = 1 is an ordinary point, but dξ/du = 0 at u² = 4/3 is not far: η(ξ) has δ^{3/2}
  // there and the coefficients go like k^{−5/2} (256/243)^{−k}, which is the slower of the two up to 40
  // terms. Leading behaviour only, so within half a power of the number of terms.
  const bool uniform = pressure.name == "uniform";
  const double power = uniform ? 4.0 : 2.5;
  const double growth = uniform ? 1.0 : 256.0 / 243;
  const double expected = std::log2(tail(20, power, growth) / tail(40, power, growth));
  const double measured = std::log2(std::abs(series[19].deviation.distance / series[39].deviation.distance));
  record.add(
      Claim{id + ".order", where,
            "the largest deviation of the plate falls with this power of the number of terms (20 to 40)",
            expected, measured, std::abs(measured - expected), 0.5, true});

  const double ulps = coefficient_error(pressure, most_terms);
  // Two roundings where the exact fraction is made a double, k
  // multiplications by ξ*² for Hertz: k + 2 ulp at most, k = 40.
  record.add(
      Claim{id + ".coefficients", where,
            "coefficients of the library against exact elimination in rational numbers, 40 terms, in ulp", 0,
            ulps, ulps, pressure.name == "uniform" ? 1.0 : 2.0 * most_terms + 2, true});
}

void claim_printed(const Pressure& pressure, const Judged& printed, const Judged& corrected, Record& record) {
  const std::string id = "plates." + pressure.name;
  const std::string where = "LG03 " + pressure.equation;
  for (const auto& [name, judged] : {std::pair{"printed", printed}, std::pair{"corrected", corrected}}) {
    const std::string reading = std::string(", three terms, ") + name;
    record.add(Claim{id + "." + name + ".convex", where, "the friction plate is a convex set" + reading, 0,
                     judged.gap, judged.gap, flat, false});
    record.add(Claim{id + "." + name + ".closed", where,
                     "the two pieces of the border meet at the seam" + reading, 0, judged.jump,
                     std::abs(judged.jump), flat, false});
  }
  record.add(Claim{id + ".corrected.nearer", where,
                   "the corrected plate is nearer to the exact one than the printed one",
                   std::abs(printed.deviation.distance), std::abs(corrected.deviation.distance),
                   std::abs(corrected.deviation.distance / printed.deviation.distance), 1, true});
}

int run(const std::filesystem::path& folder) {
  Record record("plates");
  Report report;
  for (const Pressure& pressure : pressures()) {
    const Judged printed = judge(pressure.printed, pressure.exact);
    const Judged corrected = judge(pressure.corrected, pressure.exact);
    report.add(pressure, "printed", printed);
    report.add(pressure, "corrected", corrected);
    std::vector<Judged> series;
    for (int terms = 1; terms <= most_terms; ++terms) {
      series.push_back(judge(plate_series(pressure.n, terms), pressure.exact));
      report.add(pressure, "series", series.back());
    }
    claim_printed(pressure, printed, corrected, record);
    claim_series(pressure, series, record);
  }
  contensou::write_table(report.table(), folder / "plates.tsv");
  return record.finish(folder / "parts");
}

}  // namespace
}  // namespace verify::plates

int main(int argc, char** argv) { return reproduce::program_main(argc, argv, verify::plates::run); }
