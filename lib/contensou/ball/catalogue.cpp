#include "contensou/ball/catalogue.hpp"

#include <stdexcept>
#include <utility>

#include "contensou/law/catalogue.hpp"
#include "contensou/law/power_limits.hpp"
#include "contensou/text/name.hpp"

namespace contensou {
namespace {

/// Calls `use` with the exact law of the pressure.
template <class Use>
AnyPlate with_exact_law(double n, const Use& use) {
  if (n == 0) return use(UniformLaw{});
  if (n == 0.5) return use(HertzLaw{});
  return use(CompiledLaw(PowerLaw(n)));
}

SeriesPlate printed_plate(double n) {
  return SeriesPlate(n == 0 ? printed_uniform_plate() : printed_hertz_plate());
}

}  // namespace

AnyPlate make_plate(std::string_view pressure, std::string_view model) {
  constexpr int terms_in_print = 3;
  const double n = pressure_exponent(pressure);
  const bool in_print = pressure == "uniform" || pressure == "hertz";
  if (model == "exact") {
    return with_exact_law(n, [](auto law) { return AnyPlate(SmoothPlate(std::move(law))); });
  }
  if (model == "printed" || model == "series") {
    if (in_print) return printed_plate(n);
    if (model == "printed") reject(pressure, "uniform or hertz, for which the paper prints friction plates");
  }
  if (model == "corrected" || model == "series") return SeriesPlate(plate_series(n, terms_in_print));
  if (model == "disk") return DiskPlate{};
  if (model == "ellipsoid" || model == "decoupled") {
    const Extent extent{1.0, power_limits(n).eta_max};
    if (model == "decoupled") return RectanglePlate(extent);
    return SmoothPlate(EllipsoidLaw(extent));
  }
  if (model == "pade" || model == "pade2") {
    throw std::invalid_argument(std::string(model) +
                                ": has no friction ball: its force is not the gradient of a "
                                "potential, so there is no set whose normals it follows");
  }
  std::string_view number;
  if (after("tanh:", model, number)) {
    throw std::invalid_argument(std::string(model) +
                                ": has no friction ball: its force at rest is zero and not a "
                                "set, nothing sticks");
  }
  int count = 0;
  if (after("table:", model, number)) {
    if (!parse(number, count) || count < TabulatedLaw::least_cells || count > TabulatedLaw::most_cells) {
      reject(model, "table:N with a whole N from 4 to 256");
    }
    return with_exact_law(
        n, [count](const auto& law) { return AnyPlate(TabulatedPlate(TabulatedLaw(law, count))); });
  }
  if (after("series:", model, number)) {
    if (!parse(number, count) || count < 1 || count > 40)
      reject(model, "series:K with a whole K from 1 to 40");
    return SeriesPlate(plate_series(n, count));
  }
  reject(model, "exact, table:N, printed, series, series:K, corrected, ellipsoid, decoupled or disk");
}

AnyBall make_ball(std::string_view pressure, std::string_view model) {
  return std::visit([](auto plate) { return AnyBall(FrictionBall(std::move(plate))); },
                    make_plate(pressure, model));
}

std::string ball_model_help() {
  return "exact      the ball itself (default)\n"
         "table:N    the ball by a table of N cells a side, 4 to 256; 16: to about 1e-7 of its size\n"
         "printed    the paper's plate to the letter: (2.18) uniform, (3.19) hertz; not convex\n"
         "series     the same; for power:N its three terms\n"
         "corrected  the paper's three terms with the right coefficients and seam\n"
         "series:K   the same series with K terms, 1 to 40\n"
         "ellipsoid  ellipsoid with the semi-axes of the friction ball\n"
         "decoupled  sliding and drilling friction apart: disk x interval\n"
         "disk       Coulomb's disk: no friction torque\n";
}

}  // namespace contensou
