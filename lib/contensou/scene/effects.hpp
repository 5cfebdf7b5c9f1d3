#pragma once

#include <string>
#include <vector>

#include "contensou/scene/scene.hpp"

namespace contensou {

/// What runs, by name: "unilateral contact", "restitution", "sliding friction", "drilling friction", and how
/// the two are coupled; "load-dependent radius".
std::vector<std::string> effects(const ContactScene& contact);
/// Of the whole scene: those of its contacts, and "gravity", "air drag", "load NAME", "driven BODY".
std::vector<std::string> effects(const Scene& scene);

}  // namespace contensou
