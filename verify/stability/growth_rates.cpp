#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "checks.hpp"
#include "contensou/output/table.hpp"
#include "simulate.hpp"
#include "worst.hpp"

namespace verify::stability {
namespace {

constexpr double start_spin = 180;  // LG03 5.4
constexpr std::array radii = {1e-5, 2e-5, 5e-5, 1e-4, 1.5e-4, 2e-4, 3e-4, 5e-4, 1e-3, 2e-3};

/// Without drilling torque nothing changes with time; what is left is (3/8)u² of the damping with u up to
/// some 1e-3 at the end, and the integration's 1e-9.
constexpr double steady = 1e-6;
/// With it the rate to first order in ω̇ misses some (ω̇/ω)²/|λ − λ'|, and the part `steady`.
constexpr double second_order = 4;

const char* place(std::size_t contact) { return contact == 0 ? "trivial" : "inverted"; }

/// The largest real part of (5.31) over R, by the roots.
double growth_531(double radius) {
  Setting s = paper_top(0);
  s.radius = radius;
  return contensou::eigenvalues(
             contensou::characteristic_cubic(position(s), start_spin, damping(s, start_spin)))[0]
      .real();
}

/// What the slope of ln θ, least squares, makes of a rate that changes with the spin: its mean with the
/// weight (3/4)(1 − x²) over x = −1 ... 1, by the two points ±1/√5 to third order.
double mean_rate(const Setting& s, const Growth& g, std::size_t mode) {
  const double apart = g.spin_change / 2 / std::sqrt(5.0);
  return (slow_modes(s, g.spin - apart)[mode].rate + slow_modes(s, g.spin + apart)[mode].rate) / 2;
}

void fastest(Record& record) {
  // Golden section; the real part has one maximum between R → 0 and R → ∞, where it vanishes.
  double low = std::log(1e-5), high = std::log(2e-3);
  const double golden = (std::sqrt(5.0) - 1) / 2;
  while (high - low > 1e-6) {
    const double x = high - golden * (high - low), y = low + golden * (high - low);
    (growth_531(std::exp(x)) < growth_531(std::exp(y)) ? low : high) =
        growth_531(std::exp(x)) < growth_531(std::exp(y)) ? x : y;
  }
  const double best = std::exp(low);
  int falls = 0;
  for (std::size_t k = 1; k < radii.size(); ++k) falls += growth_531(radii[k]) < growth_531(radii[k - 1]);
  record.add(
      Claim{"stability.radius.monotone", "LG03 5.5, on Fig. 12",
            "decreasing R decreases the real part of the growing eigenvalue, trivial position, 180 rad/s: "
            "neighbours among R = 1e-5 ... 2e-3 m where it does not; the largest is at R = " +
                contensou::to_text(std::round(best * 1e7) / 1e7) + " m",
            0, static_cast<double>(falls), static_cast<double>(falls), 0, false});
  Worst below;
  for (int k = 0; k < 40; ++k) {
    const double radius = best * std::pow(0.8, k);
    below.add(growth_531(0.8 * radius) / growth_531(radius));
  }
  record.add(Claim{"stability.radius.below", "LG03 5.5, on Fig. 12",
                   "below the radius of fastest growth it does: largest ratio of real parts at 0.8 R and R",
                   1, below.value(), below.value(), 1, true});
}

/// Growth of the fastest growing mode with drilling torque.
double fastest_rate(const Setting& s, double spin) {
  double rate = -std::numeric_limits<double>::infinity();
  for (const SlowMode& mode : slow_modes(s, spin)) rate = std::max(rate, mode.rate);
  return rate;
}

void critical_spins_with_drilling(Record& record) {
  // On the body, below the critical spin of 21.7 rad/s.
  int cases = 0, grow = 0;
  double rate_at_20 = 0;
  for (const double radius : {1e-4, 5e-4}) {
    for (const double spin : {10.0, 15.0, 20.0}) {
      Setting s = paper_top(0);
      s.radius = radius;
      auto all = slow_modes(s, spin);
      const auto leading = std::max_element(
          all.begin(), all.end(), [](const SlowMode& a, const SlowMode& b) { return a.rate < b.rate; });
      const Growth g = growth(s, spin, *leading);
      ++cases;
      grow += g.rate > 0;
      rate_at_20 = g.rate;
    }
  }
  record.add(Claim{"stability.drilling.trivial", "LG03 5.5, Region IV",
                   "below the critical spin the inclination on the body decays: simulations of " +
                       std::to_string(cases) +
                       " with drilling torque in which it grows; growth at 20 rad/s, R = 5e-4 m: " +
                       contensou::to_text(std::round(rate_at_20 * 1e4) / 1e4) + " 1/s",
                   0, static_cast<double>(grow), static_cast<double>(grow), 0, false});
  // On the tip, between where rolling itself is unstable, (5.37), and where all decays.
  const auto crossing = [](double radius) {
    Setting s = paper_top(1);
    s.radius = radius;
    double low = 87, high = 150;
    if (!(fastest_rate(s, low) > 0) || !(fastest_rate(s, high) < 0)) return std::nan("");
    for (int k = 0; k < 30; ++k) {
      const double middle = (low + high) / 2;
      (fastest_rate(s, middle) > 0 ? low : high) = middle;
    }
    return low;
  };
  const double small = crossing(1e-5), larger = crossing(1e-4);
  const double without = contensou::critical_spin(position(paper_top(1))).value();
  // Rates are R(c + O(R)) with changes by R/R' where the rate has its largest value, R' of about 2e-4 m or
  // more.
  record.add(
      Claim{"stability.drilling.critical", "LG03 5.5, with the drilling torque",
            "for small R the spin at which the inclination on the tip begins to grow does not depend on R: "
            "1e-5 and 1e-4 m [rad/s]",
            small, larger, std::abs(larger / small - 1), 0.05, true});
  record.add(Claim{"stability.drilling.critical.printed", "LG03 (5.35)",
                   "it is that of (5.35), within a hundredth [rad/s]", without, small,
                   std::abs(small / without - 1), 0.01, false});
}

}  // namespace

void check_growth(const std::filesystem::path& folder, Record& record) {
  contensou::Table table{
      {"Rates of growth of the inclination of the tippe-top of LG03 5.4 spinning upright at 180 rad/s, Hertz "
       "pressure; 1/s, SI units.",
       "position: trivial (on the body), inverted (on the tip); mode: nutation (the faster one), precession; "
       "frequency: imaginary part of the root of (5.31).",
       "rate_531: its real part. simulated_531: slope of ln(theta) in the nonlinear top without drilling "
       "torque.",
       "rate_frozen: real part with the drilling torque, at the momentary spin. rate_slow: and with the "
       "change of "
       "amplitude while the spin falls, first order. simulated: slope of ln(theta) in the nonlinear top, at "
       "spin_simulated on average; expected: rate_slow, averaged in the same way."},
      {"position", "mode", "radius", "spin_rate", "frequency", "rate_531", "simulated_531", "rate_frozen",
       "rate_slow", "simulated", "spin_simulated", "expected"},
      {}};
  Worst without, with, ignored;
  double least_normal = 1;
  bool finished = true;
  for (const std::size_t contact : {std::size_t{0}, std::size_t{1}}) {
    contensou::Table precession{{}, table.columns, {}};  // its rows stand below those of the nutation
    for (const double radius : radii) {
      Setting full = paper_top(contact);
      full.radius = radius;
      Setting steady_spin = full;
      steady_spin.drilling = false;
      const auto roots = contensou::eigenvalues(
          contensou::characteristic_cubic(position(full), start_spin, damping(full, start_spin)));
      const auto plain = slow_modes(steady_spin, start_spin);
      const auto slowing = slow_modes(full, start_spin);
      const double relative_rate = spin_rate(full, start_spin) / start_spin;
      // The third root belongs to the slip, which dies out within milliseconds.
      const bool first_is_faster = std::abs(roots[0].imag()) > std::abs(roots[1].imag());
      for (std::size_t k = 0; k < 2; ++k) {
        const Growth left_out = growth(steady_spin, start_spin, plain[k]);
        const Growth real = growth(full, start_spin, slowing[k]);
        const double expected = mean_rate(full, real, k);
        without.add(std::abs(left_out.rate / roots[k].real() - 1));
        const double bound =
            second_order * relative_rate * relative_rate / slowing[k].nearest + steady * std::abs(expected);
        with.add(std::abs(real.rate - expected) / bound);
        ignored.add(std::abs(real.rate - roots[k].real()) / std::abs(roots[k].real()));
        least_normal = std::min({least_normal, left_out.watch.least_normal, real.watch.least_normal});
        finished = finished && left_out.watch.finished && real.watch.finished;
        const bool faster = (k == 0) == first_is_faster;
        (faster ? table : precession)
            .add({std::string(place(contact)), std::string(faster ? "nutation" : "precession"), radius,
                  spin_rate(full, start_spin), roots[k].imag(), roots[k].real(), left_out.rate,
                  slowing[k].eigenvalue.real(), slowing[k].rate, real.rate, real.spin, expected});
      }
    }
    table.rows.insert(table.rows.end(), precession.rows.begin(), precession.rows.end());
  }
  contensou::write_table(table, folder / "stability_growth.tsv");
  record.add(
      Claim{"stability.growth.531", "LG03 (5.31)",
            "rates of growth of the nonlinear top without drilling torque, both positions, R = 1e-5 ... "
            "2e-3 m, are the real parts of the roots: largest relative error",
            0, without.value(), without.value(), steady, true});
  record.add(
      Claim{"stability.growth.drilling", "LG03 (5.22), with the drilling torque",
            "rates of growth of the nonlinear top are those of the linear one with drilling torque and "
            "falling spin: largest error over its bound",
            0, with.value(), with.value(), 1, true});
  record.add(Claim{"stability.growth.drilling_left_out", "LG03 (5.22)",
                   "the drilling torque, which (5.22) leaves out, changes the rates of growth by less than a "
                   "tenth: largest relative change",
                   0, ignored.value(), ignored.value(), 0.1, false});
  record.add(Claim{"stability.growth.closed", "LG03 5.5",
                   "the contact stays closed, simulations reach their end: least lambda_N/(mg)", 1,
                   least_normal, finished ? 1 - least_normal : 1, 1e-3, true});
  fastest(record);
  critical_spins_with_drilling(record);
}

}  // namespace verify::stability
