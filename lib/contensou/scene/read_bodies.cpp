#include "contensou/scene/read_bodies.hpp"

#include <set>
#include <utility>

#include "contensou/scene/between.hpp"
#include "contensou/scene/read_body.hpp"
#include "contensou/scene/read_contact.hpp"
#include "contensou/scene/read_loads.hpp"
#include "contensou/scene/read_planes.hpp"
#include "contensou/scene/start.hpp"
#include "contensou/scene/surfaces.hpp"

namespace contensou {
namespace {

/// Of the table of rules, which has a square of it: named spheres, bases, planes, and groups of balls.
constexpr std::size_t most_surfaces = 1000;

Eigen::Vector3d read_gravity(SceneReader& read) {
  const std::string key = "scene.gravity";
  constexpr const char* expected = "a number >= 0, towards -z, or an array of three [m/s^2]";
  if (read.is_array(key)) return read.optional_vector(key).value_or(Eigen::Vector3d::Zero());
  const Range range{.least = 0, .expected = expected};
  return {0, 0, -read.optional_number(key, range).value_or(0)};
}

void read_contacts(SceneReader& read, BodiesDraft& draft) {
  constexpr Length two{.least = 2, .most = 2, .expected = "an array of two names, of what touches"};
  for (const std::string& name : read.tables("contact")) {
    draft.scene.contacts.push_back(read_contact(read, name, nullptr));
    draft.between.push_back(read.texts("contact." + name + ".between", two));
  }
}

void read_balls(SceneReader& read, BodiesDraft& draft) {
  int left = most_balls;
  for (const std::string& name : read.tables("balls")) {
    draft.balls.push_back(read_balls(read, name));
    left -= draft.balls.back().count;
    if (left < 0) read.refuse("balls." + name + ".count", "makes more than 1e6 balls in all", "fewer");
  }
}

/// Bodies, balls, planes and boxes are named by contacts, loads and columns.
void require_distinct_names(SceneReader& read) {
  std::set<std::string> names;
  for (const char* kind : {"body", "balls", "plane", "box"}) {
    for (const std::string& name : read.tables(kind)) {
      if (!names.insert(name).second)
        read.refuse_table(std::string(kind) + '.' + name, "has the name of something else", "another name");
    }
  }
}

}  // namespace

BodiesDraft read_bodies(SceneReader& read) {
  BodiesDraft draft;
  BodiesData& data = draft.scene.data;
  require_distinct_names(read);
  data.gravity = read_gravity(read);
  read.unused("scene.formulation", "system bodies");
  for (const std::string& name : read.tables("body")) {
    data.bodies.push_back(read_body(read, name));
    draft.touching.push_back(
        read.optional_text("body." + name + ".touching", "the name of a plane").value_or(""));
  }
  read_balls(read, draft);
  for (const std::string& name : read.tables("plane")) data.planes.push_back(read_plane(read, name));
  for (const std::string& name : read.tables("box")) {
    for (PlaneData& side : read_box(read, name)) data.planes.push_back(std::move(side));
  }
  read_contacts(read, draft);
  for (const std::string& name : read.tables("load")) {
    data.loads.push_back(read_load(read, name));
    draft.loaded.push_back(read.text("load." + name + ".body", "the name of a body"));
  }
  return draft;
}

BodiesScene resolve(const SceneReader& read, BodiesDraft draft, Method method) {
  BodiesScene& scene = draft.scene;
  BodiesData& data = scene.data;
  if (data.bodies.empty() && draft.balls.empty())
    read.refuse_scene("there is no body", "a [body.NAME] or [balls.NAME]");
  std::vector<std::size_t> counts;
  for (const BallsScene& balls : draft.balls) {
    append_balls(balls, data.bodies);
    counts.push_back(static_cast<std::size_t>(balls.count));
  }
  const std::vector<Surface> surfaces = number_surfaces(data, counts);
  if (surfaces.size() > most_surfaces)
    read.refuse_scene(
        "there are " + std::to_string(surfaces.size()) + " spheres, bases and planes with names",
        "at most 1000; all of [balls.NAME] are one");
  for (const ContactScene& contact : scene.contacts) require_able(read, contact, method);
  resolve_rules(read, surfaces, draft.between, method, scene);
  for (std::size_t i = 0; i < draft.loaded.size(); ++i)
    resolve_load(read, data.bodies, draft.loaded[i], data.loads[i]);
  for (std::size_t i = 0; i < draft.touching.size(); ++i) {
    if (read.has("body." + data.bodies[i].name + ".touching"))
      place_touching(read, surfaces, draft.touching[i], i, data);
  }
  require_apart(read, surfaces, data);
  return std::move(scene);
}

}  // namespace contensou
