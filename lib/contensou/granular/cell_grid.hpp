#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace contensou {

/// A sphere with room about it, for the broad phase.
struct Ball {
  Eigen::Vector3d centre;
  double radius = 0;  ///< [m] > 0
};

/// Finds all pairs of balls that overlap, in time O(balls + pairs) while balls of one size do not overlap by
/// more than a bounded number each: cells of side 2^k, one grid for each size class (2^{k−1} < 2r <= 2^k), a
/// ball in one cell of its class, kept in a hash table. A ball looks in the 2 or 3 cells a side of its own
/// class and of each coarser one it can reach, so sizes that differ by many orders cost a class more, not a
/// factor.
class CellGrid {
 public:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  /// Writes the pairs (i, j), i > j, with |c_i − c_j| <= r_i + r_j, each once, in an order that depends on
  /// the balls alone. Centres finite. Allocates only where there are more balls or pairs than ever.
  void find(const std::vector<Ball>& balls, std::vector<Pair>& pairs);

 private:
  struct Cell {
    std::int64_t x, y, z;
    int size;  ///< k
    bool operator==(const Cell&) const = default;
  };

  std::size_t slot(const Cell& cell) const;
  void enter(const std::vector<Ball>& balls);
  void look(const std::vector<Ball>& balls, std::uint32_t i, int size, std::vector<Pair>& pairs) const;

  std::vector<Cell> cell_;            ///< of each ball
  std::vector<std::uint32_t> first_;  ///< of a slot: the last ball entered; none: none_
  std::vector<std::uint32_t> next_;   ///< of a ball: the one entered before into its slot
  std::vector<int> sizes_;            ///< that occur, ascending
};

}  // namespace contensou
