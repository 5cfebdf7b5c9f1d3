#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contensou/integrate/mechanical_system.hpp"

namespace contensou {

enum class ContactLaw { frictionless, coulomb, contensou };
const char* name(ContactLaw law);

/// [contact.NAME]: a contact's law as a scene describes it. What the law does not use is not set.
struct ContactScene {
  std::string name;
  ContactLaw law = ContactLaw::frictionless;
  /// contensou: "uniform" | "hertz" | "power:N", as pressure_exponent() takes it, or "table".
  std::string pressure;
  std::vector<double> table_radius;    ///< "table": ρ/R, strictly increasing from 0 to 1
  std::vector<double> table_pressure;  ///< σ there, as many, >= 0
  std::string model;                   ///< contensou: "exact" | "ellipsoid" | "uncoupled"
  double mu = 0;                       ///< coulomb, contensou: >= 0
  /// contensou [m]; 0 stands for the limit R → 0, a Coulomb point contact. Unused where modulus is given.
  double radius = 0;
  /// contensou, radius = "hertz": E* [Pa]; the radius follows the load, LG03 (3.2), (3.3).
  std::optional<double> modulus;
  double restitution = 0;  ///< 0 to 1

  /// 1, 3 or 4: what the contact costs, and whether there is a drilling torque (4).
  int rows() const;
};

/// The friction of a contact with the rows its law asks for: exact pressures "uniform" and "hertz" in closed
/// form, others compiled (power:N in 10 to 200 ms, a table in seconds). Throws std::invalid_argument with one
/// line.
AnyFriction make_friction(const ContactScene& contact);
/// All of the contact. Where the radius follows the load, `radius` is 1 and load_radius has no relative
/// radius yet: who knows the geometry sets both.
SystemContact make_contact(const ContactScene& contact);

}  // namespace contensou
