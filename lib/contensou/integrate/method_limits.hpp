#pragma once

#include "contensou/integrate/motion.hpp"

namespace contensou {

/// What only the time-stepping methods moreau, moreau_implicit and moreau_adaptive can do: sliding and
/// drilling friction apart (FrictionCylinder: its border has edges, and one part may stick while the other
/// slips), and a contact radius that follows the load (SystemContact::load_radius); and
/// IntegratorOptions::fidelity. Throws
/// std::invalid_argument with one line that names the contact, what it asks for, and the methods that can,
/// for another method.
void require_possible(const MechanicalSystem& system, const IntegratorOptions& options);

}  // namespace contensou
