#include "contensou/scene/start.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "contensou/text/number.hpp"

namespace contensou {
namespace {

using Eigen::Vector3d;
using Kind = Surface::Kind;

/// Of lengths and coordinates: gaps this deep are rounding, as for the integrators.
constexpr double rounding = 1e-12;

/// A sphere in space; of a base the point that is lowest, with radius 0.
struct Ball {
  Vector3d centre;
  double radius;
  std::size_t body = 0;
  const std::string* name = nullptr;

  double scale() const { return std::max(radius, centre.lpNorm<Eigen::Infinity>()); }
};

/// All balls with one kind of surface, and the box that their centres are in.
struct Group {
  std::vector<Ball> balls;
  Eigen::AlignedBox3d box;
  double radius = 0;

  void add(const Ball& ball) {
    balls.push_back(ball);
    box.extend(ball.centre);
    radius = std::max(radius, ball.radius);
  }
};

Ball ball(const BodyData& body, std::size_t index, const SphereData& sphere) {
  return {body.position + body.orientation * sphere.centre, sphere.radius, index, &sphere.name};
}

Ball foot(const BodyData& body, std::size_t index) {
  return {body.position - body.base->height * (body.orientation * Vector3d::UnitZ()), 0, index,
          &body.base->name};
}

double gap(const Ball& ball, const PlaneData& plane) {
  return plane.normal.dot(ball.centre) - (plane.offset + ball.radius);
}

double gap(const Ball& a, const Ball& b) {
  return (a.centre - b.centre).stableNorm() - (a.radius + b.radius);
}

/// Whether there is a rule for the two surfaces: the laws themselves are not made yet.
bool meet(const BodiesData& data, std::size_t a, std::size_t b) {
  return data.rule(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) != BodiesData::no_rule;
}

std::vector<Group> group(const std::vector<Surface>& surfaces, const BodiesData& data) {
  std::vector<Group> groups(surfaces.size());
  for (std::size_t i = 0; i < data.bodies.size(); ++i) {
    const BodyData& body = data.bodies[i];
    for (const SphereData& sphere : body.spheres) groups[sphere.surface].add(ball(body, i, sphere));
    if (body.base) groups[body.base->surface].add(foot(body, i));
  }
  return groups;
}

/// The balls of a group by cells of a lattice, sorted: those near a point are found without looking at all.
class Cells {
 public:
  Cells(const std::vector<Ball>& balls, double size) : size_(size) {
    for (const Ball& ball : balls) entries_.push_back({cell(ball.centre), &ball});
    std::sort(entries_.begin(), entries_.end(),
              [](const Entry& a, const Entry& b) { return a.cell < b.cell; });
  }

  /// Shows `look` all balls nearer than a cell's size, and some more.
  template <class Look>
  void near(const Vector3d& point, const Look& look) const {
    const Cell c = cell(point);
    for (const double dx : {-1.0, 0.0, 1.0}) {
      for (const double dy : {-1.0, 0.0, 1.0}) {
        const Cell first{c[0] + dx, c[1] + dy, c[2] - 1};
        const Cell last{c[0] + dx, c[1] + dy, c[2] + 1};
        auto entry = std::lower_bound(entries_.begin(), entries_.end(), first,
                                      [](const Entry& e, const Cell& at) { return e.cell < at; });
        for (; entry != entries_.end() && entry->cell <= last; ++entry) look(*entry->ball);
      }
    }
  }

 private:
  using Cell = std::array<double, 3>;  // whole numbers, of any size
  struct Entry {
    Cell cell;
    const Ball* ball;
  };
  Cell cell(const Vector3d& point) const {
    return {std::floor(point[0] / size_), std::floor(point[1] / size_), std::floor(point[2] / size_)};
  }

  double size_;
  std::vector<Entry> entries_;
};

/// Reports which two are in each other, and where that is said.
class StartCheck {
 public:
  StartCheck(const SceneReader& read, const BodiesData& data) : read_(read), data_(data) {}

