#include "contensou/law/compiled.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>

#include "contensou/text/number.hpp"

namespace contensou {
namespace {

// Second derivatives are wanted for Newton matrices, not for reading off: they may be coarser than ξ and η.
constexpr double second_tolerance_factor = 10;
// What is seen at one point a node is not quite the largest: the bound that is stated is twice what was seen.
constexpr double safety = 2;
// The smallest gap of two different doubles is 2^-53: the piece at a kink (u = 1 always is one) ends below
// it.
constexpr double narrowest = 0x1p-54;
// One kink takes some 2·54 pieces. With more than this for each that is known, and
// some for others, the law is noise at the tolerance asked for; found out in seconds.
constexpr std::size_t pieces_a_break = 120;
constexpr std::size_t spare_pieces = 400;

double evaluate(std::span<const double> coefficients, double t) {
  double value = 0;
  for (std::size_t k = coefficients.size(); k-- > 0;) value = value * t + coefficients[k];
  return value;
}

std::array<double, 3> as_array(const BoundedForm& form) { return {form.force, form.torque, form.second}; }

/// The polynomial through `values` at the Chebyshev points cos((j + ½)π/N) of [−1, 1], as powers of t.
template <std::size_t N>
std::array<double, N> interpolate(const std::array<double, N>& values) {
  using Real = long double;
  const Real pi = std::numbers::pi_v<Real>;
  std::array<Real, N> previous{1};    // T_0 in powers of t
  std::array<Real, N> current{0, 1};  // T_1
  std::array<Real, N> sum{};
  for (std::size_t k = 0; k < N; ++k) {
    Real c = 0;
    for (std::size_t j = 0; j < N; ++j) {
      c += values[j] *
           std::cos(pi * static_cast<Real>(k) * (static_cast<Real>(j) + 0.5L) / static_cast<Real>(N));
    }
    c *= (k == 0 ? 1.0L : 2.0L) / static_cast<Real>(N);
    for (std::size_t i = 0; i < N; ++i) sum[i] += c * previous[i];
    std::array<Real, N> next{};  // T_{k+2} = 2 t T_{k+1} − T_k
    for (std::size_t i = 0; i < N; ++i) next[i] = (i > 0 ? 2 * current[i - 1] : 0) - previous[i];
    previous = current;
    current = next;
  }
  std::array<double, N> result;
  std::transform(sum.begin(), sum.end(), result.begin(), [](Real c) { return static_cast<double>(c); });
  return result;
}

}  // namespace

CompiledLaw::CompiledLaw(const Form& inner, const Form& outer, Extent extent, double tolerance,
                         const std::vector<double>& breaks)
    : extent_(extent) {
  if (!(tolerance >= 4e-16 && tolerance < 1)) {
    throw std::invalid_argument("compiled law: tolerance " + to_text(tolerance) + ", expected 4e-16 to 1");
  }
  std::vector<double> inside;
  std::vector<double> outside;
  for (const double u : breaks) (u < 1 ? inside : outside).push_back(u < 1 ? u : 1 / u);
  inner_ = compile_side(inner, inside, tolerance);
  outer_ = compile_side(outer, outside, tolerance);
}

CompiledLaw::Side CompiledLaw::compile_side(const Form& form, const std::vector<double>& breaks,
                                            double tolerance) {
  std::vector<double> far{0, 0.5};
  std::vector<double> near{0, 0.5};
  for (const double x : breaks) {
    if (x > 0 && x < 1) (x < 0.5 ? far : near).push_back(x < 0.5 ? x : 1 - x);
  }
  return {compile(
              [&](double x) {
                return form({x, 1 - x});
              },
              far, tolerance),
          compile(
              [&](double gap) {
                return form({1 - gap, gap});
              },
              near, tolerance),
          form({1, 0}).second};
}

CompiledLaw::Half CompiledLaw::compile(const std::function<BoundedForm(double)>& form,
                                       std::vector<double> breaks, double tolerance) {
  std::sort(breaks.begin(), breaks.end());
  const std::size_t most_pieces = spare_pieces + pieces_a_break * breaks.size();
  const auto numbers_at = [&](double position) {
    const std::array<double, 3> values = as_array(form(position));
    for (const double value : values) {
      if (!std::isfinite(value)) throw std::runtime_error("compiled law: the law gives " + to_text(value));
    }
    return values;
  };
  Half half;
  const auto add = [&](auto& self, double a, double b) -> void {
    Piece piece{(a + b) / 2, 2 / (b - a), {}};
    std::array<std::array<double, terms>, 3> values;
    for (std::size_t j = 0; j < terms; ++j) {
      const double node = std::cos(std::numbers::pi * (static_cast<double>(j) + 0.5) / terms);
      const auto at_node = numbers_at(std::clamp(piece.center + node * (b - a) / 2, a, b));
      for (std::size_t q = 0; q < 3; ++q) values[q][j] = at_node[q];
    }
    for (std::size_t q = 0; q < 3; ++q) piece.coefficients[q] = interpolate(values[q]);

    // Between the nodes, where the interpolation error of a smooth function is largest, and at both ends.
    std::array<double, 3> error{};
    for (int j = 0; j <= terms; ++j) {
      const double position =
          std::clamp(piece.center - std::cos(std::numbers::pi * j / terms) * (b - a) / 2, a, b);
      const auto exact = numbers_at(position);
      for (std::size_t q = 0; q < 3; ++q) {
        const double value =
            evaluate(piece.coefficients[q], (position - piece.center) * piece.inverse_half_width);
        if (value != exact[q]) error[q] = std::max(error[q], std::abs(value - exact[q]) / std::abs(exact[q]));
      }
    }
    const bool good = safety * std::max(error[0], error[1]) <= tolerance &&
                      safety * error[2] <= second_tolerance_factor * tolerance;
    if (good || b - a <= narrowest) {
      error_bound_ = std::max({error_bound_, safety * error[0], safety * error[1]});
      half.left.push_back(a);
      half.pieces.push_back(piece);
      if (half.pieces.size() > most_pieces) {
        throw std::runtime_error("compiled law: tolerance " + to_text(tolerance) +
                                 " is below the law's noise");
      }
    } else {
      self(self, a, piece.center);
      self(self, piece.center, b);
    }
  };
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    if (breaks[i] < breaks[i + 1]) add(add, breaks[i], breaks[i + 1]);
  }
  return half;
}

