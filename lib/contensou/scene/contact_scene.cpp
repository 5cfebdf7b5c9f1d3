#include "contensou/scene/contact_scene.hpp"

#include <utility>

#include "contensou/law/catalogue.hpp"
#include "contensou/law/power_limits.hpp"
#include "contensou/law/radial.hpp"

namespace contensou {
namespace {

/// Of a table's law: what a table's own entries are hardly worth, and compiled in seconds.
constexpr double table_tolerance = 1e-9;

template <class Law>
AnyFriction ball(Law law) {
  return FrictionBall(SmoothPlate(std::move(law)));
}

RadialLaw table_law(const ContactScene& contact) {
  return RadialLaw(tabulated_pressure(contact.table_radius, contact.table_pressure));
}

/// How large the drilling friction of the contact's pressure can be.
Extent extent(const ContactScene& contact) {
  if (contact.pressure == "table") return table_law(contact).extent();
  return {1.0, power_limits(pressure_exponent(contact.pressure)).eta_max};
}

AnyFriction exact_ball(const ContactScene& contact) {
  if (contact.pressure == "table") return ball(table_law(contact).compile(table_tolerance));
  const double n = pressure_exponent(contact.pressure);
  if (n == 0) return ball(UniformLaw{});
  if (n == 0.5) return ball(HertzLaw{});
  return ball(CompiledLaw(PowerLaw(n)));
}

}  // namespace

const char* name(ContactLaw law) {
  switch (law) {
    case ContactLaw::frictionless:
      return "frictionless";
    case ContactLaw::coulomb:
      return "coulomb";
    case ContactLaw::contensou:
      return "contensou";
  }
  return "";
}

int ContactScene::rows() const {
  if (law == ContactLaw::frictionless) return 1;
  return law == ContactLaw::contensou && (radius > 0 || modulus) ? 4 : 3;
}

AnyFriction make_friction(const ContactScene& contact) {
  switch (contact.rows()) {
    case 1:
      return NoFriction{};
    case 3:
      return FrictionDisk{};
    default:
      break;
  }
  if (contact.model == "ellipsoid") return ball(EllipsoidLaw(extent(contact)));
  if (contact.model == "uncoupled") return FrictionCylinder(extent(contact).eta);
  return exact_ball(contact);
}

SystemContact make_contact(const ContactScene& contact) {
  SystemContact made{contact.name, make_friction(contact), contact.mu, contact.radius, contact.restitution};
  if (contact.modulus) {
    made.radius = 1;
    made.load_radius = LoadRadius{.modulus = *contact.modulus};
  }
  return made;
}

}  // namespace contensou
