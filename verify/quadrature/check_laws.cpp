#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "about_centre.hpp"
#include "about_pole.hpp"
#include "arguments.hpp"
#include "checks.hpp"
#include "closed_forms.hpp"
#include "comparison.hpp"
#include "contensou/law/friction_law.hpp"
#include "contensou/law/hertz.hpp"
#include "contensou/law/power.hpp"
#include "contensou/law/series.hpp"
#include "contensou/law/uniform.hpp"
#include "contensou/output/table.hpp"
#include "hypergeometric.hpp"
#include "value_of.hpp"

namespace verify {
namespace {

constexpr double exponents[] = {0, 0.5, -0.5, 1, 2.5};
constexpr int series_terms[] = {2, 4, 8, 20, 100};
/// Stated by PowerLaw for ξ, η and f″; the uniform and the Hertz law promise 4 ulp, far below.
constexpr double law_accuracy = 1e-13;

/// Something to hold against the quadrature: its value, and its
/// own bound on the relative error, both where it has them.
struct Method {
  std::string name;      ///< a column of the table
  std::string where;     ///< where the formula stands
  std::string sentence;  ///< what it is, as the subject of a claim
  std::function<std::optional<Bounded>(Quantity, double u, double result)> at;
  bool loses_digits =
      false;  ///< its own bound grows without limit: say by a claim of its own what that costs
};

template <contensou::FrictionLaw L>
void add_exact(std::vector<Method>& methods, const std::string& column, const std::string& type, L law) {
  auto shared = std::make_shared<const L>(std::move(law));
  methods.push_back({column, "LG03 (2.1), (2.11)", "the library's " + type,
                     [shared](Quantity q, double u, double) -> std::optional<Bounded> {
                       return Bounded{value_of(*shared, q, u), law_accuracy};
                     }});
  // Φ is homogeneous of degree one, so that its other second
  // derivatives follow from f″: −u f″ and u² f″ at s = 1.
  methods.push_back({column + "_vs_ss", "LG03 (2.1)",
                     "the mixed and the spin curvature of the library's " + type,
                     [shared](Quantity q, double u, double result) -> std::optional<Bounded> {
                       if (q != Quantity::curvature) return std::nullopt;
                       const contensou::Curvature c = shared->curvature(u, 1.0);
                       const double mixed = -c.vs / u;
                       const double spin = c.ss / u / u;
                       const bool mixed_is_worse = std::abs(mixed - result) > std::abs(spin - result);
                       return Bounded{mixed_is_worse ? mixed : spin, law_accuracy};
                     }});
}

std::vector<Method> methods_for(double n) {
  using contensou::SeriesLaw;
  std::vector<Method> methods;
  if (n == 0) {
    add_exact(methods, "exact", "UniformLaw", contensou::UniformLaw{});
  } else if (n == 0.5) {
    add_exact(methods, "exact", "HertzLaw", contensou::HertzLaw{});
  }
  add_exact(methods, n == 0 || n == 0.5 ? "power" : "exact", "PowerLaw", contensou::PowerLaw(n));
  add_exact(methods, "power_quadrature", "PowerQuadrature", contensou::PowerQuadrature(n));
  methods.push_back(
      {"hypergeometric", "LG03 (2.1) in Gauss's 2F1", "the hypergeometric form",
       [n](Quantity q, double u, double) -> std::optional<Bounded> { return hypergeometric(q, n, u); }});
  if (n == 0) {
    methods.push_back({"textbook", "LG03 (2.2)", "the textbook form in K and E of GSL",
                       [](Quantity q, double u, double result) -> std::optional<Bounded> {
                         return textbook_uniform(q, u, result);
                       },
                       true});
    methods.push_back({"printed", "LG03 (2.8), (2.13), (2.14)",
                       "the library's PrintedUniformLaw, four terms as printed,",
                       [](Quantity q, double u, double result) -> std::optional<Bounded> {
                         if (q == Quantity::curvature) return std::nullopt;
                         return Bounded{value_of(contensou::PrintedUniformLaw{}, q, u),
                                        truncation_bound(q, 0, u, 4, result)};
                       }});
  }
  if (n == 0.5) {
    methods.push_back({"printed", "LG03 (3.14), (3.17), (3.18)", "the closed form as printed",
                       [](Quantity q, double u, double result) -> std::optional<Bounded> {
                         if (q == Quantity::curvature) return std::nullopt;
                         return printed_hertz(q, u, result);
                       },
                       true});
    methods.push_back(
        {"printed_law", "LG03 (3.17), (3.18)", "the library's PrintedHertzLaw",
         [](Quantity q, double u, double result) -> std::optional<Bounded> {
           if (q != Quantity::force && q != Quantity::torque) return std::nullopt;
           return Bounded{value_of(contensou::PrintedHertzLaw{}, q, u), printed_hertz_bound(q, u, result)};
         }});
  }
  for (const int terms : series_terms) {
    methods.push_back({"series" + std::to_string(terms),
                       n == 0 ? "LG03 (2.8), (2.13), (2.14)" : "LG03 (2.1), Taylor series",
                       "Taylor with " + std::to_string(terms) + " terms of the potential",
                       [law = SeriesLaw(n, terms), n, terms](Quantity q, double u,
                                                             double result) -> std::optional<Bounded> {
                         return Bounded{value_of(law, q, u), truncation_bound(q, n, u, terms, result)};
                       }});
  }
  return methods;
}

/// What one pressure leaves behind: the oracle's own checks and one comparison for each method and quantity.
struct Results {
  Comparison coordinates;  // centre against pole, all quantities
  Comparison load;
  std::map<std::pair<std::string, Quantity>, Comparison> methods;
  std::map<std::pair<std::string, Quantity>, Comparison> to_all_digits;  // of those that lose digits
  double worst_estimate = 0;
};

class Study {
 public:
  explicit Study(double n)
      : n_(n), pressure_(power_pressure(n)), centre_(pressure_), pole_(pressure_), methods_(methods_for(n)) {}

