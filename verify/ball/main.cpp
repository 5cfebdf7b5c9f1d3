// The projection on the friction ball, for every plate of the library: its properties on a million forces
// each, hard ones on purpose. Writes ball.tsv and ball_iterations.tsv.   verify_ball [--out FOLDER]

#include <cstdio>
#include <filesystem>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "accuracy/reference.hpp"
#include "common/program.hpp"
#include "contensou/ball/catalogue.hpp"
#include "contensou/law/catalogue.hpp"
#include "contensou/law/radial.hpp"
#include "contensou/output/table.hpp"
#include "oracle.hpp"
#include "properties.hpp"
#include "record.hpp"
#include "tables.hpp"

namespace verify::ball {
namespace {

using contensou::FrictionBall;
using contensou::SmoothPlate;

constexpr std::uint64_t million = 1000000;

/// In ulp of the scale. Projection: 3 roundings in F, 1 in the unit normal; the point has 1 more when it is
/// turned back into three dimensions. Border: the accuracy the law states. Gauge and projection may disagree
/// where both are within their 4. Two projections, each within 4. Distance and residual are computed of the
/// same numbers. Derivative: some ten roundings of numbers up to 1.
struct Bounds {
  double border = 4;
  double parallel = 4;
  int iterations = 10;
  /// A plate that is not convex is known not to be non-expansive, one with a step upwards not to be
  /// star-shaped.
  bool convex = true;
  /// The derivative takes normals not to point towards the axis; where the printed border for Hertz's
  /// pressure rises beside the seam, they do.
  bool normals_outward = true;

  double of(Property property) const {
    switch (property) {
      case finite:
      case symmetric:
        return 0;
      case Property::border:
        return border;
      case Property::parallel:
        return parallel;
      case distance:
      case residual:
      case idempotent:
        return 4;
      case inside:
      case non_expansive:
        return 8;
      default:
        return 16;
    }
  }
  bool should_hold(Property property) const {
    if (property == homogeneous) return normals_outward;
    return convex || (property != non_expansive && property != inside && property != contracting);
  }
};

class Report {
 public:
  void add(const std::string& law, const Statistics& s, const Bounds& bounds) {
    std::uint64_t count = 0;
    double sum = 0;
    int most = 0;
    for (const auto& [iterations, points] : s.iterations) {
      iterations_.add({law, static_cast<double>(iterations), static_cast<double>(points)});
      count += points;
      sum += static_cast<double>(points) * iterations;
      most = std::max(most, iterations);
    }
    const double mean = count == 0 ? 0 : sum / static_cast<double>(count);
    for (std::size_t i = 0; i < property_count; ++i) {
      if (s.points[i] == 0) continue;
      const auto property = static_cast<Property>(i);
      add(law, property_names[i], s.points[i], s.worst[i], bounds.of(property), bounds.should_hold(property),
          most, mean);
    }
    record_.add(Claim{"ball." + law + ".iterations", "LG03 (4.12)",
                      "border points looked at for one projection are bounded: " + law, 0,
                      static_cast<double>(most), static_cast<double>(most),
                      static_cast<double>(bounds.iterations), true});
    std::printf(
        "%-16s parallel %5.2f border %9.3g idempotent %5.2f non-expansive %9.3g iterations %.2f, at most "
        "%d\n",
        law.c_str(), s.worst[parallel], s.worst[border], s.worst[idempotent], s.worst[non_expansive], mean,
        most);
    std::fflush(stdout);
  }

  void add(const std::string& law, const TableErrors& errors, double bound) {
    add(law, "known_points", errors.known, errors.worst_known, bound, true, 0, 0);
    add(law, "fan", errors.fan, errors.worst_fan, bound, true, 0, 0);
  }

  int finish(const std::filesystem::path& folder) {
    contensou::write_table(table_, folder / "ball.tsv");
    contensou::write_table(iterations_, folder / "ball_iterations.tsv");
    return record_.finish(folder / "parts");
  }

 private:
  void add(const std::string& law, const std::string& property, std::uint64_t points, double worst,
           double bound, bool should_hold, int most, double mean) {
    table_.add({law, property, static_cast<double>(points), worst, bound,
                std::string(should_hold ? "yes" : "no"), static_cast<double>(most), mean});
    record_.add(Claim{"ball." + law + "." + property, "LG03 (4.12)",
                      "projection on the friction ball, " + law + ": " + property + ", in ulp of the scale",
                      0, worst, worst, bound, should_hold});
  }

