#include "contensou/law/radial.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "contensou/text/number.hpp"

namespace contensou {
namespace {

constexpr double two_over_pi = 2 / std::numbers::pi;
constexpr double small_pressure = 1e-150;
constexpr double large_pressure = 1e150;

/// Complete elliptic integrals of parameter m = 1 − mc in
/// the forms that lose no digits: B, D and E = B + mc D.
double elliptic_b(double mc) { return mc == 0 ? 1.0 : mc * boost::math::ellint_rd(0.0, 1.0, mc) / 3; }
double elliptic_d(double mc) { return boost::math::ellint_rd(0.0, mc, 1.0) / 3; }
double elliptic_e(double mc) { return mc == 0 ? 1.0 : elliptic_b(mc) + mc * elliptic_d(mc); }

/// Tanh-sinh quadrature over [a, b]; its nodes crowd towards
/// the ends, so they are placed from the nearer end.
double integrate(const std::function<double(double)>& integrand, double a, double b) {
  constexpr double tolerance = 1e-12;  // of the estimate, which lags a level behind the result
  thread_local boost::math::quadrature::tanh_sinh<double>
      rule;  // makes its nodes on first use, for each thread
  const double half = (b - a) / 2;
  const double first = std::nextafter(a, b);  // the ends themselves may be singular
  const double last = std::nextafter(b, a);
  return half * rule.integrate(
                    [&](double t, double to_end) {
                      const double distance = half * std::abs(to_end);
                      return integrand(std::clamp(t < 0 ? a + distance : b - distance, first, last));
                    },
                    -1.0, 1.0, tolerance);
}

}  // namespace

RadialPressure tabulated_pressure(std::vector<double> rho, std::vector<double> sigma) {
  if (rho.size() != sigma.size() || rho.size() < 2) {
    throw std::invalid_argument("tabulated pressure: " + std::to_string(rho.size()) + " radii and " +
                                std::to_string(sigma.size()) +
                                " pressures, expected the same count, at least 2");
  }
  for (std::size_t i = 0; i < rho.size(); ++i) {
    const std::string entry = "tabulated pressure, entry " + std::to_string(i + 1) + ": ";
    if (!(sigma[i] >= 0 && std::isfinite(sigma[i]))) {
      throw std::invalid_argument(entry + "sigma = " + to_text(sigma[i]) + ", expected a finite number >= 0");
    }
    if (!(i == 0 ? rho[i] == 0 : rho[i] > rho[i - 1])) {
      throw std::invalid_argument(entry + "rho = " + to_text(rho[i]) +
                                  ", expected radii that begin at 0 and increase");
    }
  }
  if (rho.back() != 1) {
    throw std::invalid_argument("tabulated pressure: the last rho is " + to_text(rho.back()) +
                                ", expected 1");
  }
  std::vector<double> breaks(rho.begin() + 1, rho.end() - 1);
  auto interpolate = [rho = std::move(rho), sigma = std::move(sigma)](double x) {
    const auto after = std::upper_bound(rho.begin() + 1, rho.end() - 1, x);
    const auto i = static_cast<std::size_t>(after - rho.begin());
    const double t = (x - rho[i - 1]) / (rho[i] - rho[i - 1]);
    return sigma[i - 1] + t * (sigma[i] - sigma[i - 1]);
  };
  return {std::move(interpolate), std::move(breaks), true};
}

RadialLaw::RadialLaw(RadialPressure pressure) : pressure_(std::move(pressure)) {
  for (const double b : pressure_.breaks) {
    if (!(b > 0 && b < 1)) {
      throw std::invalid_argument("radial pressure: break at " + to_text(b) +
                                  ", expected a radius in (0, 1)");
    }
  }
  pressure_.breaks.push_back(0);
  pressure_.breaks.push_back(1);
  std::sort(pressure_.breaks.begin(), pressure_.breaks.end());
  const auto checked = [this](double rho) {
    const double sigma = pressure_.sigma(rho);
    if (!(sigma >= 0 && std::isfinite(sigma))) {
      throw std::invalid_argument("radial pressure: sigma(" + to_text(rho) + ") = " + to_text(sigma) +
                                  ", expected a finite number >= 0");
    }
    return sigma;
  };
  // Only the shape counts: a pressure near either end of the range of doubles is moved to its middle.
  double largest = 0;
  integral(0, [&](double rho) {
    largest = std::max(largest, checked(rho));
    return rho;
  });
  if (largest > 0 && (largest < small_pressure || largest > large_pressure)) {
    pressure_.sigma = [sigma = std::move(pressure_.sigma), exponent = -std::ilogb(largest)](double rho) {
      return std::ldexp(sigma(rho), exponent);
    };
  }
  load_ = integral(0, [&](double rho) { return checked(rho) * rho; });
  if (!(load_ > 0 && std::isfinite(load_))) {
    throw std::invalid_argument("radial pressure: its integral over the patch is " + to_text(load_) +
                                ", expected a finite number > 0");
  }
  eta_max_ = inner({0, 1}, Quantity::torque);
}

double RadialLaw::integral(double split, const std::function<double(double)>& integrand) const {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < pressure_.breaks.size(); ++i) {
    const double a = pressure_.breaks[i];
    const double b = pressure_.breaks[i + 1];
    // A ring is singular at R* only. From there at least half the piece's width away, Gauss's error falls
    // like (2 + √3)^(−2·15), 7e-18.
    const double distance = std::max(a - split, split - b);
    if (pressure_.linear && distance >= (b - a) / 2) {
      sum += boost::math::quadrature::gauss<double, 15>::integrate(integrand, a, b);
    } else if (a < split && split < b) {
      sum += integrate(integrand, a, split) + integrate(integrand, split, b);
    } else {
      sum += integrate(integrand, a, b);
    }
  }
  return sum;
}

