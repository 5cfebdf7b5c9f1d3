// The broad phase against all pairs one by one.

#include "contensou/granular/cell_grid.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace contensou;

namespace {

std::vector<CellGrid::Pair> brute_force(const std::vector<Ball>& balls) {
  std::vector<CellGrid::Pair> pairs;
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    for (std::uint32_t j = 0; j < i; ++j) {
      const double sum = balls[i].radius + balls[j].radius;
      if ((balls[i].centre - balls[j].centre).squaredNorm() <= sum * sum) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

}  // namespace

TEST_CASE("Cell grid: the same pairs as all against all, each once", "[granular]") {
  std::mt19937_64 g(2003);
  std::uniform_real_distribution<double> unit(-1, 1);
  CellGrid grid;
  std::vector<CellGrid::Pair> pairs;
  // Radii from r to 10^decades r; boxes from crowded to empty, also far from the origin.
  for (const int decades : {0, 1, 4}) {
    for (const double box : {0.05, 0.5, 5.0}) {
      for (const double offset : {0.0, 1e6}) {
        std::vector<Ball> balls;
        for (int i = 0; i < 300; ++i) {
          const Eigen::Vector3d centre(box * unit(g), box * unit(g), box * unit(g));
          balls.push_back({centre.array() + offset, 0.02 * std::pow(10.0, -decades * (unit(g) + 1) / 2)});
        }
        grid.find(balls, pairs);
        std::sort(pairs.begin(), pairs.end());
        CHECK(pairs == brute_force(balls));
      }
    }
  }
}

TEST_CASE("Cell grid: none, one, equal places, sides of cells", "[granular]") {
  CellGrid grid;
  std::vector<CellGrid::Pair> pairs{{1, 0}};
  grid.find({}, pairs);
  CHECK(pairs.empty());
  grid.find({{{0, 0, 0}, 1}}, pairs);
  CHECK(pairs.empty());
  grid.find({{{0, 0, 0}, 0.5}, {{0, 0, 0}, 0.5}, {{1, 0, 0}, 0.5}, {{-1, 0, 0}, 0.5}}, pairs);
  std::sort(pairs.begin(), pairs.end());
  CHECK(pairs == std::vector<CellGrid::Pair>{{1, 0}, {2, 0}, {2, 1}, {3, 0}, {3, 1}});
}