std::size_t CompiledLaw::pieces() const {
  return inner_.far.pieces.size() + inner_.near.pieces.size() + outer_.far.pieces.size() +
         outer_.near.pieces.size();
}

std::pair<const CompiledLaw::Piece&, double> CompiledLaw::Side::find(SlipRatio ratio) const {
  const bool is_far = ratio.x < 0.5;
  const double position = is_far ? ratio.x : ratio.gap;
  const Half& half = is_far ? far : near;
  const auto after = std::upper_bound(half.left.begin(), half.left.end(), position);
  const Piece& piece = half.pieces[static_cast<std::size_t>(after - half.left.begin()) - 1];
  return {piece, (position - piece.center) * piece.inverse_half_width};
}

BoundedForm CompiledLaw::Side::at(SlipRatio ratio) const {
  const auto [piece, t] = find(ratio);
  return {evaluate(piece.coefficients[0], t), evaluate(piece.coefficients[1], t), 0};
}

double CompiledLaw::Side::second(SlipRatio ratio) const {
  if (ratio.gap == 0) return second_at_seam;
  const auto [piece, t] = find(ratio);
  return evaluate(piece.coefficients[2], t);
}

Friction CompiledLaw::at(double v, double s) const {
  const Friction friction = friction_from(
      v, s, [this](SlipRatio u) { return inner_.at(u); }, [this](SlipRatio w) { return outer_.at(w); });
  return {std::min(friction.xi, extent_.xi), std::min(friction.eta, extent_.eta)};
}

Curvature CompiledLaw::curvature(double v, double s) const {
  return curvature_from(
      v, s, [this](SlipRatio u) { return inner_.second(u); },
      [this](SlipRatio w) { return outer_.second(w); });
}

}  // namespace contensou