  void require_finite(const Group& group) const {
    for (const Ball& ball : group.balls) {
      if (!ball.centre.allFinite())
        read_.refuse(key(ball), "puts " + *ball.name + " beyond numbers", "a place nearer");
    }
  }

  void require_above(const Group& group, const PlaneData& plane) const {
    const Vector3d corner =
        group.box.center() - 0.5 * group.box.sizes().cwiseProduct(plane.normal.cwiseSign());
    if (gap(Ball{.centre = corner, .radius = group.radius}, plane) > 0) return;
    for (const Ball& ball : group.balls)
      require(ball, gap(ball, plane), std::max(ball.scale(), std::abs(plane.offset)), plane.name);
  }

  void require_apart(const Group& a, const Group& b) const {
    const double reach = a.radius + b.radius;
    if (a.box.exteriorDistance(b.box) > reach * (1 + rounding)) return;
    const auto look = [&](const Ball& one, const Ball& other) {
      require(one, gap(one, other), std::max(one.scale(), other.scale()), *other.name);
    };
    if (a.balls.size() == 1 || b.balls.size() == 1) {
      for (const Ball& one : a.balls) {
        for (const Ball& other : b.balls) look(one, other);
      }
      return;
    }
    const Cells cells(b.balls, reach);
    for (const Ball& one : a.balls) cells.near(one.centre, [&](const Ball& other) { look(one, other); });
  }

 private:
  /// Where the file says where a ball is.
  std::string key(const Ball& ball) const {
    const std::string& name = data_.bodies[ball.body].name;
    const std::string position = "body." + name + ".position";
    return read_.has(position) ? position : "balls." + name.substr(0, name.find('.')) + ".lower";
  }

  void require(const Ball& ball, double gap, double scale, const std::string& other) const {
    if (gap >= -rounding * scale) return;
    read_.refuse(key(ball), "puts " + *ball.name + ' ' + to_text(-gap) + " m deep into " + other,
                 "a place outside, or just touching");
  }

  const SceneReader& read_;
  const BodiesData& data_;
};

}  // namespace

void place_touching(const SceneReader& read, const std::vector<Surface>& surfaces, const std::string& plane,
                    std::size_t body, BodiesData& data) {
  BodyData& moved = data.bodies[body];
  const std::string key = "body." + moved.name + ".touching";
  const std::vector<std::size_t> found = named(surfaces, plane);
  if (found.size() != 1 || surfaces[found.front()].is_of_bodies())
    read.refuse(key, "is no plane", "the name of a plane or of a side of a box");
  const PlaneData& at = data.planes[surfaces[found.front()].first];
  // Twice: the first time from afar, the second with the rounding of where it is.
  for (int pass = 0; pass < 2; ++pass) {
    double least = std::numeric_limits<double>::infinity();
    for (const SphereData& sphere : moved.spheres) {
      if (meet(data, sphere.surface, at.surface)) least = std::min(least, gap(ball(moved, body, sphere), at));
    }
    if (moved.base && meet(data, moved.base->surface, at.surface))
      least = std::min(least, gap(foot(moved, body), at));
    if (!std::isfinite(least))
      read.refuse(key, "has no contact with " + moved.name, "a plane that a [contact.NAME] names with it");
    moved.position -= least * at.normal;
  }
}

void require_apart(const SceneReader& read, const std::vector<Surface>& surfaces, const BodiesData& data) {
  const StartCheck start(read, data);
  const std::vector<Group> groups = group(surfaces, data);
  for (const Group& group : groups) start.require_finite(group);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {  // planes are numbered last
      if (!meet(data, i, j)) continue;
      if (surfaces[i].is_of_bodies()) {
        start.require_apart(groups[j], groups[i]);
      } else {
        start.require_above(groups[j], data.planes[surfaces[i].first]);
      }
    }
  }
}

}  // namespace contensou
