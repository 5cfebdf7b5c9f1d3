#include "methods.hpp"

#include <cmath>
#include <memory>
#include <numbers>

#include "contensou/law/approximations.hpp"
#include "contensou/law/hertz.hpp"
#include "contensou/law/power.hpp"
#include "contensou/law/radial.hpp"
#include "contensou/law/series.hpp"
#include "contensou/law/uniform.hpp"
#include "contensou/output/table.hpp"
#include "quadrature.hpp"
#include "rivals/elliptic.hpp"
#include "rivals/printed.hpp"

namespace bench {
namespace {

using std::numbers::pi;

/// What the approximations are made from.
struct Pressure {
  std::string name;
  int twice_n;
  double eta_max;  ///< η at u = 0
  double slope;    ///< f″(0)
  double tail;     ///< lim u η for u → ∞
  std::function<double(double)> sigma;

  double n() const { return 0.5 * twice_n; }
};

/// Any law of the library. Shared, because some are large and all are only read.
template <class Law>
auto law(Law law) {
  return [shared = std::make_shared<const Law>(std::move(law))](double u) {
    return contensou::reduced(*shared, u);
  };
}

std::string tolerance_text(double tolerance) { return "tolerance " + contensou::to_text(tolerance); }

void add_quadratures(std::vector<Method>& methods, const Pressure& p) {
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    methods.push_back(scalar_method("quadrature_2d", tolerance_text(tolerance), p.name,
                                    DefinitionQuadrature(p.twice_n, tolerance)));
  }
  for (const double tolerance : {1e-3, 1e-9, 1e-12, 1e-15}) {
    methods.push_back(scalar_method("quadrature_1d_qag", tolerance_text(tolerance), p.name,
                                    ChordAdaptive(p.twice_n, ChordAdaptive::Rule::qag, tolerance)));
    methods.push_back(scalar_method("quadrature_1d_qags", tolerance_text(tolerance), p.name,
                                    ChordAdaptive(p.twice_n, ChordAdaptive::Rule::qags, tolerance)));
  }
  for (const std::size_t points : {2, 4, 8, 16, 32, 64}) {
    methods.push_back(scalar_method("quadrature_1d_gauss", std::to_string(points) + " points", p.name,
                                    ChordGauss(p.twice_n, points)));
  }
  methods.push_back(
      scalar_method("power_quadrature", "library", p.name, law(contensou::PowerQuadrature(p.n()))));
  methods.push_back(
      scalar_method("radial_quadrature", "library", p.name, law(contensou::RadialLaw({p.sigma, {}}))));
}

void add_approximations(std::vector<Method>& methods, const Pressure& p) {
  const contensou::Extent axes{1, p.eta_max};
  for (const int terms : {2, 3, 4, 6, 8, 12, 16, 20}) {
    methods.push_back(scalar_method("taylor", std::to_string(terms) + " terms", p.name,
                                    law(contensou::SeriesLaw(p.n(), terms))));
  }
  methods.push_back(scalar_method("ellipsoid", "same semi-axes", p.name, law(contensou::EllipsoidLaw(axes))));
  methods.push_back(scalar_method("decoupled", "same semi-axes", p.name, law(contensou::DecoupledLaw(axes))));
  for (const int order : {1, 2}) {
    methods.push_back(scalar_method("pade", "order " + std::to_string(order), p.name,
                                    law(contensou::PadeLaw(order, p.eta_max, p.slope, p.tail))));
  }
  for (const double epsilon : {0.01, 0.1}) {
    methods.push_back(scalar_method("tanh", "epsilon " + contensou::to_text(epsilon), p.name,
                                    law(contensou::TanhLaw(axes, epsilon))));
  }
}

void add_compiled(std::vector<Method>& methods, const Pressure& p) {
  const contensou::RadialLaw radial({p.sigma, {}});
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14}) {
    methods.push_back(
        scalar_method("compiled", tolerance_text(tolerance), p.name, law(radial.compile(tolerance))));
  }
}

}  // namespace

std::vector<Method> law_methods() {
  const Pressure uniform{"uniform", 0, 2.0 / 3, 1, 1.0 / 4, [](double) { return 1.0; }};
  const Pressure hertz{"hertz",    1,       3 * pi / 16,
                       3 * pi / 8, 1.0 / 5, [](double rho) { return std::sqrt((1 - rho) * (1 + rho)); }};
  std::vector<Method> methods;
  for (const Pressure& p : {uniform, hertz}) {
    add_quadratures(methods, p);
    add_approximations(methods, p);
    add_compiled(methods, p);
  }
  methods.push_back(
      scalar_method("printed_series", "(2.8), (2.13), (2.14)", "uniform", rivals::printed_uniform.at));
  methods.push_back(
      scalar_method("textbook_ke_boost", "promotion off", "uniform", rivals::textbook_boost.at));
  methods.push_back(
      scalar_method("textbook_ke_boost", "default", "uniform", rivals::textbook_boost_promoted.at));
  methods.push_back(scalar_method("textbook_ke_gsl", "double precision", "uniform", rivals::textbook_gsl.at));
  methods.push_back(scalar_method("carlson_boost", "promotion off", "uniform", rivals::carlson_boost.at));
  methods.push_back(scalar_method("printed", "(3.14), (3.17), (3.18)", "hertz", rivals::printed_hertz.at));
  methods.push_back(scalar_method("exact", "one by one", "uniform", law(contensou::UniformLaw{})));
  methods.push_back(scalar_method("exact", "one by one", "hertz", law(contensou::HertzLaw{})));
  methods.push_back({"exact", "batch", "uniform", contensou::reduced_uniform, {}});
  methods.push_back({"exact", "batch", "hertz", contensou::reduced_hertz, {}});
  return methods;
}

}  // namespace bench
