#include "oracle.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace verify::ledger {

Real pi() { return boost::math::constants::pi<Real>(); }

Real integrate(const Function& f, const Real& a, const Real& b, const Real& tolerance) {
  static boost::math::quadrature::tanh_sinh<Real> rule(10);
  const Real half = (b - a) / 2;
  const Real middle = a + half;
  return half *
         rule.integrate([&](const Real& x) { return f(middle + half * x); }, Real(-1), Real(1), tolerance);
}

double integrate_double(const std::function<double(double)>& f, double a, double b) {
  static boost::math::quadrature::tanh_sinh<double> rule;
  return rule.integrate(f, a, b, 1e-13);
}

Exact exact(Pressure pressure, const Real& u) {
  const bool uniform = pressure == Pressure::uniform;
  Real xi;
  Real eta;
  if (u <= 1) {
    // h² = (1 − u²) + u² c², without cancellation at u = 1
    const auto h2 = [&](const Real& c) -> Real { return (1 - u) * (1 + u) + u * u * c * c; };
    const auto moment = [&](const std::function<Real(Real, Real)>& g) {
      return integrate(
          [&](const Real& t) {
            const Real c = sin(t);  // θ = π/2 − t
            return g(c, h2(c));
          },
          0, pi() / 2);
    };
    if (uniform) {
      xi = 4 * u / pi() * moment([](Real c, Real h) -> Real { return c * c * sqrt(h); });
      eta = 4 / (3 * pi()) * moment([](Real, Real h) -> Real { return h * sqrt(h); });
    } else {
      xi = 3 * u / 2 * moment([](Real c, Real h) -> Real { return c * c * h; });
      eta = Real(3) / 8 * moment([](Real, Real h) -> Real { return h * h; });
    }
  } else {
    const Real w = 1 / u;
    const auto moment = [&](const std::function<Real(Real, Real)>& g) {
      return integrate(
          [&](const Real& t) {
            const Real h = sin(t);  // ψ = π/2 − t
            return g(sqrt((1 - w) * (1 + w) + w * w * h * h), h);
          },
          0, pi() / 2);
    };
    if (uniform) {
      xi = 4 / pi() * moment([](Real c, Real h) -> Real { return c * h * h; });
      eta = 4 / (3 * pi()) * w * moment([](Real c, Real h) -> Real { return h * h * h * h / c; });
    } else {
      xi = Real(3) / 2 * moment([](Real c, Real h) -> Real { return c * h * h * h; });
      eta = Real(3) / 8 * w * moment([](Real c, Real h) -> Real { return h * h * h * h * h / c; });
    }
  }
  return {u * xi + eta, xi, eta};
}

double Contact::u() const { return std::abs(v / (omega * radius)); }

std::vector<Contact> contacts() {
  std::vector<Contact> all;
  for (const double v : {0.4, 1.3, 2.9, -1.3, -2.9}) {
    for (const double omega : {2.9, -2.9}) {
      Contact c;
      c.v = v;
      c.omega = omega;
      all.push_back(c);
    }
  }
  return all;
}

std::vector<Contact> positive_contacts() {
  std::vector<Contact> all = contacts();
  std::erase_if(all, [](const Contact& c) { return c.v < 0 || c.omega < 0; });
  return all;
}

double pressure_at(Pressure pressure, const Contact& contact, double rho) {
  const double mean = contact.lambda_n / (std::numbers::pi * contact.radius * contact.radius);
  if (pressure == Pressure::uniform) return mean;
  const double x = rho / contact.radius;
  return 1.5 * mean * std::sqrt(std::max(0.0, (1 - x) * (1 + x)));
}

double over_disc(const Contact& contact, const std::function<double(double, double)>& g) {
  const double quarter = std::numbers::pi / 2;
  const auto circle = [&](double rho) {
    const auto ring = [&](double phi) { return g(rho, phi); };
    return rho * (integrate_double(ring, -quarter, quarter) + integrate_double(ring, quarter, 3 * quarter));
  };
  const double critical = std::abs(contact.v / contact.omega);
  if (critical >= contact.radius || critical == 0) return integrate_double(circle, 0, contact.radius);
  return integrate_double(circle, 0, critical) + integrate_double(circle, critical, contact.radius);
}

double potential_by_definition(Pressure pressure, const Contact& c) {
  return over_disc(c, [&](double rho, double phi) {
    const double w1 = c.v - c.omega * rho * std::sin(phi);
    const double w2 = c.omega * rho * std::cos(phi);
    return c.mu * pressure_at(pressure, c, rho) * std::hypot(w1, w2);
  });
}

Trial relative(const Real& expected, const Real& obtained) {
  return {static_cast<double>(expected), static_cast<double>(obtained),
          static_cast<double>(abs((obtained - expected) / expected))};
}

Trial absolute(const Real& expected, const Real& obtained) {
  return {static_cast<double>(expected), static_cast<double>(obtained),
          static_cast<double>(abs(obtained - expected))};
}

Trial worst(const std::vector<Trial>& trials) {
  if (trials.empty()) throw std::logic_error("ledger: no trials");
  // A NaN is worse than any number.
  return *std::max_element(trials.begin(), trials.end(), [](const Trial& a, const Trial& b) {
    return !std::isnan(a.error) && (std::isnan(b.error) || a.error < b.error);
  });
}

Trial order(const Function& remainder, int claimed) {
  const Real measured = log10(abs(remainder(ratio(1, 100)) / remainder(ratio(1, 1000))));
  return absolute(claimed, measured);
}

Trial at_most_zero(const Real& g) {
  return {0, static_cast<double>(g), static_cast<double>(g > 0 ? g : Real(0))};
}

std::string text(const Real& x, int digits) {
  std::ostringstream out;
  out.precision(digits);
  out << x;
  return out.str();
}

}  // namespace verify::ledger
