#include "contensou/scene/read_contact.hpp"

#include <stdexcept>
#include <utility>

#include "contensou/law/catalogue.hpp"
#include "contensou/law/radial.hpp"

namespace contensou {
namespace {

constexpr const char* pressures = "\"uniform\", \"hertz\", \"power:N\" or \"table\"";

/// A friction that the contact names but cannot have is a matter of its pressure.
void require_pressure(const SceneReader& read, const std::string& key, const ContactScene& contact) {
  try {
    pressure_exponent(contact.pressure);
    if (contact.model == "exact") make_friction(contact);
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();
    const std::string_view word = "expected ";
    const std::size_t expected = what.find(word);
    read.refuse(key, "is no pressure",
                expected == std::string::npos ? what : what.substr(expected + word.size()));
  }
}

void read_table(SceneReader& read, const std::string& table, ContactScene& contact) {
  const std::string radius = table + "table_radius";
  const std::string pressure = table + "table_pressure";
  contact.table_radius = read.numbers(
      radius, {.least = 2, .expected = "an array of numbers that increase from 0 to 1"}, from_0_to_1);
  contact.table_pressure =
      read.numbers(pressure, {.least = 2, .expected = "an array of numbers >= 0, as many as in table_radius"},
                   not_negative);
  if (!read.has(radius) || !read.has(pressure)) return;
  if (contact.table_radius.size() != contact.table_pressure.size())
    read.refuse(pressure, "has " + std::to_string(contact.table_pressure.size()) + " entries",
                std::to_string(contact.table_radius.size()) + ", as in table_radius");
  try {
    RadialLaw(tabulated_pressure(contact.table_radius, contact.table_pressure));
  } catch (const std::invalid_argument& error) {
    read.refuse(radius, std::string("makes no pressure: ") + error.what(),
                "radii that increase from 0 to 1, pressures >= 0, one of them > 0");
  }
}

void read_pressure(SceneReader& read, const std::string& table, const char* usual, ContactScene& contact) {
  const std::string key = table + "pressure";
  contact.pressure =
      usual == nullptr ? read.text(key, pressures) : read.optional_text(key, pressures).value_or(usual);
  if (contact.pressure == "table") return read_table(read, table, contact);
  for (const char* unused : {"table_radius", "table_pressure"})
    read.unused(table + unused, "pressure " + contact.pressure);
  if (read.has(key)) require_pressure(read, key, contact);
}

void read_radius(SceneReader& read, const std::string& table, ContactScene& contact) {
  constexpr Range radius{.least = 0, .expected = "a number >= 0 [m] or \"hertz\": it follows the load"};
  const std::string key = table + "radius";
  if (!read.is_text(key)) {
    contact.radius = read.number(key, radius);
    return read.unused(table + "modulus", "a radius that is given");
  }
  if (read.text(key, radius.expected) != "hertz") read.refuse(key, "is not a number", radius.expected);
  contact.modulus = read.number(table + "modulus", positive);
}

}  // namespace

ContactScene read_contact(SceneReader& read, const std::string& name, const char* usual_pressure) {
  const std::string table = "contact." + name + '.';
  ContactScene contact;
  contact.name = name;
  const std::string law = read.choice(table + "law", {"contensou", "coulomb", "frictionless"});
  contact.law = law == "contensou" ? ContactLaw::contensou
                : law == "coulomb" ? ContactLaw::coulomb
                                   : ContactLaw::frictionless;
  contact.restitution = read.optional_number(table + "restitution", from_0_to_1).value_or(0);
  if (contact.law == ContactLaw::frictionless) {
    read.unused(table + "mu", "law frictionless");
  } else {
    contact.mu = read.number(table + "mu", not_negative);
  }
  if (contact.law != ContactLaw::contensou) {
    for (const char* key : {"pressure", "table_radius", "table_pressure", "model", "radius", "modulus"})
      read.unused(table + key, "law " + law);
    return contact;
  }
  read_radius(read, table, contact);
  contact.model =
      read.optional_choice(table + "model", {"exact", "ellipsoid", "uncoupled"}).value_or("exact");
  read_pressure(read, table, usual_pressure, contact);
  return contact;
}

bool is_time_stepping(Method method) {
  return method == Method::moreau || method == Method::moreau_implicit || method == Method::moreau_adaptive ||
         method == Method::nscd;
}

void require_able(const SceneReader& read, const ContactScene& contact, Method method) {
  constexpr const char* time_stepping = "moreau, moreau_implicit, moreau_adaptive or nscd";
  const std::string table = "contact." + contact.name + '.';
  const std::string able = std::string("is not for method ") + name(method);
  if (!is_time_stepping(method)) {
    if (contact.modulus)
      read.refuse(table + "radius", able, std::string("a number [m], or method ") + time_stepping);
    if (contact.model == "uncoupled")
      read.refuse(table + "model", able,
                  std::string("\"exact\" or \"ellipsoid\", or method ") + time_stepping);
  }
  if ((method == Method::moreau_printed || method == Method::rk4_printed) && contact.restitution > 0)
    read.refuse(table + "restitution", able, "0, or another method");
}

}  // namespace contensou
