#include "contensou/integrate/method_limits.hpp"

#include <stdexcept>
#include <string>
#include <variant>

namespace contensou {
namespace {

/// nscd answers for itself.
bool steps_in_time(Method method) {
  return method == Method::nscd || method == Method::moreau || method == Method::moreau_implicit ||
         method == Method::moreau_adaptive;
}

[[noreturn]] void refuse(const SystemContact& contact, const char* what, Method method,
                         const char* expected) {
  throw std::invalid_argument("contact " + contact.name + ": " + what + " with method " + name(method) +
                              ", expected " + expected);
}

}  // namespace

void require_possible(const MechanicalSystem& system, const IntegratorOptions& options) {
  if (steps_in_time(options.method)) return;
  if (options.fidelity) {
    throw std::invalid_argument(std::string("integrator: fidelity with method ") + name(options.method) +
                                ", expected moreau, moreau_implicit, moreau_adaptive or nscd");
  }
  for (const SystemContact& contact : system.contacts()) {
    if (std::holds_alternative<FrictionCylinder>(contact.friction)) {
      refuse(contact, "uncoupled sliding and drilling friction", options.method,
             "moreau, moreau_implicit, moreau_adaptive or nscd");
    }
    if (follows_load(contact)) {
      refuse(contact, "a radius that follows the load", options.method,
             "moreau, moreau_implicit or moreau_adaptive");
    }
  }
}

}  // namespace contensou