// A ring of radius ρ turns at its own ratio a = u/ρ and carries the share σ ρ dρ of the load; its torque
// counts with its lever ρ. Rings outside R* (ρ > u) spin, those inside slide.
double RadialLaw::inner(SlipRatio ratio, Quantity quantity) const {
  // Where 1/u would overflow, the bounded forms are at their limit u → 0 to far more digits than there are.
  const double u = ratio.x == 0 ? 0 : std::max(ratio.x, 1e-300);
  const auto ring = [&](double rho) {
    const double load = pressure_.sigma(rho) * rho;
    const bool spins = rho > u;
    const double larger = spins ? rho : u;
    const double mc = (std::abs(rho - u) / larger) * ((rho + u) / larger);
    switch (quantity) {
      case Quantity::force:
        return load * (spins ? elliptic_b(mc) / rho : elliptic_e(mc) / u);
      case Quantity::torque:
        return load * rho * (spins ? elliptic_e(mc) : rho / u * elliptic_b(mc));
      case Quantity::second:
        break;
    }
    return mc == 0 ? 0 : load * elliptic_d(mc) * (spins ? 1 / rho : rho / u * (rho / u) / u);
  };
  return two_over_pi / load_ * integral(u, ring);
}

double RadialLaw::outer(SlipRatio ratio, Quantity quantity) const {
  const double w = ratio.x;
  const auto ring = [&](double rho) {
    const double load = pressure_.sigma(rho) * rho;
    const double mc = (ratio.gap + w * (1 - rho)) * (1 + w * rho);
    switch (quantity) {
      case Quantity::force:
        return load * elliptic_e(mc);
      case Quantity::torque:
        return load * rho * rho * elliptic_b(mc);
      case Quantity::second:
        break;
    }
    return mc == 0 ? 0 : load * rho * rho * elliptic_d(mc);
  };
  return two_over_pi / load_ * integral(1, ring);
}

Friction RadialLaw::at(double v, double s) const {
  const auto form = [this](auto side) {
    return [this, side](SlipRatio x) {
      return BoundedForm{(this->*side)(x, Quantity::force), (this->*side)(x, Quantity::torque), 0};
    };
  };
  return friction_from(v, s, form(&RadialLaw::inner), form(&RadialLaw::outer));
}

Curvature RadialLaw::curvature(double v, double s) const {
  return curvature_from(
      v, s, [this](SlipRatio u) { return inner(u, Quantity::second); },
      [this](SlipRatio w) { return outer(w, Quantity::second); });
}

CompiledLaw RadialLaw::compile(double tolerance) const {
  const auto form = [this](auto side) {
    return [this, side](SlipRatio x) {
      return BoundedForm{(this->*side)(x, Quantity::force), (this->*side)(x, Quantity::torque),
                         (this->*side)(x, Quantity::second)};
    };
  };
  return CompiledLaw(form(&RadialLaw::inner), form(&RadialLaw::outer), extent(), tolerance, pressure_.breaks);
}

}  // namespace contensou
