#pragma once

#include <string>
#include <vector>

#include "patch.hpp"

namespace verify::siconos {

/// A contact whose exact solution is known because its b was made from it: b = γ − W λ(γ), with λ(γ) the
/// exact law's, or λ within the friction ball and γ_F = 0 where the contact sticks.
struct PatchCase {
  std::string motion;
  Pressure pressure;
  PatchContact contact;
  Eigen::Vector4d force;
  Eigen::Vector4d velocity;
};

/// The motions of the study, three directions each: "sliding" (the centre of rotation two radii off the
/// patch's centre, u = 2), "turning" (within the patch, u = ½), "spinning" (at its centre), "sticking" (λ_F
/// at nine tenths of the way to the border). The body: a rigid one of 1 kg, whose contact point is off its
/// centre of mass, so that friction changes the normal force; μ = ½, λ_N = 1 N s.
std::vector<PatchCase> patch_cases(const std::string& motion, Pressure pressure);

}  // namespace verify::siconos
