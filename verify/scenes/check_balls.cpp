#include <cmath>
#include <string>
#include <vector>

#include "ball.hpp"
#include "checks.hpp"
#include "motions/bounces.hpp"
#include "shipped.hpp"
#include "slide_to_rest.hpp"
#include "worst.hpp"

namespace verify::answers {
namespace {

constexpr double g = 9.81;

double share(const Shipped& run) { return 10 * run.steps_error() + oracle_error; }

}  // namespace

void check_sidespin(Sheet& sheet) {
  const double r = 2.8575e-2, radius = 4e-3, mu = 0.2, v = 0.8, spin = 60;  // the file's
  const std::string file = "sidespin", by = "GSL on γ' = −7/2 μg ξ(γ/s), s' = −5/2 μg (R/r)² η(γ/s)";
  const SlideToRest answer(Patch(0.5), 3.5 * mu * g, kappa(r, radius), v, spin * radius);
  const Shipped run(file, {accurate});
  const double stop = answer.stopping_time();
  sheet.compare({"sidespin.speed", file, "speed of rolling [m/s]", "the 2/7 law", rolling_speed(v, v),
                 run.measured("speed"), 0, v * share(run)});
  sheet.compare({"sidespin.stop", file, "the spin ends at [s]", by, stop, run.measured("spin_ends"), 0,
                 stop * share(run)});
  sheet.compare({"sidespin.path", file, "path in 5 s [m]", "5/7 v t + 2/7 ∫γ dt",
                 rolling_speed(v, v) * 5 + 2 * answer.slid() / 7, run.measured("path"), 0,
                 5 * v * share(run)});
  Worst slip, turn;
  const std::vector<SlideToRest::Point> points = answer.at(run.times_until(0.99 * stop));
  for (std::size_t i = 0; i < points.size(); ++i) {
    slip.add(std::abs(run.at("slip_cloth", i) - points[i].v));
    turn.add(std::abs(run.at("ball.wz", i) - points[i].s / radius));
  }
  sheet.add({"sidespin.slip", file, "slip all the way, largest error [m/s]", by, 0, slip.value(),
             slip.value(), v * share(run)});
  sheet.add({"sidespin.spin", file, "spin all the way, largest error [rad/s]", by, 0, turn.value(),
             turn.value(), v / radius * share(run)});
  // Rolling: the torque is η(0), but for the slip of order e^−... that is left.
  const double first = 1, last = 4, rate = mu * g * radius * Patch(0.5).torque_at_rest() / (0.4 * r * r);
  double from = 0, to = 0;
  for (std::size_t i = 0; i < run.rows(); ++i) {
    if (std::abs(run.at("t", i) - first) < 1e-9) from = run.at("ball.wz", i);
    if (std::abs(run.at("t", i) - last) < 1e-9) to = run.at("ball.wz", i);
  }
  sheet.compare({"sidespin.drilling", file, "rolling, the spin falls at [rad/s²]", "5/2 μg R/r² η(0)", rate,
                 (from - to) / (last - first), 0, rate * share(run) * 10});
  const Shipped point(file, {accurate, "contact.cloth.radius=0"});
  sheet.compare({"sidespin.coulomb", file, "a point contact instead: it rolls after [s]", "2v/(7μg)",
                 sliding_time(v, mu, g), point.measured("spin_ends"), 0, share(point)});
}

void check_bouncing_ball(Sheet& sheet) {
  const double h = 0.305, restitution = 0.9;  // the file's
  const std::string file = "bouncing_ball";
  const double r = 0.02;
  const known_motions::Bounces answer(h, 0, g, restitution);
  const Shipped run(file, {accurate});
  // Rounding of each bounce, and a geometric series of it.
  const double bound = 1e-12 / (1 - restitution);
  // Flights shorter than 5e-6 √(r/g) are summed. That is with a height rounded to 2^-52 r and a speed of gτ/2
  // an error of the last impacts; the ratio ε² of pairs of flights, from two of them, carries it into the sum
  // by 1/(1 − ε²)².
  const double shortest = 5e-6 * std::sqrt(r / g), last = 0x1p-52 * r / (g * shortest / 2);
  const double summed = bound + 4 * last / std::pow(1 - restitution * restitution, 2);
  sheet.compare({"bounce.first", file, "first impact [s]", "√(2h/g)", answer.impact_time(0),
                 run.measured("first"), 0, bound});
  sheet.compare({"bounce.tenth", file, "tenth impact [s]", "t1 (1 + 2ε + ... + 2ε⁹)", answer.impact_time(9),
                 run.measured("tenth"), 0, bound});
  sheet.compare({"bounce.rest", file, "rest, after infinitely many impacts [s]", "t1 (1 + ε)/(1 − ε)",
                 answer.accumulation_time(), run.measured("rest"), 0, summed});
  Worst height;
  for (std::size_t i = 0; i < run.rows(); ++i)
    height.add(std::abs(run.at("ball.z", i) - 0.02 - answer.at(run.at("t", i)).z));
  sheet.add({"bounce.height", file, "height all the way, largest error [m]", "parabolas", 0, height.value(),
             height.value(), std::sqrt(2 * g * h) * bound});
  const auto& books = run.outcome().energy;
  sheet.compare({"bounce.energy", file, "energy that impacts take, in mgh", "all", 1,
                 books.dissipated / (2.7e-3 * g * h), 0, 1e-11});
}

void check_corner(Sheet& sheet) {
  const double r = 0.03, radius = 2e-3, mu = 0.3, spin = 100;  // the file's
  const std::string file = "corner";
  const double drill = spin / groove_about_vertical(Patch(0.5), r, radius, mu, g);
  const Shipped run(file, {accurate});
  sheet.compare({"corner.stop", file, "spinning about the vertical, it stops at [s]",
                 "ω/(5/2 (μg/r²)(r ξ + R η)), u = r/R", drill, run.measured("stops"), 0, drill * share(run)});
  Worst ratio;
  for (std::size_t i = 0; i < run.rows() && run.at("t", i) < 0.99 * drill; ++i)
    ratio.add(std::abs(run.at("ratio_left", i) * radius / r - 1));
  sheet.add({"corner.ratio", file, "γ_T/(ω_N R) over r/R, largest deviation from 1", "constant", 1,
             1 + ratio.value(), ratio.value(), 100 * share(run)});
  sheet.compare({"corner.strays", file, "largest speed of its centre [m/s]", "spins in place", 0,
                 run.measured("strays"), 0, r * spin * share(run)});
  const auto& both = run.report().dissipated;
  sheet.compare({"corner.shares", file, "work of friction on the left wall over that on the right",
                 "symmetry", 1, both[0].total() / both[1].total(), 0, share(run)});

  const double roll = spin / groove_about_its_axis(r, mu, g);
  const Shipped rolled(file, {accurate, "body.ball.spin=[100, 0, 0]"});
  sheet.compare({"corner.groove.stop", file, "spinning about the groove, it stops at [s]",
                 "ω r (1 + μ²)/((5/√2) μg)", roll, rolled.measured("stops"), 0, roll * share(rolled)});
  const auto& uneven = rolled.report().dissipated;
  sheet.compare({"corner.groove.shares", file, "work of friction on the left wall over that on the right",
                 "(1 + μ)/(1 − μ)", (1 + mu) / (1 - mu), uneven[0].total() / uneven[1].total(), 0,
                 2 * share(rolled)});
  sheet.compare({"corner.groove.strays", file, "largest speed of its centre [m/s]", "spins in place", 0,
                 rolled.measured("strays"), 0, r * spin * share(rolled)});

  const Shipped rests(file, {accurate, "body.ball.spin=[0, 0, 0]"});
  sheet.compare({"corner.rests", file, "without spin it rests: largest speed [m/s]", "0", 0,
                 rests.measured("strays"), 0, 1e-14});

  for (const std::string method : {"moreau", "rk4"}) {
    const double step = 1e-4;
    const Shipped stepped(
        file, {"integrator.method=" + method, "integrator.step=1e-4", "integrator.solver_tolerance=1e-12"});
    double stop = 0;
    for (std::size_t i = 0; i < stepped.rows(); ++i) {
      if (std::abs(stepped.at("ball.wz", i)) > 1e-6) stop = stepped.at("t", i);
    }
    // Rows are 10 ms apart; the spin at the last of them before it stops says when it would.
    sheet.compare({"corner.stop." + method, file,
                   "by " + method + ", steps of 1e-4 s: within the rows around [s]", "as above", drill,
                   stop + 0.005, 0, 0.005 + 2 * step});
  }
}

}  // namespace verify::answers
