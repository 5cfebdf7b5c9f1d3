#include "rivals/elliptic.hpp"

#include <gsl/gsl_sf_ellint.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <cmath>
#include <numbers>

namespace rivals {
namespace {

using std::numbers::pi;

// A formula that breaks down shall return what floating point makes of it, not throw.
namespace bp = boost::math::policies;
using Silent = bp::policy<bp::domain_error<bp::ignore_error>, bp::overflow_error<bp::ignore_error>>;
using SilentDouble = bp::policy<bp::domain_error<bp::ignore_error>, bp::overflow_error<bp::ignore_error>,
                                bp::promote_double<false>>;

struct BoostDouble {
  static double k(double k) { return boost::math::ellint_1(k, SilentDouble()); }
  static double e(double k) { return boost::math::ellint_2(k, SilentDouble()); }
};

struct BoostPromoted {
  static double k(double k) { return boost::math::ellint_1(k, Silent()); }
  static double e(double k) { return boost::math::ellint_2(k, Silent()); }
};

struct Gsl {
  // The _e functions report an error by their status; the short forms would end the program.
  static double k(double k) {
    gsl_sf_result result{};
    return gsl_sf_ellint_Kcomp_e(k, GSL_PREC_DOUBLE, &result) == 0 ? result.val : std::nan("");
  }
  static double e(double k) {
    if (k == 1) return 1;  // where GSL reports a domain error
    gsl_sf_result result{};
    return gsl_sf_ellint_Ecomp_e(k, GSL_PREC_DOUBLE, &result) == 0 ? result.val : std::nan("");
  }
};

template <class Integrals>
contensou::Reduced textbook(double u) {
  const double u2 = u * u;
  const double length = std::hypot(u, 1.0);
  if (u <= 1) {
    const double e = Integrals::e(u);
    const double mk = u == 1 ? 0 : (1 - u2) * Integrals::k(u);
    return {4 / (9 * pi) * ((7 + u2) * e - 4 * mk) / length, 4 / (3 * pi * u) * ((1 + u2) * e - mk),
            4 / (9 * pi) * ((4 - 2 * u2) * e - mk)};
  }
  const double e = Integrals::e(1 / u);
  const double mk = (u2 - 1) * Integrals::k(1 / u);
  return {4 / (9 * pi) * (u * (u2 + 7) * e - (u2 + 3) * mk / u) / length, 4 / (3 * pi) * ((u2 + 1) * e - mk),
          4 / (9 * pi) * (u * (4 - 2 * u2) * e + (2 * u2 - 3) * mk / u)};
}

template <class Integrals>
double textbook_second(double u) {
  const double u2 = u * u;
  if (u <= 1) {
    const double mk = u == 1 ? 0 : (1 - u2) * Integrals::k(u);
    return 4 / (3 * pi * u2) * ((2 * u2 - 1) * Integrals::e(u) + mk);
  }
  return 4 / (3 * pi * u) * ((2 * u2 - 1) * Integrals::e(1 / u) - 2 * (u2 - 1) * Integrals::k(1 / u));
}

/// B, D and 1 − m of the parameter m = w², w = min(u, 1/u) < 1, given 1 − m.
struct CarlsonIntegrals {
  double mc;
  double d = boost::math::ellint_rd(0.0, mc, 1.0, SilentDouble()) / 3;
  double b = mc * boost::math::ellint_rd(0.0, 1.0, mc, SilentDouble()) / 3;
};

contensou::Reduced carlson(double u) {
  if (u == 1) return {32 / (9 * pi * std::numbers::sqrt2), 8 / (3 * pi), 8 / (9 * pi)};
  if (u < 1) {
    const double m = u * u;
    const CarlsonIntegrals i{(1 - u) * (1 + u)};
    return {4 / (9 * pi) * ((3 + 5 * m) * i.b + i.mc * (3 + m) * i.d) / std::sqrt(1 + m),
            4 * u / (3 * pi) * (2 * i.b + i.mc * i.d),
            4 / (9 * pi) * ((3 - m) * i.b + i.mc * (3 - 2 * m) * i.d)};
  }
  const double w = 1 / u;
  const double m = w * w;
  const CarlsonIntegrals i{(u - 1) * (u + 1) / (u * u)};
  const double c = (i.d - i.b) / m;
  const double xi = 4 / (3 * pi) * (2 * i.b + i.mc * i.d);
  const double eta = 4 / (9 * pi) * w * (2 * i.b + i.mc * c);
  return {(xi + w * eta) / std::sqrt(1 + m), xi, eta};
}

double carlson_second(double u) {
  if (u == 1) return 4 / (3 * pi);
  if (u < 1) {
    const CarlsonIntegrals i{(1 - u) * (1 + u)};
    return 4 / (3 * pi) * (i.b + 2 * i.mc * i.d);
  }
  const CarlsonIntegrals i{(u - 1) * (u + 1) / (u * u)};
  const double c = (i.d - i.b) * (u * u);
  return 4 / (3 * pi) * (i.d - c) / (u * u * u);
}

}  // namespace

const ClosedForm textbook_boost{textbook<BoostDouble>, textbook_second<BoostDouble>};
const ClosedForm textbook_boost_promoted{textbook<BoostPromoted>, textbook_second<BoostPromoted>};
const ClosedForm textbook_gsl{textbook<Gsl>, textbook_second<Gsl>};
const ClosedForm carlson_boost{carlson, carlson_second};

double one_k_and_one_e(double k) { return BoostDouble::k(k) + BoostDouble::e(k); }

}  // namespace rivals