  void at(double u, contensou::Table& table) {
    for (const Quantity q : law_quantities) {
      const Estimate about_centre = centre_(q, u);
      const Estimate about_pole = pole_(q, u);
      // Both carry the quadrature's bound.
      results_.coordinates.add(u, about_centre.value, about_pole.value, 2 * quadrature_bound);
      std::vector<std::optional<Bounded>> values;
      for (const Method& m : methods_) values.push_back(m.at(q, u, about_centre.value));
      compare(q, u, AboutCentre::name, about_centre, values, table);
      compare(q, u, AboutPole::name, about_pole, values, table);
    }
    results_.load.add(u, 1, centre_(Quantity::load, u).value, quadrature_bound);
    results_.load.add(u, 1, pole_(Quantity::load, u).value, quadrature_bound);
  }

  void report(Record& record) const {
    const std::string id = "quadrature." + pressure_.name + ".";
    record.add(results_.coordinates.claim(
        id + "coordinates", "LG03 (2.2), (3.6), (3.7)",
        "phi, xi, eta and f'' integrated about the centre and about the pole (measure |r| dr) agree"));
    record.add(results_.load.claim(id + "load", "LG03 2.1, (3.4)",
                                   "the pressure integrates to the normal force in both coordinate systems"));
    Claim tolerance;
    tolerance.id = id + "tolerance";
    tolerance.where = "verify/quadrature";
    tolerance.claim =
        "GSL's own error estimates stay within what was asked for: relative 1e-12 outer, 1e-13 inner; in "
        "units of that";
    tolerance.expected = 1;
    tolerance.obtained = tolerance.error = std::max(centre_.worst(), pole_.worst());
    tolerance.bound = 1;
    record.add(tolerance);
    for (const Method& m : methods_) {
      for (const Quantity q : law_quantities) {
        const auto found = results_.methods.find({m.name, q});
        if (found == results_.methods.end()) continue;
        if (m.loses_digits) {
          record.add(results_.to_all_digits.at({m.name, q})
                         .claim(id + m.name + "_all_digits." + name(q), m.where,
                                std::string(name(q)) + ", " + pressure_.name + ": " + m.sentence +
                                    " keeps its digits for every u (it does not, for its terms cancel)",
                                false));
        }
        record.add(
            found->second.claim(id + m.name + "." + name(q), m.where,
                                std::string(name(q)) + ", " + pressure_.name + ": " + m.sentence +
                                    " agrees with the integrated definition, in both coordinate systems"));
      }
    }
  }

