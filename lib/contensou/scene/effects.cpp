#include "contensou/scene/effects.hpp"

#include <algorithm>

namespace contensou {

std::vector<std::string> effects(const ContactScene& contact) {
  std::vector<std::string> names{"unilateral contact"};
  if (contact.restitution > 0) names.emplace_back("restitution");
  if (contact.rows() >= 3) names.emplace_back("sliding friction");
  if (contact.rows() >= 4) {
    names.emplace_back("drilling friction");
    if (contact.model != "uncoupled") names.emplace_back("coupling of sliding and drilling");
    if (contact.modulus) names.emplace_back("load-dependent radius");
  }
  return names;
}

std::vector<std::string> effects(const Scene& scene) {
  std::vector<std::string> names;
  if (const auto* top = std::get_if<TippeTopScene>(&scene.system)) {
    if (top->data.g > 0) names.emplace_back("gravity");
  } else {
    const BodiesData& data = std::get<BodiesScene>(scene.system).data;
    if (!data.gravity.isZero(0)) names.emplace_back("gravity");
    if (std::any_of(data.bodies.begin(), data.bodies.end(), [](const BodyData& b) { return b.drag.any(); }))
      names.emplace_back("air drag");
    for (const LoadData& load : data.loads) names.push_back("load " + load.name);
    for (const BodyData& body : data.bodies) {
      if (body.rotation == Rotation::driven) names.push_back("driven " + body.name);
    }
  }
  for (const ContactScene* contact : scene.contacts()) {
    for (const std::string& effect : effects(*contact)) {
      if (std::find(names.begin(), names.end(), effect) == names.end()) names.push_back(effect);
    }
  }
  return names;
}

}  // namespace contensou
