#include "contensou/scene/read_tippe_top.hpp"

#include <numbers>

#include "contensou/scene/read_contact.hpp"
#include "contensou/scene/simulation.hpp"
#include "contensou/text/number.hpp"

namespace contensou {
namespace {

using Formulation = TippeTopScene::Formulation;

/// Gaps this deep are rounding, as for the integrators.
constexpr double penetration_limit = 1e-12;

TippeTopData read_top(SceneReader& read) {
  constexpr Range any;
  TippeTopData top{.m = read.number("top.mass", positive),
                   .i1 = read.number("top.i1", positive),
                   .i3 = read.number("top.i3", positive),
                   .g = read.number("scene.gravity", not_negative),
                   .a1 = read.number("top.a1", any),
                   .a2 = read.number("top.a2", any),
                   .r1 = read.number("top.r1", positive),
                   .r2 = read.number("top.r2", positive)};
  // The triangle inequality of principal moments of inertia.
  if (top.i3 > 2 * top.i1) read.refuse("top.i3", "is more than any body has", "a number > 0, at most 2 i1");
  return top;
}

double read_theta(SceneReader& read, Formulation formulation) {
  const Range axis{.least = 0, .most = std::numbers::pi, .expected = "a number from 0 to pi [rad]"};
  const double theta = read.number("initial.theta", axis);
  if (formulation == Formulation::euler && (theta == 0 || theta == std::numbers::pi))
    read.refuse("initial.theta", "is where Euler angles are singular",
                "a number between 0 and pi, or scene.formulation = \"axis\"");
  return theta;
}

std::optional<double> read_height(SceneReader& read) {
  constexpr Range height{.expected = "a number [m] or \"contact\""};
  const std::string key = "initial.z_s";
  if (!read.is_text(key)) return read.number(key, height);
  if (read.text(key, height.expected) != "contact") read.refuse(key, "is not a number", height.expected);
  return {};
}

}  // namespace

TippeTopScene read_tippe_top(SceneReader& read) {
  TippeTopScene top;
  const bool euler = read.optional_choice("scene.formulation", {"axis", "euler"}) == "euler";
  top.formulation = euler ? Formulation::euler : Formulation::axis;
  top.data = read_top(read);
  top.theta = read_theta(read, top.formulation);
  top.psi_dot = read.number("initial.psi_dot", Range{});
  top.z_s = read_height(read);
  top.contacts = {read_contact(read, "body", "hertz"), read_contact(read, "tip", "hertz")};
  return top;
}

void require_above_floor(const SceneReader& read, const TippeTopScene& scene) {
  if (!scene.z_s) return;
  const std::unique_ptr<const TippeTopModel> top = make_tippe_top(scene);
  const double lowest = top->start(scene.theta, scene.psi_dot).q[2];
  if (*scene.z_s < lowest - penetration_limit * top->length_scale())
    read.refuse("initial.z_s", "puts the top into the floor",
                "\"contact\", or at least " + to_text(lowest) + " for this theta");
}

}  // namespace contensou