  void print() const {
    std::printf("%s: largest relative difference to the integrated definition, %d values of u\n  %-24s",
                pressure_.name.c_str(), results_.load.count() / 2, "");
    for (const char* heading : {"phi", "xi", "eta", "f''"}) std::printf(" %-25s", heading);
    std::printf("\n");
    for (const Method& m : methods_) {
      std::printf("  %-24s", m.name.c_str());
      for (const Quantity q : law_quantities) {
        const auto found = results_.methods.find({m.name, q});
        if (found == results_.methods.end()) {
          std::printf(" %-25s", "-");
        } else {
          const std::string cell =
              brief(found->second.max_error()) + " at " + brief_ratio(found->second.max_error_at());
          std::printf(" %-25s", cell.c_str());
        }
      }
      std::printf("\n");
    }
  }

 private:
  void compare(Quantity q, double u, const std::string& coordinates, const Estimate& oracle,
               const std::vector<std::optional<Bounded>>& values, contensou::Table& table) {
    std::vector<contensou::Table::Cell> row{pressure_.name,       coordinates,
                                            std::string(name(q)), u,
                                            oracle.value,         brief(oracle.error / oracle.value)};
    std::map<std::string, std::string> errors;
    for (std::size_t i = 0; i < methods_.size(); ++i) {
      if (!values[i]) continue;
      const std::string& method = methods_[i].name;
      results_.methods[{method, q}].add(u, oracle.value, values[i]->value,
                                        quadrature_bound + values[i]->bound);
      if (methods_[i].loses_digits) {
        results_.to_all_digits[{method, q}].add(u, oracle.value, values[i]->value, quadrature_bound);
      }
      errors[method] = brief(std::abs(values[i]->value / oracle.value - 1));
    }
    for (std::size_t i = row.size(); i < table.columns.size(); ++i) {
      const auto found = errors.find(table.columns[i]);
      row.emplace_back(found == errors.end() ? "nan" : found->second);
    }
    table.add(row);
  }

  double n_;
  Pressure pressure_;
  AboutCentre centre_;
  AboutPole pole_;
  std::vector<Method> methods_;
  Results results_;
};

}  // namespace

int check_laws_steps() { return static_cast<int>(std::size(exponents) * slip_ratios().size()); }

void check_laws(Record& record, const std::filesystem::path& folder, Progress& progress) {
  contensou::Table table;
  table.comments = {
      "The definition LG03 (2.1) integrated over the disc (GSL, nested adaptive quadrature), R = omega = mu "
      "lambda_N = 1, v = u",
      "quantity: phi = Phi/(mu lambda_N |omega| R) = f(u), xi, eta, curvature = f''(u)",
      "coordinates: centre, as in (2.2); pole, as in (3.6) and (3.7) corrected",
      "estimate: relative error of the quadrature as estimated by GSL",
      "further columns: |value/quadrature - 1| of each form of the law; nan where there is none",
      "generated by: verify_quadrature"};
  table.columns = {
      "pressure", "coordinates",      "quantity",       "u",        "quadrature", "estimate", "exact",
      "power",    "power_quadrature", "hypergeometric", "textbook", "printed",    "series2",  "series4",
      "series8",  "series20",         "series100"};
  for (const double n : exponents) {
    Study study(n);
    for (const double u : slip_ratios()) {
      study.at(u, table);
      progress.advance();
    }
    progress.clear();
    study.print();
    study.report(record);
  }
  contensou::write_table(table, folder / "verify_quadrature.tsv");
}

}  // namespace verify
