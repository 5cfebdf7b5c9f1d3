#include "contensou/scene/simulation.hpp"

#include <stdexcept>
#include <utility>

#include "contensou/scene/body_columns.hpp"
#include "contensou/scene/columns.hpp"
#include "contensou/system/tippe_top_axis.hpp"
#include "contensou/system/tippe_top_euler.hpp"

namespace contensou {
namespace {

/// All but the state and what a row tells of it.
Simulation compose_system(const Scene& scene, std::shared_ptr<const MechanicalSystem> system) {
  Simulation simulation;
  simulation.t_end = scene.duration;
  simulation.options = scene.integrator;
  simulation.columns = columns(scene);
  for (const SystemContact& contact : system->contacts()) simulation.contacts.push_back(contact.name);
  simulation.works = system->works();
  simulation.advance = [system](State& state, double t_end, const IntegratorOptions& options,
                                const Observer& observer) {
    return integrate(*system, state, t_end, options, observer);
  };
  simulation.energy = [system](const State& at) {
    return system->kinetic_energy(at.q, at.u) + system->potential_energy(at.q);
  };
  simulation.system = std::move(system);
  return simulation;
}

Simulation compose_tippe_top(const Scene& scene, const TippeTopScene& data) {
  const std::shared_ptr<const TippeTopModel> top = make_tippe_top(data);
  Simulation simulation = compose_system(scene, top);
  simulation.state = top->start(data.theta, data.psi_dot, data.z_s);
  simulation.describe = describe_tippe_top(top, simulation.columns);
  return simulation;
}

/// Where the radius follows the load: rows and scales are written in the one under the weight, or under 1 N
/// where there is none.
void set_load_radius(SystemContact& contact, double relative_radius, double weight) {
  if (!contact.load_radius) return;
  contact.load_radius->relative_radius = relative_radius;
  contact.radius = contact.load_radius->at(weight > 0 ? weight : 1);
}

}  // namespace

std::unique_ptr<const TippeTopModel> make_tippe_top(const TippeTopScene& scene) {
  std::array<SystemContact, 2> contacts{make_contact(scene.contacts[0]), make_contact(scene.contacts[1])};
  const double weight = scene.data.m * scene.data.g;
  set_load_radius(contacts[0], scene.data.r1, weight);
  set_load_radius(contacts[1], scene.data.r2, weight);
  if (scene.formulation == TippeTopScene::Formulation::euler)
    return std::make_unique<TippeTopEuler>(scene.data, contacts);
  return std::make_unique<TippeTopAxis>(scene.data, contacts);
}

Simulation compose(const Scene& scene) {
  if (const auto* top = std::get_if<TippeTopScene>(&scene.system)) return compose_tippe_top(scene, *top);
  throw std::invalid_argument("scenes of bodies are not there yet");
}

}  // namespace contensou
