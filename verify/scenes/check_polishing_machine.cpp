#include <cmath>
#include <string>

#include "checks.hpp"
#include "pushed.hpp"
#include "shipped.hpp"
#include "worst.hpp"

namespace verify::answers {
namespace {

// The file's data.
constexpr double m = 45, radius = 0.21, mu = 0.35, g = 9.81, spin = 18.3;
constexpr double weight = mu * m * g;

using contensou::to_text;

Shipped push(double force, double duration, std::vector<std::string> more = {}) {
  more.insert(more.end(), {accurate, "load.push.force=[" + to_text(force) + ", 0, 0]",
                           "scene.duration=" + to_text(duration)});
  return Shipped("polishing_machine", more);
}

}  // namespace

void check_polishing_machine(Sheet& sheet) {
  const Pushed answer(Patch(0), mu * g, spin * radius);
  const std::string file = "polishing_machine";
  for (const double force : {1.0, 20.0, 100.0, 150.0}) {
    const std::string what = "pushed with " + to_text(force) + " N of μmg = 154.5 N",
                      id = "machine." + to_text(force) + '.';
    const double end = answer.terminal_speed(force / m), rate = answer.rate(force / m);
    // e^−35 of the approach is left.
    const Shipped run = push(force, 35 / rate + 30);
    const double share = 10 * run.steps_error() + oracle_error;
    sheet.compare({id + "speed", file, what + ": speed in the end [m/s]", "ξ(v/(ωR)) = F/(μmg)", end,
                   run.last("machine.vx"), 0, share * (end + spin * radius)});
    Worst worst;
    const std::vector<double> times = run.times_until(5 / rate);
    const std::vector<double> speeds = answer.speeds(force / m, 0, times);
    for (std::size_t i = 0; i < times.size(); ++i) worst.add(std::abs(run.at("machine.vx", i) - speeds[i]));
    sheet.add({id + "approach", file, what + ": speed on the way there, largest error [m/s]",
               "GSL on v' = F/m − μg ξ(v/(ωR))", 0, worst.value(), worst.value(),
               share * (end + spin * radius)});
  }
  // ξ = u − u³/8 + ...: v ωR-viscous to u²/8.
  const Shipped slow = push(1, 60);
  const double viscous = spin * radius / weight, u = 1 / weight;
  sheet.compare({"machine.viscous", file,
                 "the force of 1 N over the speed it keeps up, relative to μmg/(ωR): 40.2 N s/m",
                 "ξ'(0) = 1, next term u²/8", 1, viscous / slow.last("machine.vx"), 0, u * u / 4 + 1e-9});
  const Shipped held = push(150, 5, {"body.machine.spin=[0, 0, 0]"});
  sheet.compare({"machine.held", file, "pushed with 150 N with the brush at rest: speed after 5 s [m/s]",
                 "150 N < μmg", 0, held.last("machine.vx"), 0, 1e-14});
  const Shipped gone = push(200, 5, {"body.machine.spin=[0, 0, 0]"});
  sheet.compare({"machine.slides", file, "pushed with 200 N with the brush at rest: speed after 5 s [m/s]",
                 "(F/m − μg) t", 5 * (200 / m - mu * g), gone.last("machine.vx"), 0,
                 10 * gone.steps_error() + oracle_error});
  const Shipped shipped = Shipped(file, {accurate});
  sheet.add({"machine.energy", file,
             "energy: what load and motor put in, friction takes: imbalance of the books, relative",
             "E_0 + supplied = E_1 + dissipated", 0, shipped.outcome().energy.relative(),
             std::abs(shipped.outcome().energy.relative()), 10 * shipped.steps_error()});
}

}  // namespace verify::answers
