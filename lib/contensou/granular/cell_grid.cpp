#include "contensou/granular/cell_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace contensou {
namespace {

constexpr std::uint32_t none = 0xffffffff;

/// k with 2^{k−1} < 2r <= 2^k.
int size_class(double radius) {
  int exponent = 0;
  const double fraction = std::frexp(2 * radius, &exponent);
  return fraction == 0.5 ? exponent - 1 : exponent;
}

/// The cell along one axis; far from the origin, where doubles are farther apart than cells, the last one.
std::int64_t index(double x, int size) {
  constexpr double farthest = 0x1p62;
  return static_cast<std::int64_t>(std::clamp(std::floor(std::ldexp(x, -size)), -farthest, farthest));
}

}  // namespace

std::size_t CellGrid::slot(const Cell& cell) const {
  std::uint64_t h = static_cast<std::uint64_t>(cell.size) * 0x9e3779b97f4a7c15U;
  for (const std::int64_t k : {cell.x, cell.y, cell.z}) {
    h = (h ^ static_cast<std::uint64_t>(k)) * 0xff51afd7ed558ccdU;
    h ^= h >> 32U;
  }
  return h & (first_.size() - 1);
}

void CellGrid::enter(const std::vector<Ball>& balls) {
  first_.assign(std::bit_ceil(2 * balls.size() + 1), none);
  next_.resize(balls.size());
  cell_.resize(balls.size());
  sizes_.clear();
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Eigen::Vector3d& c = balls[i].centre;
    const int size = size_class(balls[i].radius);
    cell_[i] = {index(c[0], size), index(c[1], size), index(c[2], size), size};
    const auto place = std::lower_bound(sizes_.begin(), sizes_.end(), size);
    if (place == sizes_.end() || *place != size) sizes_.insert(place, size);
  }
  for (std::size_t i = 0; i < balls.size(); ++i) {
    std::uint32_t& first = first_[slot(cell_[i])];
    next_[i] = first;
    first = static_cast<std::uint32_t>(i);
  }
}

void CellGrid::look(const std::vector<Ball>& balls, std::uint32_t i, int size,
                    std::vector<Pair>& pairs) const {
  const Ball& ball = balls[i];
  const double reach = ball.radius + std::ldexp(0.5, size);  // no ball of this class is larger
  std::int64_t low[3], high[3];
  for (int k = 0; k < 3; ++k) {
    low[k] = index(ball.centre[k] - reach, size);
    high[k] = index(ball.centre[k] + reach, size);
  }
  for (std::int64_t x = low[0]; x <= high[0]; ++x) {
    for (std::int64_t y = low[1]; y <= high[1]; ++y) {
      for (std::int64_t z = low[2]; z <= high[2]; ++z) {
        const Cell cell{x, y, z, size};
        for (std::uint32_t j = first_[slot(cell)]; j != none; j = next_[j]) {
          if (!(cell_[j] == cell) || (size == cell_[i].size && j >= i)) continue;
          const double sum = ball.radius + balls[j].radius;
          if ((ball.centre - balls[j].centre).squaredNorm() > sum * sum) continue;
          pairs.emplace_back(std::max(i, j), std::min(i, j));
        }
      }
    }
  }
}

void CellGrid::find(const std::vector<Ball>& balls, std::vector<Pair>& pairs) {
  pairs.clear();
  if (balls.size() < 2) return;
  enter(balls);
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    for (auto size = std::lower_bound(sizes_.begin(), sizes_.end(), cell_[i].size); size != sizes_.end();
         ++size)
      look(balls, i, *size, pairs);
  }
}

}  // namespace contensou
