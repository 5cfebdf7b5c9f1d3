#include "contensou/system/tippe_top_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "contensou/text/number.hpp"

namespace contensou {
namespace {

void require(bool fine, const char* what, double value, const char* expected) {
  if (fine && std::isfinite(value)) return;
  throw std::invalid_argument(std::string("tippe-top: ") + what + " " + to_text(value) + ", expected " +
                              expected);
}

void require_valid(const TippeTopData& d) {
  constexpr auto positive = "a number > 0";
  require(d.m > 0, "m", d.m, positive);
  require(d.i1 > 0, "i1", d.i1, positive);
  require(d.i3 > 0 && d.i3 <= 2 * d.i1, "i3", d.i3, "a number > 0, at most 2 i1");
  require(d.g >= 0, "g", d.g, "a number >= 0");
  require(true, "a1", d.a1, "a finite number");
  require(true, "a2", d.a2, "a finite number");
  require(d.r1 > 0, "r1", d.r1, positive);
  require(d.r2 > 0, "r2", d.r2, positive);
}

void require_name(const SystemContact& contact, const char* name) {
  if (contact.name != name)
    throw std::invalid_argument("tippe-top: contact " + contact.name + ", expected " + name);
}

}  // namespace

std::array<SystemContact, 2> tippe_top_contacts(const AnyFriction& friction, double mu, double radius,
                                                double restitution) {
  return {SystemContact{"body", friction, mu, radius, restitution},
          SystemContact{"tip", friction, mu, radius, restitution}};
}

TippeTopModel::TippeTopModel(const TippeTopData& data, const std::array<SystemContact, 2>& contacts)
    : MechanicalSystem({contacts.begin(), contacts.end()}),
      data_(data),
      spheres_{Sphere{rows(contacts[0].friction), data.a1, data.r1, contacts[0].radius},
               Sphere{rows(contacts[1].friction), data.a2, data.r2, contacts[1].radius}} {
  require_name(contacts[0], "body");
  require_name(contacts[1], "tip");
  require_valid(data_);
}

double TippeTopModel::length_scale() const {
  return std::max(std::abs(data_.a1) + data_.r1, std::abs(data_.a2) + data_.r2);
}

void TippeTopModel::coordinate_scales(VectorRef scales) const {
  scales.setOnes();
  scales.head<3>().setConstant(length_scale());
}

double TippeTopModel::starting_height(double theta, double psi_dot, std::optional<double> z_s) const {
  require(theta >= 0 && theta <= std::numbers::pi, "theta", theta, "a number from 0 to pi");
  require(true, "psi_dot", psi_dot, "a finite number");
  require(true, "z_s", z_s.value_or(0), "a finite number");
  const double cosine = std::cos(theta);
  return z_s ? *z_s : -std::min(gap_at(0, 0, cosine), gap_at(1, 0, cosine));
}

}  // namespace contensou
