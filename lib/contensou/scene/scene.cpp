#include "contensou/scene/scene.hpp"

#include <filesystem>
#include <utility>

#include "contensou/scene/read_bodies.hpp"
#include "contensou/scene/read_contact.hpp"
#include "contensou/scene/read_integrator.hpp"
#include "contensou/scene/read_measures.hpp"
#include "contensou/scene/read_tippe_top.hpp"
#include "contensou/scene/reader.hpp"

namespace contensou {
namespace {

/// Where the scene does not say its system, what it holds tells it, so that its keys are not taken for
/// misspelt.
bool is_of_bodies(SceneReader& read) {
  const std::string system = read.choice("scene.system", {"tippe_top", "bodies"});
  if (read.has("scene.system")) return system == "bodies";
  return !read.tables("body").empty() || !read.tables("balls").empty();
}

}  // namespace

std::vector<const ContactScene*> Scene::contacts() const {
  std::vector<const ContactScene*> all;
  if (const auto* top = std::get_if<TippeTopScene>(&system)) {
    for (const ContactScene& contact : top->contacts) all.push_back(&contact);
  } else {
    for (const ContactScene& contact : std::get<BodiesScene>(system).contacts) all.push_back(&contact);
  }
  return all;
}

Scene read_scene(const SceneDocument& document) {
  SceneReader read(document);
  Scene scene;
  scene.file = document.file;
  const bool bodies = is_of_bodies(read);
  scene.name = read.optional_text("scene.name", "a string")
                   .value_or(std::filesystem::path(document.file).stem().string());
  if (bodies) scene.system.emplace<BodiesScene>();
  read_integrator(read, scene);
  BodiesDraft draft;
  if (bodies) {
    draft = read_bodies(read);
  } else {
    scene.system = read_tippe_top(read);
  }
  read_measures(read, scene);
  read.finish();

  const Method method = scene.integrator.method;
  if (bodies) {
    scene.system = resolve(read, std::move(draft), method);
  } else {
    for (const ContactScene* contact : scene.contacts()) require_able(read, *contact, method);
    require_above_floor(read, std::get<TippeTopScene>(scene.system));
  }
  require_measurable(read, scene);
  return scene;
}

}  // namespace contensou
