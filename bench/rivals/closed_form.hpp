#pragma once

#include "contensou/law/friction_law.hpp"

namespace rivals {

/// A law as somebody else would compute it: phi, xi, eta at u = v/|ωR|, and
/// the second derivative f″(u) = dξ/du. No guards beyond those a formula needs
/// to be usable at all: where it breaks down it returns what it returns.
struct ClosedForm {
  contensou::Reduced (*at)(double u);
  double (*second)(double u);
};

}  // namespace rivals
