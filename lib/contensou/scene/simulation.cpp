#include "contensou/scene/simulation.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "contensou/granular/nscd.hpp"
#include "contensou/scene/body_columns.hpp"
#include "contensou/scene/columns.hpp"
#include "contensou/system/body_forces.hpp"
#include "contensou/system/rigid_bodies.hpp"
#include "contensou/system/tippe_top_axis.hpp"
#include "contensou/system/tippe_top_euler.hpp"

namespace contensou {
namespace {

/// Where the radius follows the load: rows and scales are written in the one under the weight, or under 1 N
/// where there is none.
void set_load_radius(SystemContact& contact, double relative_radius, double weight) {
  if (!contact.load_radius) return;
  contact.load_radius->relative_radius = relative_radius;
  contact.radius = contact.load_radius->at(weight > 0 ? weight : 1);
}

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

/// The bodies with the laws of their contacts.
BodiesData with_rules(const BodiesScene& scene) {
  BodiesData data = scene.data;
  double mass = 0;
  double radius = std::numeric_limits<double>::infinity();
  for (const BodyData& body : data.bodies) {
    mass = std::max(mass, body.mass);
    for (const SphereData& sphere : body.spheres) radius = std::min(radius, sphere.radius);
  }
  for (const ContactScene& contact : scene.contacts) {
    data.rules.push_back(make_contact(contact));
    // What each pair makes of it, by its own radii, is the system's.
    set_load_radius(data.rules.back(), radius, mass * data.gravity.norm());
  }
  return data;
}

Simulation compose_rigid_bodies(const Scene& scene, const BodiesScene& bodies) {
  const auto system = std::make_shared<const RigidBodies>(with_rules(bodies));
  Simulation simulation = compose_system(scene, system);
  simulation.state = system->start();
  const std::shared_ptr<const BodiesData> data(system, &system->data());
  simulation.describe = describe_bodies(data, system, simulation.columns);
  return simulation;
}

Simulation compose_nscd(const Scene& scene, const BodiesScene& bodies) {
  const auto data = std::make_shared<const BodiesData>(with_rules(bodies));
  require_valid(*data);
  const BodyLayout layout(*data);
  Simulation simulation;
  simulation.state = layout.start();
  simulation.t_end = scene.duration;
  simulation.options = scene.integrator;
  simulation.columns = columns(scene);
  for (const SystemContact& rule : data->rules) simulation.contacts.push_back(rule.name);
  simulation.works = BodyForces(layout).works();
  simulation.advance = [data, threads = scene.threads](State& state, double t_end,
                                                       const IntegratorOptions& options,
                                                       const Observer& observer) {
    return run_nscd(*data, state, t_end, options, threads, observer);
  };
  simulation.energy = [data, layout](const State& at) {
    return layout.kinetic_energy(at.u) + layout.potential_energy(at.q);
  };
  simulation.describe = describe_bodies(data, nullptr, simulation.columns);
  return simulation;
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
  const auto& bodies = std::get<BodiesScene>(scene.system);
  return scene.integrator.method == Method::nscd ? compose_nscd(scene, bodies)
                                                 : compose_rigid_bodies(scene, bodies);
}

}  // namespace contensou
