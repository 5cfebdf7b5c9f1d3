#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "about_centre.hpp"
#include "about_pole.hpp"
#include "arguments.hpp"
#include "checks.hpp"
#include "comparison.hpp"
#include "contensou/law/radial.hpp"
#include "contensou/output/table.hpp"
#include "value_of.hpp"

namespace verify {
namespace {

struct Case {
  std::string name;
  std::vector<double> rho;
  std::vector<double> sigma;
};

/// Shapes that no power law has: a kink, a hole in the middle, and a measured-looking table.
const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"cone", {0, 1}, {1, 0}},
      {"annulus", {0, 0.4, 0.5, 1}, {0, 0, 1, 1}},
      {"table", {0, 0.2, 0.45, 0.6, 0.8, 0.95, 1}, {1.0, 1.1, 0.7, 0.9, 0.5, 0.2, 0.05}},
  };
  return all;
}

/// What RadialLaw says of itself, for ξ and η.
constexpr double radial_accuracy = 1e-13;
/// It says nothing of f″, whose ring integral has a logarithm at the pole; that quadrature stops at 1e-12.
constexpr double radial_curvature_accuracy = 1e-12;
/// Compiled coarsely, so that the stated bound stands well above the quadrature's own.
constexpr double compiled_tolerances[] = {1e-5, 1e-9};

class Study {
 public:
  explicit Study(const Case& c)
      : pressure_(tabulated(c.name, c.rho, c.sigma)),
        centre_(pressure_),
        pole_(pressure_),
        law_(contensou::tabulated_pressure(c.rho, c.sigma)) {
    for (const double tolerance : compiled_tolerances) {
      compiled_.push_back({tolerance, law_.compile(tolerance), Comparison{}});
    }
  }

  void at(double u, contensou::Table& table) {
    for (const Quantity q : law_quantities) {
      const Estimate about_centre = centre_(q, u);
      const Estimate about_pole = pole_(q, u);
      coordinates_.add(u, about_centre.value, about_pole.value, 2 * quadrature_bound);
      const double ours = value_of(law_, q, u);
      const double accuracy = q == Quantity::curvature ? radial_curvature_accuracy : radial_accuracy;
      law_against_[static_cast<std::size_t>(q)].add(u, about_centre.value, ours, quadrature_bound + accuracy);
      law_against_[static_cast<std::size_t>(q)].add(u, about_pole.value, ours, quadrature_bound + accuracy);
      std::vector<contensou::Table::Cell> row{
          pressure_.name,     std::string(name(q)), u,
          about_centre.value, about_pole.value,     brief(std::abs(ours / about_centre.value - 1))};
      for (Compiled& c : compiled_) {
        const double value = value_of(c.law, q, u);
        row.emplace_back(brief(std::abs(value / about_centre.value - 1)));
        // The stated bound is one on ξ and η against the law that was compiled.
        if (q != Quantity::force && q != Quantity::torque) continue;
        c.against.add(u, about_centre.value, value, c.law.error_bound() + radial_accuracy + quadrature_bound);
      }
      table.add(row);
    }
    load_.add(u, 1, centre_(Quantity::load, u).value, quadrature_bound);
    load_.add(u, 1, pole_(Quantity::load, u).value, quadrature_bound);
  }

  void report(Record& record) const {
    const std::string id = "quadrature." + pressure_.name + ".";
    record.add(coordinates_.claim(
        id + "coordinates", "LG03 (2.2), (3.6)",
        pressure_.name +
            " pressure: phi, xi, eta and f'' integrated about the centre and about the pole agree"));
    record.add(
        load_.claim(id + "load", "LG03 2.1",
                    pressure_.name + " pressure: it integrates to the normal force in both coordinates"));
    for (const Quantity q : law_quantities) {
      record.add(law_against_[static_cast<std::size_t>(q)].claim(
          id + "radial." + name(q), "LG03 (2.1)",
          std::string(name(q)) + ", " + pressure_.name +
              " pressure: RadialLaw agrees with the integral over the disc, in both coordinate systems"));
    }
    for (const Compiled& c : compiled_) {
      record.add(c.against.claim(id + "compiled." + brief(c.tolerance), "compiled.hpp",
                                 pressure_.name + " pressure compiled to " + brief(c.tolerance) +
                                     ": the stated bound " + brief(c.law.error_bound()) + " (" +
                                     std::to_string(c.law.pieces()) + " pieces) covers xi and eta"));
    }
    std::printf("%-10s RadialLaw (phi, xi, eta, f''):", pressure_.name.c_str());
    for (const Quantity q : law_quantities) {
      std::printf(" %s", brief(law_against_[static_cast<std::size_t>(q)].max_error()).c_str());
    }
    for (const Compiled& c : compiled_) {
      std::printf("; compiled %s: %s, stated %s", brief(c.tolerance).c_str(),
                  brief(c.against.max_error()).c_str(), brief(c.law.error_bound()).c_str());
    }
    std::printf("\n");
  }

 private:
  struct Compiled {
    double tolerance;
    contensou::CompiledLaw law;
    Comparison against;
  };

  Pressure pressure_;
  AboutCentre centre_;
  AboutPole pole_;
  contensou::RadialLaw law_;
  std::vector<Compiled> compiled_;
  Comparison coordinates_;
  Comparison load_;
  Comparison law_against_[law_quantities.size()];
};

}  // namespace

int check_radial_steps() { return static_cast<int>(cases().size() * few_slip_ratios().size()); }

void check_radial(Record& record, const std::filesystem::path& folder, Progress& progress) {
  contensou::Table table;
  table.comments = {"Tabulated pressures (linear between the points), R = omega = mu lambda_N = 1, v = u",
                    "centre, pole: the definition LG03 (2.1) integrated in either coordinate system (GSL)",
                    "further columns: |value/centre - 1| of RadialLaw and of its compiled forms",
                    "generated by: verify_quadrature"};
  table.columns = {"pressure", "quantity", "u", "centre", "pole", "radial"};
  for (const double tolerance : compiled_tolerances) table.columns.push_back("compiled_" + brief(tolerance));
  for (const Case& c : cases()) {
    Study study(c);
    for (const double u : few_slip_ratios()) {
      study.at(u, table);
      progress.advance();
    }
    progress.clear();
    study.report(record);
  }
  contensou::write_table(table, folder / "verify_quadrature_radial.tsv");
}

}  // namespace verify
