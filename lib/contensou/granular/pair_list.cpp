#include "contensou/granular/pair_list.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace contensou {
namespace {

// How much farther than it has to a skin goes: steps of the present reach, and parts of the radius.
constexpr double steps_ahead = 8;
constexpr double least_room = 0.1;
constexpr double most_room = 0.5;
constexpr double least_size = 1e-3;  // of a base [m]

}  // namespace

PairList::PairList(const BodiesData& data) : data_(data) {
  for (std::size_t i = 0; i < data.bodies.size(); ++i) {
    const BodyData& body = data.bodies[i];
    double smallest = std::numeric_limits<double>::infinity();
    for (const SphereData& sphere : body.spheres) {
      shapes_.push_back({static_cast<std::uint32_t>(i), sphere.centre, sphere.radius, sphere.radius,
                         sphere.surface, false, sphere.name});
      smallest = std::min(smallest, sphere.radius);
    }
    if (body.base) {
      const double size = std::max(body.base->height, least_size);
      shapes_.push_back({static_cast<std::uint32_t>(i), Eigen::Vector3d::Zero(), body.base->height, size,
                         body.base->surface, true, body.base->name});
      smallest = std::min(smallest, size);
    }
    smallest_radius_.push_back(smallest);
  }
  any_rules_ = (data.rule != BodiesData::no_rule).any();
  skin_.assign(data.bodies.size(), -1);
  way_.assign(data.bodies.size(), 0);
}

std::string PairList::describe(const NearPair& pair) const {
  const Shape& first = shapes_[pair.first];
  const std::string one = (first.base ? "base " : "sphere ") + first.name;
  return one + " and " +
         (is_plane(pair) ? "plane " + plane(pair).name : "sphere " + shapes_[pair.second].name);
}

bool PairList::reaches(const std::vector<double>& reach) const {
  for (std::size_t i = 0; i < skin_.size(); ++i) {
    if (!(way_[i] + reach[i] <= skin_[i])) return false;
  }
  return true;
}

void PairList::add_planes(std::size_t shape, const Ball& ball) {
  const Shape& s = shapes_[shape];
  for (std::size_t p = 0; p < data_.planes.size(); ++p) {
    const PlaneData& plane = data_.planes[p];
    const int rule =
        data_.rule(static_cast<Eigen::Index>(s.surface), static_cast<Eigen::Index>(plane.surface));
    if (rule == BodiesData::no_rule || plane.normal.dot(ball.centre) - plane.offset > ball.radius) continue;
    pairs_.push_back({static_cast<std::uint32_t>(shape), static_cast<std::uint32_t>(shapes_.size() + p),
                      static_cast<std::uint32_t>(rule)});
  }
}

bool PairList::update(const BodyLayout& layout, const State& state, const std::vector<double>& reach) {
  if (reaches(reach)) return false;
  for (std::size_t i = 0; i < skin_.size(); ++i) {
    const double room =
        std::clamp(steps_ahead * reach[i], least_room * smallest_radius_[i], most_room * smallest_radius_[i]);
    skin_[i] = reach[i] + room;
    way_[i] = 0;
  }
  std::swap(pairs_, last_);
  pairs_.clear();
  balls_.clear();
  for (const Shape& shape : shapes_) {
    const Eigen::Vector3d arm = layout.orientation(shape.body, state.t, state.q) * shape.centre;
    balls_.push_back({layout.position(shape.body, state.q) + arm, shape.radius + skin_[shape.body]});
  }
  grid_.find(balls_, found_);
  for (const auto& [i, j] : found_) {
    const Shape& a = shapes_[i];
    const Shape& b = shapes_[j];
    const int rule = data_.rule(static_cast<Eigen::Index>(a.surface), static_cast<Eigen::Index>(b.surface));
    if (a.body == b.body || a.base || b.base || rule == BodiesData::no_rule) continue;
    pairs_.push_back({i, j, static_cast<std::uint32_t>(rule)});
  }
  for (std::size_t i = 0; i < shapes_.size(); ++i) add_planes(i, balls_[i]);
  std::sort(pairs_.begin(), pairs_.end(),
            [](const NearPair& a, const NearPair& b) { return a.key() < b.key(); });
  auto old = last_.begin();
  for (NearPair& pair : pairs_) {
    while (old != last_.end() && old->key() < pair.key()) ++old;
    if (old == last_.end()) break;
    if (old->key() != pair.key()) continue;
    pair.impulse = old->impulse;
    pair.drilling = old->drilling;
    pair.chosen = old->chosen;
    pair.exact = old->exact;
  }
  return true;
}

}  // namespace contensou
