#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "contensou/scene/scene.hpp"
#include "refusal.hpp"

namespace contensou::test {

/// One of everything that a scene of bodies can hold.
inline constexpr std::string_view everything = R"([scene]
system = "bodies"
duration = 1
gravity = [0, 1, -9.81]
[body.top]
rotation = "free"
mass = 2
inertia = [3, 4, 5]
position = [0.5, 0.25, 7]
touching = "floor"
orientation = [0, 1, 0, 0]
velocity = [1, 2, 3]
spin = [4, 5, 6]
linear_drag = 0.5
angular_drag = 0.25
[body.top.sphere.tip]
centre = [0, 0, 2]
radius = 0.5
[body.top.sphere.hull]
radius = 1
[body.puck]
rotation = "upright"
mass = 1
inertia = 0.125
position = [9, 9, 0.25]
spin = 3
[body.puck.base]
height = 0.25
[body.brush]
rotation = "driven"
mass = 1
position = [-9, -9, 4]
spin = [0, 0, 7]
[body.brush.sphere.rim]
radius = 1
[body.bead]
rotation = "none"
mass = 1
position = [-9, 9, 4]
[body.bead.sphere.all]
radius = 1
[balls.pile]
count = 5
radius = 0.25
mass = 2
lower = [20, 0, 1]
spacing = 1
across = [2, 1]
jitter = 0.25
seed = 7
rotation = "free"
velocity = [0, 0, -1]
spin = [0, 1, 0]
linear_drag = 0.125
angular_drag = 0.0625
[plane.floor]
normal = [0, 0, 1]
offset = 0
[plane.slope]
normal = [0, 0.6, 0.8]
offset = -50
[box.hall]
lower = [-50, -51, -52]
upper = [53, 54, 55]
sides = ["west", "north", "bottom"]
[load.push]
body = "puck"
force = [1, 2, 3]
torque = [0, 0, 4]
times = [0, 1, 2]
factors = [1, 0.5, 0]
frequency = 50
phase = 0.5
[contact.top]
between = ["top.tip", "floor"]
law = "contensou"
pressure = "table"
table_radius = [0, 0.5, 1]
table_pressure = [1, 1, 0]
model = "ellipsoid"
radius = 0.001
mu = 0.3
[contact.slide]
between = ["puck.base", "floor"]
law = "coulomb"
mu = 0.2
[contact.pile]
between = ["pile", "pile"]
law = "coulomb"
mu = 0.5
restitution = 0.5
[contact.walls]
between = ["pile", "hall"]
law = "frictionless"
[contact.hulls]
between = ["top", "brush"]
law = "contensou"
pressure = "uniform"
radius = 0.002
mu = 0.1
[integrator]
method = "event_driven"
tolerance = 1e-9
[output]
interval = 0.25
columns = ["top.x", "pile.5.z", "gap_top", "slip_slide", "energy"]
[outcome.end]
kind = "final"
column = "top.z"
[outcome.through]
kind = "crossing"
column = "highest"
value = 1.5
[outcome.third]
kind = "event"
event = "stick"
contact = "pile_3"
occurrence = 2
[outcome.hits]
kind = "count"
event = "close"
contact = "hulls_1"
)";

inline SceneDocument document(std::string_view text = everything) { return parse_document(text, "f.toml"); }

struct Change {
  std::vector<std::string> unset;
  std::vector<std::string> set;
};

inline Scene changed(const Change& change, std::string_view text = everything) {
  SceneDocument scene = document(text);
  for (const std::string& key : change.unset) unset_value(scene, key);
  for (const std::string& assignment : change.set) set_value(scene, assignment);
  return read_scene(scene);
}

/// The one line with which a scene is refused; empty where it is not.
inline std::string refusal(const Change& change, std::string_view text = everything) {
  return refusal_of([&] { changed(change, text); });
}

inline const BodiesScene& bodies_of(const Scene& scene) { return std::get<BodiesScene>(scene.system); }

/// A change, and what the line about it holds.
struct Refused {
  Change change;
  std::vector<std::string> words;
};

/// Says what of `refused` is not as expected; empty: all is.
inline std::string check_refused(const Refused& refused, std::string_view text = everything) {
  const std::string line = refusal(refused.change, text);
  if (line.empty()) return "not refused";
  if (line.find('\n') != std::string::npos) return "more than a line: " + line;
  if (line.find("; expected ") == std::string::npos) return "nothing expected: " + line;
  for (const std::string& word : refused.words) {
    if (line.find(word) == std::string::npos) return "'" + word + "' is missing in: " + line;
  }
  return "";
}

}  // namespace contensou::test
