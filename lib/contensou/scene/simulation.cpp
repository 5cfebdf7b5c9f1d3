#include "contensou/scene/simulation.hpp"

#include <algorithm>
#include <utility>

#include "contensou/law/catalogue.hpp"
#include "contensou/law/power_limits.hpp"
#include "contensou/system/tippe_top_axis.hpp"
#include "contensou/system/tippe_top_euler.hpp"

namespace contensou {
namespace {

template <class Law>
AnyFriction ball(Law law) {
  return FrictionBall(SmoothPlate(std::move(law)));
}

SystemContact make_contact(const ContactScene& contact) {
  return {contact.name, make_friction(contact), contact.mu, contact.radius, contact.restitution};
}

}  // namespace

AnyFriction make_friction(const ContactScene& contact) {
  switch (contact.rows()) {
    case 1:
      return NoFriction{};
    case 3:
      return FrictionDisk{};
    default:
      break;
  }
  const double n = pressure_exponent(contact.pressure);
  if (contact.model == "ellipsoid") return ball(EllipsoidLaw(Extent{1.0, power_limits(n).eta_max}));
  if (n == 0) return ball(UniformLaw{});
  if (n == 0.5) return ball(HertzLaw{});
  return ball(CompiledLaw(PowerLaw(n)));
}

std::unique_ptr<const TippeTopModel> make_tippe_top(const TippeTopScene& scene) {
  const std::array<SystemContact, 2> contacts{make_contact(scene.contacts[0]),
                                              make_contact(scene.contacts[1])};
  if (scene.formulation == TippeTopScene::Formulation::euler)
    return std::make_unique<TippeTopEuler>(scene.data, contacts);
  return std::make_unique<TippeTopAxis>(scene.data, contacts);
}

Simulation compose(const Scene& scene) {
  std::unique_ptr<const TippeTopModel> model = make_tippe_top(scene.top);
  const TippeTopModel& top = *model;
  return {.system = std::move(model),
          .state = top.start(scene.top.theta, scene.top.psi_dot, scene.top.z_s),
          .t_end = scene.duration,
          .options = scene.integrator,
          .columns = {"theta", "z_s", "gap_body", "gap_tip", "energy", "omega_z", "omega_x", "omega_y", "x_s",
                      "y_s", "axis_x", "axis_y", "axis_z"},
          .describe = [&top](const Sample& at, std::vector<double>& row) {
            const Eigen::Vector3d omega = top.spin(at.q, at.u);
            const Eigen::Vector3d axis = top.axis(at.q);
            row.insert(row.end(),
                       {top.inclination(at.q), top.height(at.q), top.gap(0, at.t, at.q),
                        top.gap(1, at.t, at.q), top.kinetic_energy(at.q, at.u) + top.potential_energy(at.q),
                        omega[2], omega[0], omega[1], at.q[0], at.q[1], axis[0], axis[1], axis[2]});
          }};
}

std::vector<std::string> effects(const ContactScene& contact) {
  std::vector<std::string> names{"unilateral contact"};
  if (contact.restitution > 0) names.emplace_back("restitution");
  if (contact.rows() >= 3) names.emplace_back("sliding friction");
  if (contact.rows() >= 4) names.emplace_back("drilling friction");
  return names;
}

std::vector<std::string> effects(const Scene& scene) {
  std::vector<std::string> names;
  if (scene.top.data.g > 0) names.emplace_back("gravity");
  for (const ContactScene& contact : scene.top.contacts) {
    for (const std::string& effect : effects(contact)) {
      if (std::find(names.begin(), names.end(), effect) == names.end()) names.push_back(effect);
    }
  }
  return names;
}

}  // namespace contensou
