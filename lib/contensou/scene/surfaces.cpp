#include "contensou/scene/surfaces.hpp"

namespace contensou {
namespace {

using Kind = Surface::Kind;

/// The bodies that have a kind of surface: how many, and the last of them.
struct Carriers {
  std::size_t count = 0;
  std::size_t body = 0;
};

std::size_t pairs(const Carriers& a, const Carriers& b, bool same) {
  if (same) return a.count * (a.count - 1) / 2;
  return a.count == 1 && b.count == 1 && a.body == b.body ? 0 : a.count * b.count;
}

}  // namespace

std::vector<Surface> number_surfaces(BodiesData& data, const std::vector<std::size_t>& balls) {
  std::vector<Surface> surfaces;
  std::size_t first_ball = data.bodies.size();
  for (const std::size_t count : balls) first_ball -= count;
  for (std::size_t i = 0; i < first_ball; ++i) {
    BodyData& body = data.bodies[i];
    for (SphereData& sphere : body.spheres) {
      sphere.surface = surfaces.size();
      surfaces.push_back({sphere.name, body.name, Kind::sphere, i});
    }
    if (body.base) {
      body.base->surface = surfaces.size();
      surfaces.push_back({body.base->name, body.name, Kind::base, i});
    }
  }
  for (const std::size_t count : balls) {
    const std::string ball = data.bodies[first_ball].name;  // "BALLS.1"
    const std::string name = ball.substr(0, ball.rfind('.'));
    for (std::size_t i = first_ball; i < first_ball + count; ++i)
      data.bodies[i].spheres.front().surface = surfaces.size();
    surfaces.push_back({name, name, Kind::balls, first_ball, count});
    first_ball += count;
  }
  for (std::size_t i = 0; i < data.planes.size(); ++i) {
    PlaneData& plane = data.planes[i];
    plane.surface = surfaces.size();
    surfaces.push_back({plane.name, plane.name.substr(0, plane.name.find('.')), Kind::plane, i});
  }
  return surfaces;
}

std::vector<std::size_t> named(const std::vector<Surface>& surfaces, const std::string& name) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (surfaces[i].name == name || surfaces[i].owner == name) indices.push_back(i);
  }
  return indices;
}

std::string owners(const std::vector<Surface>& surfaces) {
  constexpr std::size_t longest = 100;  // of a line that still helps
  std::string names;
  const std::string* last = nullptr;
  for (const Surface& surface : surfaces) {
    if (last != nullptr && surface.owner == *last) continue;
    if (names.size() > longest) return names + " and others";
    names += (last == nullptr ? "" : ", ") + surface.owner;
    last = &surface.owner;
  }
  return names;
}

std::vector<std::size_t> count_pairs(const BodiesData& data, std::size_t rules) {
  std::vector<Carriers> of(static_cast<std::size_t>(data.rule.rows()));
  for (std::size_t i = 0; i < data.bodies.size(); ++i) {
    for (const SphereData& sphere : data.bodies[i].spheres)
      of[sphere.surface] = {of[sphere.surface].count + 1, i};
    if (data.bodies[i].base) of[data.bodies[i].base->surface] = {1, i};
  }
  for (const PlaneData& plane : data.planes) of[plane.surface] = {1, data.bodies.size() + plane.surface};
  std::vector<std::size_t> counts(rules, 0);
  for (Eigen::Index i = 0; i < data.rule.rows(); ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      if (data.rule(i, j) == BodiesData::no_rule) continue;
      counts[static_cast<std::size_t>(data.rule(i, j))] +=
          pairs(of[static_cast<std::size_t>(i)], of[static_cast<std::size_t>(j)], i == j);
    }
  }
  return counts;
}

}  // namespace contensou
