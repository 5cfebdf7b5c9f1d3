#include "contensou/law/catalogue.hpp"

#include "contensou/law/power_limits.hpp"
#include "contensou/text/name.hpp"

namespace contensou {
namespace {

AnyLaw exact_law(double n) {
  if (n == 0) return UniformLaw{};
  if (n == 0.5) return HertzLaw{};
  return PowerLaw(n);
}

AnyLaw printed_law(std::string_view pressure) {
  if (pressure == "uniform") return PrintedUniformLaw{};
  if (pressure == "hertz") return PrintedHertzLaw{};
  reject(pressure, "uniform or hertz, for which the paper prints formulas");
}

}  // namespace

double pressure_exponent(std::string_view pressure) {
  if (pressure == "uniform") return 0.0;
  if (pressure == "hertz") return 0.5;
  std::string_view number;
  if (!after("power:", pressure, number))
    reject(pressure, "uniform, hertz (the paper's parabolic) or power:N");
  double n = 0;
  if (!parse(number, n) || n <= -1) reject(pressure, "power:N with N > -1");
  if (n > PowerQuadrature::largest_n) reject(pressure, "power:N with N <= 1e6");
  return n;
}

AnyLaw make_law(std::string_view pressure, std::string_view model) {
  const double n = pressure_exponent(pressure);
  if (model == "exact") return exact_law(n);
  if (model == "printed") return printed_law(pressure);
  if (model == "series")
    return n == 0 && pressure == "uniform" ? AnyLaw(PrintedUniformLaw{}) : SeriesLaw(n, 4);

  const PowerLimits limits = power_limits(n);
  const Extent extent{1.0, limits.eta_max};
  if (model == "ellipsoid") return EllipsoidLaw(extent);
  if (model == "decoupled") return DecoupledLaw(extent);
  if (model == "pade") return PadeLaw(1, limits.eta_max, limits.slope, limits.tail);
  if (model == "pade2") return PadeLaw(2, limits.eta_max, limits.slope, limits.tail);

  std::string_view number;
  if (after("series:", model, number)) {
    int terms = 0;
    if (!parse(number, terms) || terms < 1 || terms > SeriesLaw::most_terms)
      reject(model, "series:K with a whole K from 1 to 1000");
    return SeriesLaw(n, terms);
  }
  if (after("tanh:", model, number)) {
    double epsilon = 0;
    if (!parse(number, epsilon) || epsilon <= 0) reject(model, "tanh:EPS with EPS > 0 in m/s");
    return TanhLaw(extent, epsilon);
  }
  reject(model, "exact, series, series:K, printed, ellipsoid, decoupled, pade, pade2 or tanh:EPS");
}

std::string pressure_help() {
  return "uniform    constant pressure\n"
         "hertz      sigma ~ sqrt(1 - rho^2/R^2), what the paper calls parabolic\n"
         "power:N    sigma ~ (1 - rho^2/R^2)^N, N > -1\n";
}

std::string model_help() {
  return "exact      the law itself (default)\n"
         "series     the paper's truncated series, four terms; for uniform with the coefficients as printed\n"
         "series:K   the same series with K terms, 1 to 1000\n"
         "printed    the paper's formulas to the letter: (2.13), (2.14) uniform; (3.17), (3.18) hertz\n"
         "ellipsoid  ellipsoid with the semi-axes of the friction ball\n"
         "decoupled  sliding and drilling friction apart: disk x interval\n"
         "pade       Pade form of first order, in the manner of Zhuravlev and Kireenkov\n"
         "pade2      the same of second order\n"
         "tanh:EPS   tanh regularisation with the velocity EPS in m/s\n";
}

}  // namespace contensou
