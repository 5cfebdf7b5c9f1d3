#pragma once

#include "contensou/granular/contact_set.hpp"

namespace contensou {

/// What solving a contact with drilling friction as a point contact gets wrong at this slip, v = ‖γ_T‖, s =
/// |γ_τ|, as a part of μΛ_N: max(1 − ξ(u), η(u)), u = v/s, of the force and of the torque. Infinite where
/// v = 0, and for friction whose border is not smooth.
double point_error(const AnyFriction& friction, double v, double s);

/// The same for a contact that was solved as one, with these velocities.
double point_error(const AnyFriction& friction, double radius, const ContactBlock<3>& contact,
                   const std::vector<Twist>& twists);

/// Marks as `exact` the pairs that were solved as point contacts and whose error at the end is above
/// `fidelity`. Returns whether there are any.
bool refuse_points(const BodiesData& data, ContactSet& set, const std::vector<Twist>& after, double fidelity,
                   PairList& list);

/// Adds those that were solved so to `left_out`: the larger of the errors before and after each.
void add_left_out(const BodiesData& data, ContactSet& set, const std::vector<Twist>& before,
                  const std::vector<Twist>& after, LeftOut& left_out);

}  // namespace contensou
