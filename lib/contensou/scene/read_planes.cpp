#include "contensou/scene/read_planes.hpp"

#include <algorithm>
#include <array>

#include "contensou/scene/unit_length.hpp"

namespace contensou {
namespace {

using Eigen::Vector3d;

struct Side {
  const char* name;
  int axis;
  double inward;  ///< sign of the normal
};

constexpr std::array<Side, 6> all_sides{
    {{"bottom", 2, 1}, {"top", 2, -1}, {"west", 0, 1}, {"east", 0, -1}, {"south", 1, 1}, {"north", 1, -1}}};

}  // namespace

PlaneData read_plane(SceneReader& read, const std::string& name) {
  const std::string key = "plane." + name + ".normal";
  PlaneData plane;
  plane.name = name;
  plane.normal = read.vector(key);
  if (read.has(key)) {
    require_unit_length(read, key, plane.normal.stableNorm(), "a vector of length 1");
    plane.normal.normalize();
  }
  plane.offset = read.number("plane." + name + ".offset", {.expected = "a finite number [m]"});
  return plane;
}

std::vector<PlaneData> read_box(SceneReader& read, const std::string& name) {
  const std::string table = "box." + name + '.';
  const Vector3d lower = read.vector(table + "lower");
  const Vector3d upper = read.vector(table + "upper");
  if ((upper.array() <= lower.array()).any())
    read.refuse(table + "upper", "is not above lower",
                "an array of three numbers, each greater than in lower");
  constexpr Length sides{
      .most = 6, .expected = "any of \"bottom\" \"top\" \"west\" \"east\" \"south\" \"north\", each once"};
  std::vector<PlaneData> planes;
  for (const std::string& text : read.texts(table + "sides", sides)) {
    const auto* side =
        std::find_if(all_sides.begin(), all_sides.end(), [&](const Side& s) { return s.name == text; });
    const std::string title = name + '.' + text;
    const bool again = std::any_of(planes.begin(), planes.end(),
                                   [&](const PlaneData& plane) { return plane.name == title; });
    if (side == all_sides.end() || again)
      read.refuse(table + "sides", again ? "names a side twice" : "names no side", sides.expected);
    PlaneData plane;
    plane.name = title;
    plane.normal = side->inward * Vector3d::Unit(side->axis);
    plane.offset = side->inward * (side->inward > 0 ? lower : upper)[side->axis];
    planes.push_back(std::move(plane));
  }
  return planes;
}

}  // namespace contensou
