#include "contensou/law/contact_radius.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "contensou/text/number.hpp"

namespace contensou {
namespace {

[[noreturn]] void reject(const char* what, double x, const char* expected) {
  throw std::invalid_argument(std::string(what) + " " + to_text(x) + ": expected " + expected);
}

// Where the machine has one, a type of wider exponent: products and quotients of any few doubles fit in.
using Wide = long double;

/// (1 − ν²)/E [1/Pa], zero for a rigid body.
Wide compliance(const ElasticBody& body) {
  if (!(body.modulus > 0)) reject("elastic modulus", body.modulus, "a number > 0 (infinite: rigid)");
  if (!(body.poisson > -1 && body.poisson <= 0.5)) reject("Poisson's ratio", body.poisson, "-1 < nu <= 0.5");
  return (1 - Wide{body.poisson}) * (1 + Wide{body.poisson}) / Wide{body.modulus};
}

Wide wide_relative_radius(const ElasticBody& a, const ElasticBody& b) {
  for (const double radius : {a.radius, b.radius}) {
    if (!(radius > 0 || (radius < 0 && std::isfinite(radius)))) {
      reject("radius", radius, "a number > 0 (infinite: plane) or a finite one < 0 (hollow)");
    }
  }
  double small = a.radius;
  double large = b.radius;
  if (std::abs(small) > std::abs(large)) std::swap(small, large);
  if (!(small > 0 && small + large != 0) || std::isinf(small)) {
    throw std::invalid_argument("radii " + to_text(a.radius) + " and " + to_text(b.radius) +
                                ": the bodies conform, there is no point contact");
  }
  if (std::isinf(large)) return small;
  // ρ_1 ρ_2/(ρ_1 + ρ_2): the sum is exact where it cancels (Sterbenz).
  return Wide{small} * Wide{large} / (Wide{small} + Wide{large});
}

}  // namespace

double effective_modulus(const ElasticBody& a, const ElasticBody& b) {
  return static_cast<double>(1 / (compliance(a) + compliance(b)));
}

double relative_radius(const ElasticBody& a, const ElasticBody& b) {
  return static_cast<double>(wide_relative_radius(a, b));
}

double hertz_contact_radius(const ElasticBody& a, const ElasticBody& b, double lambda_n) {
  if (!(lambda_n >= 0 && std::isfinite(lambda_n))) reject("normal force", lambda_n, "a finite number >= 0");
  const Wide softness = compliance(a) + compliance(b);
  return static_cast<double>(std::cbrt(Wide{0.75} * wide_relative_radius(a, b) * Wide{lambda_n} * softness));
}

}  // namespace contensou
