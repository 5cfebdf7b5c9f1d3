#include <Eigen/Core>
#include <cstdio>
#include <string>
#include <variant>
#include <vector>

#include "checks.hpp"
#include "comparison.hpp"
#include "contensou/law/force.hpp"
#include "contensou/law/hertz.hpp"
#include "contensou/law/power.hpp"
#include "contensou/law/uniform.hpp"
#include "contensou/output/table.hpp"
#include "surface_elements.hpp"

namespace verify {
namespace {

// Every sign of γ_T1, γ_T2 and ω; pole inside, on and outside
// the edge; no spin, no sliding; large and small scales.
constexpr Contact contacts[] = {
    {.mu = 0.3, .lambda_n = 0.06, .radius = 5e-4, .gamma_t1 = 0.01, .gamma_t2 = -0.02, .omega = 180},
    {.mu = 0.3, .lambda_n = 0.06, .radius = 5e-4, .gamma_t1 = -0.04, .gamma_t2 = 0.03, .omega = 100},
    {.mu = 1.2, .lambda_n = 5e3, .radius = 0.2, .gamma_t1 = 0.7, .gamma_t2 = 0.2, .omega = -2.5},
    {.mu = 0.05, .lambda_n = 1e6, .radius = 3, .gamma_t1 = -0.1, .gamma_t2 = -0.9, .omega = -20},
    {.mu = 0.6, .lambda_n = 2, .radius = 1, .gamma_t1 = 0, .gamma_t2 = 1, .omega = 0},
    {.mu = 0.6, .lambda_n = 2, .radius = 0.01, .gamma_t1 = 0, .gamma_t2 = 0, .omega = -7},
    {.mu = 0.8, .lambda_n = 10, .radius = 0.1, .gamma_t1 = 3e-6, .gamma_t2 = 4e-6, .omega = 1e-4},
    {.mu = 0.4, .lambda_n = 1e-3, .radius = 1e-6, .gamma_t1 = -2, .gamma_t2 = 1, .omega = 3e5},
};

/// Ring and radial tolerance are asked relative to μλ_N,
/// the largest force; the ring's enters twice (two halves).
constexpr double force_bound = outer_tolerance + 2 * inner_tolerance + rounding;
/// Φ is at least a third of μλ_N times the fastest slip, which its tolerance is relative to.
constexpr double power_bound = 3 * force_bound;
/// The Hessian's entries are at least a fifth of the unit its tolerance is in, in the norm of the matrix.
constexpr double hessian_bound = 5 * force_bound;
/// As in check_laws.cpp.
constexpr double law_accuracy = 1e-13;

struct Judge {
  Comparison force;
  Comparison power;
  Comparison hessian;

  template <class L>
  void at(const L& law, const Pressure& pressure, const Contact& c, contensou::Table& table) {
    const Eigen::Vector3d gamma(c.gamma_t1, c.gamma_t2, c.omega * c.radius);
    const contensou::Load load{c.mu, c.lambda_n};
    const double slide = gamma.head<2>().norm();
    const double u = slide / std::abs(gamma[2]);
    const Eigen::Vector3d elements = friction_of_elements(c, pressure);
    const auto ours = std::get<contensou::FrictionForce>(contensou::friction_force(law, load, gamma));
    // As vectors: the difference's norm over μλ_N.
    const double size = c.mu * c.lambda_n;
    force.add(u, size, size + (ours - elements).norm(), force_bound + law_accuracy);
    const double dissipated = power_of_elements(c, pressure);
    power.add(u, dissipated, contensou::potential(law, load, gamma), power_bound + law_accuracy);
    const Eigen::Matrix3d elements_hessian = hessian_of_elements(c, pressure);
    const double hessian_size = elements_hessian.norm();
    const Eigen::Matrix3d difference = contensou::hessian(law, load, gamma) - elements_hessian;
    hessian.add(u, hessian_size, hessian_size + difference.norm(), hessian_bound + law_accuracy);
    table.add({pressure.name, c.mu, c.lambda_n, c.radius, c.gamma_t1, c.gamma_t2, c.omega, elements[0],
               elements[1], elements[2], dissipated, (ours - elements).norm() / size,
               difference.norm() / hessian_size});
  }

  void report(Record& record, const std::string& pressure) const {
    const std::string id = "quadrature." + pressure + ".vector.";
    const std::string tail =
        ", " + pressure +
        ": the library agrees with the sum over surface elements, signs, R, mu and lambda_N included";
    record.add(force.claim(id + "force", "LG03 (2.1), (2.11), (2.17), (2.21)",
                           "(lambda_T1, lambda_T2, lambda_tau)" + tail));
    record.add(power.claim(id + "potential", "LG03 (2.1)", "Phi in watts" + tail));
    record.add(hessian.claim(id + "hessian", "LG03 (2.1)", "the Hessian of Phi" + tail));
    std::printf("%-10s vectors: force %s, potential %s, Hessian %s\n", pressure.c_str(),
                brief(force.max_error()).c_str(), brief(power.max_error()).c_str(),
                brief(hessian.max_error()).c_str());
  }
};

template <class L>
void judge(const L& law, double n, Record& record, contensou::Table& table, Progress& progress) {
  const Pressure pressure = power_pressure(n);
  Judge result;
  for (const Contact& c : contacts) {
    result.at(law, pressure, c, table);
    progress.advance();
  }
  progress.clear();
  result.report(record, pressure.name);
}

}  // namespace

int check_forces_steps() { return 3 * static_cast<int>(std::size(contacts)); }

void check_forces(Record& record, const std::filesystem::path& folder, Progress& progress) {
  contensou::Table table;
  table.comments = {
      "Friction of a contact as the sum over its surface elements (GSL), SI units, with signs, LG03 (2.1), "
      "(2.21)",
      "error_force: |lambda_F(library) - lambda_F(elements)|/(mu lambda_N)",
      "error_hessian: Frobenius norm of the difference over that of the Hessian",
      "generated by: verify_quadrature"};
  table.columns = {"pressure",  "mu",          "lambda_n",     "radius",    "gamma_t1",
                   "gamma_t2",  "omega",       "lambda_t1",    "lambda_t2", "lambda_tau",
                   "potential", "error_force", "error_hessian"};
  judge(contensou::UniformLaw{}, 0, record, table, progress);
  judge(contensou::HertzLaw{}, 0.5, record, table, progress);
  judge(contensou::PowerLaw(1), 1, record, table, progress);
  contensou::write_table(table, folder / "verify_quadrature_vectors.tsv");
}

}  // namespace verify
