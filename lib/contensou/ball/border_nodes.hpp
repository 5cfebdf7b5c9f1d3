#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "contensou/ball/bracketed_newton.hpp"

namespace contensou {

/// A point of one half of a smooth border: from the pole to the seam by x = u, the normal (x, 1), or from the
/// equator to the seam by x = w = 1/u, the normal (1, x).
struct BorderNode {
  double x;       ///< 0 to 1
  double across;  ///< the component that grows with x: ξ from the pole, η from the equator
  double along;   ///< the other one
  double second;  ///< d across/dx: f''(u), u³f''(u)
};

/// Nodes on one half of a border, denser towards the seam, where borders are least smooth: from them Newton's
/// iteration starts so near to the root that few steps remain (counted by verify_ball: ball_iterations.tsv).
class BorderNodes {
 public:
  /// `node(x)` gives a BorderNode.
  template <class Function>
  explicit BorderNodes(const Function& node) {
    for (std::size_t i = 0; i <= cells; ++i) {
      const double rest = static_cast<double>(cells - i) / cells;
      nodes_[i] = node(1 - rest * rest);
    }
  }

  const BorderNode& front() const { return nodes_.front(); }
  const BorderNode& back() const { return nodes_.back(); }

  /// A cell of nodes: the left and the right one.
  struct Cell {
    const BorderNode& left;
    const BorderNode& right;
  };
  /// The last cell whose left node is `before` what is looked for, where that is so for all nodes left of
  /// it and for none right of it.
  template <class Predicate>
  Cell cell(const Predicate& before) const {
    // Counting, in two rounds, has no branches to predict.
    std::size_t k = 0;
    for (std::size_t i = stride; i < cells; i += stride)
      k += stride * static_cast<std::size_t>(before(nodes_[i]));
    std::size_t within = 0;
    for (std::size_t i = 1; i < stride; ++i) within += static_cast<std::size_t>(before(nodes_[k + i]));
    return {nodes_[k + within], nodes_[k + within + 1]};
  }
  /// The border at x in [0, 1], by cubics through both ends of the cell with their derivatives.
  BorderNode interpolated(double x) const;

 private:
  static constexpr std::size_t stride = 8;
  static constexpr std::size_t cells = stride * stride;
  std::array<BorderNode, cells + 1> nodes_;
};

inline BorderNode BorderNodes::interpolated(double x) const {
  const double place = static_cast<double>(cells) * (1 - std::sqrt(1 - x));
  const BorderNode* const left = &nodes_[std::min(static_cast<std::size_t>(place), cells - 1)];
  const BorderNode* const right = left + 1;
  const double width = right->x - left->x;
  const double t = (x - left->x) / width;
  // start + t (first + t (second + t third)); in the first cell, start = 0, ξ or η keeps its relative
  // accuracy.
  struct Cubic {
    double start, first, second, third;
    Cubic(double from, double slope_from, double to, double slope_to)
        : start(from),
          first(slope_from),
          second(3 * (to - from) - 2 * slope_from - slope_to),
          third(slope_from + slope_to - 2 * (to - from)) {}
    double at(double s) const { return start + s * (first + s * (second + s * third)); }
    double slope(double s) const { return first + s * (2 * second + 3 * s * third); }
  };
  const double fall = width * left->second;
  const double fall_right = width * right->second;
  const Cubic across(left->across, fall, right->across, fall_right);
  const Cubic along(left->along, -left->x * fall, right->along, -right->x * fall_right);
  return {x, across.at(t), along.at(t), across.slope(t) / width};
}

/// Where a function is zero in a cell, nearly, and minus its derivative there.
struct Start {
  double x;
  double fall;
};

/// From a function's values h and derivatives −fall at both ends of the cell [x, x + width]; h0 > 0 >= h1.
inline Start start_in_cell(double x, double width, double h0, double fall0, double h1, double fall1) {
  const double a = fall0 * width;
  const double b = fall1 * width;
  const double t = inverse_cubic(h0, a, h1, b);
  const double fall = 6 * t * (1 - t) * (h0 - h1) + a * (1 - t * (4 - 3 * t)) + b * t * (3 * t - 2);
  return {x + width * t, fall / width};
}

/// Slopes for Newton's method from values alone: the one given at first, then the secant's.
class SecantSlope {
 public:
  explicit SecantSlope(double fall) : fall_(fall) {}
  /// Minus the derivative at x, where the function is `value`.
  double at(double x, double value) {
    if (known_) fall_ = (value_ - value) / (x - x_);
    known_ = true;
    x_ = x;
    value_ = value;
    return fall_;
  }
  /// The one used last.
  double last() const { return fall_; }

 private:
  double fall_;
  double x_ = 0;
  double value_ = 0;
  bool known_ = false;
};

}  // namespace contensou
