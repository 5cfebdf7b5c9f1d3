#include "contensou/integrate/mechanical_system.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "contensou/text/number.hpp"

namespace contensou {
namespace {

[[noreturn]] void reject(const SystemContact& contact, const char* what, double value, const char* expected) {
  throw std::invalid_argument("contact " + contact.name + ": " + what + " " + to_text(value) + ", expected " +
                              expected);
}

void require_valid(const SystemContact& contact) {
  const int n = rows(contact.friction);
  if (n > 1 && !(contact.mu >= 0 && std::isfinite(contact.mu)))
    reject(contact, "mu", contact.mu, "a number >= 0");
  if (n > 3 && !(contact.radius > 0 && std::isfinite(contact.radius)))
    reject(contact, "radius", contact.radius, "a number > 0");
  if (follows_load(contact)) {
    const LoadRadius& r = *contact.load_radius;
    if (!(r.relative_radius > 0 && std::isfinite(r.relative_radius)))
      reject(contact, "relative radius", r.relative_radius, "a number > 0");
    if (!(r.modulus > 0 && std::isfinite(r.modulus))) reject(contact, "modulus", r.modulus, "a number > 0");
  }
  if (!(contact.restitution >= 0 && contact.restitution <= 1))
    reject(contact, "restitution", contact.restitution, "a number from 0 to 1");
}

}  // namespace

bool follows_load(const SystemContact& contact) {
  return contact.load_radius.has_value() && rows(contact.friction) > 3;
}

double LoadRadius::at(double lambda_n) const {
  return lambda_n > 0 ? std::cbrt(0.75 * relative_radius * lambda_n / modulus) : 0;
}

double LoadRadius::impact_load(double mass, double speed) const {
  if (!(speed > 0)) return 0;
  const double stiffness = 4.0 / 3 * modulus * std::sqrt(relative_radius);
  return std::pow(stiffness, 0.4) * std::pow(1.25 * mass * speed * speed, 0.6);
}

MechanicalSystem::MechanicalSystem(std::vector<SystemContact> contacts) : contacts_(std::move(contacts)) {
  for (const SystemContact& contact : contacts_) require_valid(contact);
}

void MechanicalSystem::coordinate_rates(ConstVector /*q*/, ConstVector u, VectorRef rates) const {
  rates = u;
}

void MechanicalSystem::restore(VectorRef /*q*/) const {}

void MechanicalSystem::coordinate_scales(VectorRef scales) const { scales.setOnes(); }

const std::vector<std::string>& MechanicalSystem::works() const {
  static const std::vector<std::string> none;
  return none;
}

void MechanicalSystem::powers(double /*t*/, ConstVector /*q*/, ConstVector /*u*/, VectorRef /*power*/) const {
}

}  // namespace contensou
