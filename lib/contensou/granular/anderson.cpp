#include "contensou/granular/anderson.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace contensou {
namespace {

/// Changes that are nearly multiples of each other leave the Gram matrix singular to rounding.
constexpr double regular = 1e-12;
/// f this much longer than in the step before: what was taken for affine is not.
constexpr double too_long = 2;

}  // namespace

void Anderson::restart(Eigen::Index n) {
  n_ = n;
  count_ = 0;
  next_ = 0;
  first_ = true;
  size_ = std::numeric_limits<double>::infinity();
  if (f_.size() >= n) return;
  changes_f_.resize(n, depth);
  changes_g_.resize(n, depth);
  f_.resize(n);
  last_f_.resize(n);
  last_g_.resize(n);
}

void Anderson::step(const Eigen::VectorXd& g, Eigen::VectorXd& x) {
  f_.head(n_) = g.head(n_) - x.head(n_);
  const double size = f_.head(n_).norm();
  if (!(size <= too_long * size_)) restart(n_);
  size_ = size;
  if (!first_) {
    changes_f_.col(next_).head(n_) = f_.head(n_) - last_f_.head(n_);
    changes_g_.col(next_).head(n_) = g.head(n_) - last_g_.head(n_);
    count_ = std::min(count_ + 1, depth);
    for (int i = 0; i < count_; ++i) {
      gram_(i, next_) = changes_f_.col(i).head(n_).dot(changes_f_.col(next_).head(n_));
      gram_(next_, i) = gram_(i, next_);
    }
    next_ = (next_ + 1) % depth;
  }
  first_ = false;
  last_f_.head(n_) = f_.head(n_);
  last_g_.head(n_) = g.head(n_);
  x.head(n_) = g.head(n_);
  if (count_ == 0) return;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, depth, depth> a =
      gram_.topLeftCorner(count_, count_);
  a.diagonal().array() *= 1 + regular;
  a.diagonal().array() += std::numeric_limits<double>::min();
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, depth, 1> part(count_);
  for (int i = 0; i < count_; ++i) part[i] = changes_f_.col(i).head(n_).dot(f_.head(n_));
  part = a.partialPivLu().solve(part).eval();
  if (!part.allFinite()) return;
  for (int i = 0; i < count_; ++i) x.head(n_) -= part[i] * changes_g_.col(i).head(n_);
}

}  // namespace contensou
