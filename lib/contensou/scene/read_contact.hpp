#pragma once

#include <string>

#include "contensou/integrate/motion.hpp"
#include "contensou/scene/contact_scene.hpp"
#include "contensou/scene/reader.hpp"

namespace contensou {

/// [contact.NAME], all but `between`. `usual_pressure`: what stands in where a Contensou contact has none; if
/// null, it must have one.
ContactScene read_contact(SceneReader& read, const std::string& name, const char* usual_pressure);

/// Refuses what the method cannot do: with reader.refuse(), once all keys are known to be there.
void require_able(const SceneReader& read, const ContactScene& contact, Method method);

/// Whether the method is one of time-stepping as it is meant, which knows models and radii that others do
/// not.
bool is_time_stepping(Method method);

}  // namespace contensou