  Record record_{"ball"};
  contensou::Table table_{
      {"Projection on the friction ball: worst errors over random forces, hard ones on purpose.",
       "Forces and sizes from 1e-12 to 1e12, a tenth of them at the ends of the range of doubles; inside, "
       "near the border, "
       "on the axis, in the plane, next to poles, equator and the seam u = 1.",
       "worst, bound: in ulp of the scale, 2^-52 max(|force|, size) (finite, symmetric: 1 if not so even "
       "once).",
       "parallel: force - point beside the normal; distance, residual: as given, against force - point; "
       "border: point off the border, by formulas of their own in "
       "long double, where they have a say; inside: against the gauge.",
       "known_points: above border points known to 34 digits; fan: against the support in all tabulated "
       "normals."},
      {"law", "property", "points", "worst", "bound", "should_hold", "iterations_max", "iterations_mean"},
      {}};
  contensou::Table iterations_{
      {"Border points looked at for one projection; those in closed form are not counted."},
      {"law", "iterations", "points"},
      {}};
};

template <class Ball>
Statistics measure(const Ball& ball, const Oracle& oracle, std::uint64_t points) {
  Statistics s;
  Sample sample(3);
  std::mt19937_64 mirror(4);
  for (std::uint64_t i = 0; i < points; ++i) judge(ball, sample.next(ball), mirror() % 16, oracle, s);
  return s;
}

Statistics measure(const contensou::AnyBall& ball, const Oracle& oracle, std::uint64_t points = million) {
  return std::visit([&](const auto& b) { return measure(b, oracle, points); }, ball);
}

/// Powers of (1 − ρ²/R²): the exact plate, and tables of it.
void judge_power(const std::string& pressure, const std::string& file, double law_error, int iterations,
                 Report& report) {
  const auto rows =
      accuracy::read_reference(std::filesystem::path(CONTENSOU_REFERENCE_DATA) / "laws" / (file + ".tsv"));
  const auto n = static_cast<Real>(contensou::pressure_exponent(pressure));
  const Oracle oracle = exact_oracle({{n, static_cast<Real>(rows.front().eta), 1}});
  const contensou::AnyBall ball = contensou::make_ball(pressure);
  report.add(pressure, measure(ball, oracle), {.border = law_error, .iterations = iterations});
  const auto border = border_points(rows);
  // The law's error, 4 of the projection, 1 of the rounding of the force.
  report.add(pressure, std::visit([&](const auto& b) { return judge_by_table(b, border); }, ball),
             law_error + 5);
}

void judge_tables(const std::string& pressure, Real n, int cells, Report& report) {
  const std::string model = "table:" + std::to_string(cells);
  const contensou::AnyBall any = contensou::make_ball(pressure, model);
  const auto& ball = std::get<FrictionBall<contensou::TabulatedPlate>>(any);
  const Oracle oracle = exact_oracle({{n, Real(ball.plate().extent().eta), 1}});
  // Off the exact border by what the table says of itself.
  report.add(pressure + " " + model, measure(ball, oracle, million),
             {.border = ball.plate().law().error_bound() * 0x1p52 + 4, .iterations = 60});
}

/// σ ∝ 1 + √(1 − ρ²/R²): 3/5 of the load uniform, 2/5 Hertz.
void judge_radial(Real uniform_eta, Real hertz_eta, Report& report) {
  const contensou::RadialLaw law({[](double rho) { return 1 + std::sqrt((1 - rho) * (1 + rho)); }, {}});
  const Oracle oracle = exact_oracle({{0, uniform_eta, 0.6L}, {0.5L, hertz_eta, 0.4L}});
  constexpr double law_error = 1e-12 * 0x1p52;
  report.add("radial compiled", measure(FrictionBall(SmoothPlate(law.compile(1e-12))), oracle, million),
             {.border = law_error});
  report.add("radial", measure(FrictionBall(SmoothPlate(law)), oracle, 2000), {.border = law_error});
}

int run(const std::filesystem::path& folder) {
  Report report;
  // The laws' own bounds: 4 ulp; 1e-13.
  constexpr double power_error = 1e-13 * 0x1p52;
  judge_power("uniform", "uniform", 4, 10, report);
  judge_power("hertz", "hertz", 4, 10, report);
  // Compiled laws and tables are not smooth at the joints of their pieces: a bisection of a double's 53 bits
  // is the worst.
  for (const char* n : {"-0.9", "-0.5", "1", "5", "1e6"}) {
    judge_power(std::string("power:") + n, std::string("power_") + n, power_error, 60, report);
  }
  const Real uniform_eta = 2.0L / 3;
  const Real hertz_eta = 3 * std::numbers::pi_v<Real> / 16;
  judge_radial(uniform_eta, hertz_eta, report);
  judge_tables("uniform", 0, 16, report);
  judge_tables("hertz", 0.5L, 64, report);
  const double eta = 2.0 / 3;
  report.add("ellipsoid", measure(contensou::make_ball("uniform", "ellipsoid"), ellipsoid_oracle(1, eta)),
             {});
  report.add("disk x interval",
             measure(contensou::make_ball("uniform", "decoupled"), rectangle_oracle(1, eta)), {});
  report.add("disk", measure(contensou::make_ball("uniform", "disk"), rectangle_oracle(1, 0)), {});
  for (const auto& [pressure, series] : {std::pair{"uniform", contensou::printed_uniform_plate()},
                                         std::pair{"hertz", contensou::printed_hertz_plate()}}) {
    report.add(std::string(pressure) + " printed",
               measure(contensou::make_ball(pressure, "printed"), series_oracle(series)),
               {.iterations = 60, .convex = false, .normals_outward = std::string(pressure) != "hertz"});
  }
  return report.finish(folder);
}

}  // namespace
}  // namespace verify::ball

int main(int argc, char** argv) { return reproduce::program_main(argc, argv, verify::ball::run); }
