#include "contensou/law/tabulated.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "contensou/law/slip_ratio.hpp"

namespace contensou {
namespace {

/// Node i of `cells`; graded as the square so that the rounding of 1 − x stays far below a cell's width.
double node(int i, int cells) {
  const double rest = static_cast<double>(cells - i) / cells;
  return 1 - rest * rest;
}

std::size_t cell_of(double x, std::size_t cells) {
  const auto i = static_cast<std::size_t>((1 - std::sqrt(1 - x)) * static_cast<double>(cells));
  return std::min(i, cells - 1);
}

/// The polynomial on [0, 1] that has these values, derivatives and second derivatives at both ends.
std::array<double, 6> hermite(const std::array<double, 3>& at0, const std::array<double, 3>& at1) {
  const double a = at1[0] - at0[0] - at0[1] - at0[2] / 2;
  const double b = at1[1] - at0[1] - at0[2];
  const double c = (at1[2] - at0[2]) / 2;
  return {at0[0], at0[1], at0[2] / 2, 10 * a - 4 * b + c, -15 * a + 7 * b - 2 * c, 6 * a - 3 * b + c};
}

}  // namespace

TabulatedLaw::TabulatedLaw(const std::function<Friction(double, double)>& at,
                           const std::function<Curvature(double, double)>& curvature, Extent extent,
                           int cells)
    : extent_(extent) {
  if (!(cells >= least_cells && cells <= most_cells)) {
    throw std::invalid_argument("tabulated law: " + std::to_string(cells) + " cells, expected 4 to 256");
  }
  const auto tabulate = [&](bool inner) {
    const auto law = [&](double x) { return inner ? at(x, 1) : at(1, x); };
    const auto potential = [&](double x, double width) -> std::array<double, 3> {
      const auto [xi, eta] = law(x);
      const double across = inner ? xi : eta;
      const double second = inner ? curvature(x, 1).vv : curvature(1, x).ss;
      return {(inner ? eta : xi) + x * across, across * width, second * width * width};
    };
    Side side;
    for (int i = 0; i < cells; ++i) {
      const double left = node(i, cells);
      const double right = node(i + 1, cells);
      const double width = right - left;
      side.push_back({left, 1 / width, hermite(potential(left, width), potential(right, width))});
    }
    require_convex(side);
    for (const Cell& cell : side) {
      for (const double t : {0.2, 0.35, 0.5, 0.65, 0.8}) {
        const double x = cell.left + t / cell.inverse_width;
        const auto [xi, eta] = law(x);
        const Pair p = TabulatedLaw::at(side, x);
        error_bound_ = std::max({error_bound_, 2 * std::abs((inner ? xi : eta) - p.across),
                                 2 * std::abs((inner ? eta : xi) - p.along)});
      }
    }
    return side;
  };
  inner_ = tabulate(true);
  outer_ = tabulate(false);
}

void TabulatedLaw::require_convex(const Side& side) const {
  constexpr int samples = 16;
  for (const Cell& cell : side) {
    for (int k = 0; k <= samples; ++k) {
      const double x = cell.left + k / (samples * cell.inverse_width);
      if (!(second(side, x) > 0)) {
        throw std::invalid_argument("tabulated law: " + std::to_string(side.size()) +
                                    " cells are too few, the potential is not convex");
      }
    }
  }
}

TabulatedLaw::Pair TabulatedLaw::at(const Side& side, double x) {
  const Cell& cell = side[cell_of(x, side.size())];
  const double t = (x - cell.left) * cell.inverse_width;
  const auto& c = cell.potential;
  const double potential = c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * c[5]))));
  const double across =
      cell.inverse_width * (c[1] + t * (2 * c[2] + t * (3 * c[3] + t * (4 * c[4] + t * (5 * c[5])))));
  return {across, potential - x * across};
}

double TabulatedLaw::second(const Side& side, double x) {
  const Cell& cell = side[cell_of(x, side.size())];
  const double t = (x - cell.left) * cell.inverse_width;
  const auto& c = cell.potential;
  const double second = 2 * c[2] + t * (6 * c[3] + t * (12 * c[4] + t * (20 * c[5])));
  return cell.inverse_width * cell.inverse_width * second;
}

Friction TabulatedLaw::at(double v, double s) const {
  require_slip(v, s);
  const auto ratio = [](double smaller, double larger) { return std::isinf(larger) ? 0 : smaller / larger; };
  if (v <= s) {
    const Pair p = at(inner_, ratio(v, s));
    return {p.across, p.along};
  }
  const Pair p = at(outer_, ratio(s, v));
  return {p.along, p.across};
}

Curvature TabulatedLaw::curvature(double v, double s) const {
  return curvature_from(
      v, s, [this](SlipRatio u) { return second(inner_, u.x); },
      [this](SlipRatio w) { return second(outer_, w.x); });
}

}  // namespace contensou
