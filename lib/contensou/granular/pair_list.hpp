#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "contensou/granular/body_motion.hpp"
#include "contensou/granular/cell_grid.hpp"

namespace contensou {

/// A sphere of a body, or its base.
struct Shape {
  std::uint32_t body;
  Eigen::Vector3d centre;  ///< in the body's axes; of a base: zero
  double radius;           ///< of a base: its height, the distance at which it touches
  double size;             ///< what gaps are small against [m]: the radius; of a base its height, or 1 mm
  std::size_t surface;
  bool base;
  std::string name;
};

/// Two surfaces that may come to touch. n points from the second to the first.
struct NearPair {
  std::uint32_t first;   ///< index in PairList::shapes
  std::uint32_t second;  ///< the same; or, from there on, a plane
  std::uint32_t rule;
  Eigen::Vector3d impulse = Eigen::Vector3d::Zero();  ///< of the last step, on the first one [N s]
  double drilling = 0;                                ///< the last step's Λ_τ [N s]
  bool chosen = false;                                ///< takes part in this step's inclusion
  bool exact = true;                                  ///< in this step not to be solved as a point contact

  std::uint64_t key() const { return std::uint64_t{first} << 32U | second; }
};

/// The broad phase: pairs within reach of each other (Verlet's list). Each body has a skin; all pairs whose
/// gap was at most the sum of their skins when the list was made are in it. While no body's way since then
/// and its reach in the step to come exceed its skin, no pair that is left out can touch: the list is exact,
/// and such a pair is not looked at.
class PairList {
 public:
  /// Throws std::invalid_argument for rules that a pair cannot have, in one line.
  explicit PairList(const BodiesData& data);

  bool any_rules() const { return any_rules_; }
  const std::vector<Shape>& shapes() const { return shapes_; }
  std::vector<NearPair>& pairs() { return pairs_; }
  const std::vector<NearPair>& pairs() const { return pairs_; }
  /// The two bodies; for a plane the second is the number of bodies.
  std::pair<std::uint32_t, std::uint32_t> bodies(const NearPair& pair) const {
    const auto still = static_cast<std::uint32_t>(data_.bodies.size());
    return {shapes_[pair.first].body, is_plane(pair) ? still : shapes_[pair.second].body};
  }
  bool is_plane(const NearPair& pair) const { return pair.second >= shapes_.size(); }
  /// "sphere A and plane B", for messages.
  std::string describe(const NearPair& pair) const;
  const PlaneData& plane(const NearPair& pair) const { return data_.planes[pair.second - shapes_.size()]; }

  /// Makes the list anew where `reach` [m] of a body, how far its surfaces may get from `state` on, asks for
  /// it; what pairs that stay have is kept. Returns whether it did.
  bool update(const BodyLayout& layout, const State& state, const std::vector<double>& reach);
  /// Body i moved on: no point of its surfaces by more than `way` [m].
  void moved(std::size_t i, double way) { way_[i] += way; }

 private:
  bool reaches(const std::vector<double>& reach) const;
  void add_planes(std::size_t shape, const Ball& ball);

  const BodiesData& data_;
  std::vector<Shape> shapes_;
  std::vector<double> smallest_radius_;  ///< of each body
  bool any_rules_ = false;
  std::vector<double> skin_, way_;  ///< of each body [m]
  CellGrid grid_;
  std::vector<Ball> balls_;
  std::vector<CellGrid::Pair> found_;
  std::vector<NearPair> pairs_, last_;
};

}  // namespace contensou
