// reference_data/scenes/: what the outcomes of the shipped scenes should be, from the answers, and for the
// pile, which has none, from runs.   scene_references FOLDER [--pile]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "ball.hpp"
#include "contensou/output/table.hpp"
#include "free_body.hpp"
#include "motions/bounces.hpp"
#include "pile.hpp"
#include "pushed.hpp"
#include "shipped.hpp"
#include "slide_to_rest.hpp"

namespace verify::answers {
namespace {

using contensou::Table;
constexpr double g = 9.81;
/// The files run with a tolerance of 1e-10 and take at most some thousand steps: times ten, since what is
/// measured can be softer than what steps are controlled by.
constexpr double relative = 1e-6;

Table table_of(const std::string& scene, const std::string& source, const std::string& precision) {
  return {
      {"scenes/" + scene + ".toml: what its outcomes are; changes: as --set takes them, - for none",
       "units: SI", "generator: verify/scenes/references.cpp (" + source + ")",
       "command: scene_references reference_data/scenes",
       "precision: " + precision +
           "; allowed: what a run with the file's tolerance of 1e-10 may be off by, one tolerance a step"},
      {"changes", "outcome", "value", "allowed"},
      {}};
}

/// When a function, seen at multiples of `interval` and joined by lines, first passes `value`, as an outcome
/// is read.
double crossing(const std::vector<double>& values, double interval, double value) {
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double before = values[i - 1] - value, now = values[i] - value;
    if ((before < 0) != (now < 0)) return interval * (static_cast<double>(i - 1) + before / (before - now));
  }
  return std::nan("");
}

std::vector<double> multiples(double interval, double end) {
  std::vector<double> times;
  for (int i = 0; interval * i < end; ++i) times.push_back(interval * i);
  return times;
}

Table sliding_disc() {
  Table table = table_of("sliding_disc", "GSL, quadrature of Coulomb's law", "1e-11, ratio 1e-9");
  const double radius = 3.81e-2, a = 0.1 * g, v = 2, s = 30 * radius;
  const struct {
    const char* changes;
    double n, kappa;
  } cases[] = {{"-", 0, 0.5},
               {"contact.ice.pressure=hertz", 0.5, 0.5},
               {"contact.ice.pressure=power:1", 1, 0.5},
               {"body.puck.inertia=7.403211e-5", 0, 0.3}};
  for (const auto& [changes, n, kappa] : cases) {
    const SlideToRest answer(Patch(n), a, kappa, v, s);
    const double stop = answer.stopping_time();
    const std::vector<double> times = multiples(1e-2, stop);
    const double ratio = answer.at(times.back()).ratio();
    table.add({std::string(changes), std::string("stops"), stop, stop * relative});
    table.add({std::string(changes), std::string("path"), answer.slid(), (v + s) * stop * relative});
    table.add({std::string(changes), std::string("ratio"), ratio,
               (1 + ratio * ratio) * relative / (1 - times.back() / stop)});
  }
  return table;
}

Table polishing_machine() {
  Table table = table_of("polishing_machine", "GSL, quadrature of Coulomb's law", "1e-11");
  const double s = 18.3 * 0.21, push = 20.0 / 45, interval = 5e-2;
  const Pushed answer(Patch(0), 0.35 * g, s);
  const auto speeds = answer.speeds(push, 0, multiples(interval, 15.01));
  table.add({std::string("-"), std::string("speed"), speeds.back(), s * relative});
  table.add({std::string("-"), std::string("quarter"), crossing(speeds, interval, 0.25), 15 * relative});
  table.add({std::string("body.machine.spin=[0, 0, 0]"), std::string("speed"), 0.0, 1e-14});
  return table;
}

Table sidespin() {
  Table table = table_of("sidespin", "GSL, quadrature of Coulomb's law; the 2/7 law", "1e-11");
  const double r = 2.8575e-2, radius = 4e-3, mu = 0.2, v = 0.8;
  const SlideToRest answer(Patch(0.5), 3.5 * mu * g, kappa(r, radius), v, 60 * radius);
  std::vector<double> slips;
  for (const auto& point : answer.at(multiples(1e-2, 1))) slips.push_back(point.v);
  const double roll = rolling_speed(v, v);
  table.add({std::string("-"), std::string("rolls"), crossing(slips, 1e-2, 1e-3), 10 * relative});
  table.add({std::string("-"), std::string("spin_ends"), answer.stopping_time(), 5 * relative});
  table.add({std::string("-"), std::string("speed"), roll, v * relative});
  table.add({std::string("-"), std::string("path"), roll * 5 + 2 * answer.slid() / 7, 5 * v * relative});
  const double time = sliding_time(v, mu, g);
  table.add({std::string("contact.cloth.radius=0"), std::string("spin_ends"), time, relative});
  table.add({std::string("contact.cloth.radius=0"), std::string("path"), roll * 5 + v * time / 7,
             5 * v * relative});
  return table;
}

Table bouncing_ball() {
  Table table = table_of("bouncing_ball", "closed form", "rounding");
  const known_motions::Bounces answer(0.305, 0, g, 0.9);
  table.add({std::string("-"), std::string("first"), answer.impact_time(0), 1e-11});
  table.add({std::string("-"), std::string("tenth"), answer.impact_time(9), 1e-11});
  table.add({std::string("-"), std::string("rest"), answer.accumulation_time(), 1e-9});
  return table;
}

Table corner() {
  Table table = table_of("corner", "closed forms, friction by quadrature", "1e-12");
  const double drill = 100 / groove_about_vertical(Patch(0.5), 0.03, 2e-3, 0.3, g),
               roll = 100 / groove_about_its_axis(0.03, 0.3, g);
  table.add({std::string("-"), std::string("stops"), drill, drill * relative});
  table.add({std::string("-"), std::string("strays"), 0.0, 3 * relative});
  table.add({std::string("body.ball.spin=[100, 0, 0]"), std::string("stops"), roll, roll * relative});
  table.add({std::string("body.ball.spin=[100, 0, 0]"), std::string("strays"), 0.0, 3 * relative});
  table.add({std::string("body.ball.spin=[0, 0, 0]"), std::string("strays"), 0.0, 1e-14});
  return table;
}

Table free_body() {
  Table table = table_of("free_body", "Jacobi's elliptic functions", "1e-12");
  const book::Motion motion = book::thrown();
  std::vector<double> tilts;
  for (const double t : multiples(book::interval, 10.005)) tilts.push_back(book::tilt(motion, t));
  // The file's tolerance is 1e-12, and errors grow with the sensitivity of the motion.
  const double grown =
      1000 * 1e-12 * (1 + book::spread([](const book::Motion& off) { return book::whole(off, 10); }));
  table.add(
      {std::string("-"), std::string("turns_over"), crossing(tilts, book::interval, std::acos(0.0)), grown});
  table.add({std::string("-"), std::string("last_tilt"), tilts.back(), grown});
  return table;
}

Table tippe_top() {
  Table table = table_of("tippe_top_bodies", "reference_data/motions, quadruple precision", "1e-13");
  const std::filesystem::path motions = CONTENSOU_REFERENCE_DATA "/motions";
  const Table events = contensou::read_table(motions / "tippe_top_hertz_5e-4_events.tsv");
  const Table curve = contensou::read_table(motions / "tippe_top_hertz_5e-4.tsv");
  // A tolerance a millisecond in 16 components, in one direction for 80 ms:
  // tests/figures/compare_motions.cpp.
  const double step = 1e-10 * std::sqrt(16.0 * 80);
  const auto spreads = events.numbers("t_spread"), times = events.numbers("t");
  const auto kinds = events.texts("event"), contacts = events.texts("contact");
  const auto first = [&](const std::string& contact) {
    std::size_t i = 0;
    while (kinds.at(i) != "close" || contacts.at(i) != contact) ++i;
    return i;
  };
  for (const auto& [name, contact] : {std::pair("stick_touches", "tip"), std::pair("body_returns", "body")}) {
    const std::size_t i = first(contact);
    table.add({std::string("-"), std::string(name), times[i], step * (1 + spreads[i])});
  }
  table.add({std::string("-"), std::string("last_tilt"), curve.numbers("theta").back(),
             step * (4 + curve.numbers("theta_spread").back())});
  return table;
}

/// Mean and standard deviation over seeds that are not the file's.
Table marbles() {
  constexpr int seeds = 5, first = 2;
  Table table{{"scenes/pile.toml: mean and standard deviation of its outcomes over seeds 2 to 6", "units: SI",
               "generator: verify/scenes/references.cpp, from runs: there is no answer",
               "command: scene_references reference_data/scenes --pile",
               "precision: of the mean, the deviation/√" + std::to_string(seeds)},
              {"outcome", "mean", "deviation", "least", "most"},
              {}};
  std::vector<Shipped> runs;
  for (int seed = first; seed < first + seeds; ++seed) {
    runs.emplace_back("pile", std::vector<std::string>{"balls.marbles.seed=" + std::to_string(seed)});
    std::printf("seed %d: potential %.6g J, height %.6g m, kinetic %.3g J\n", seed,
                runs.back().measured("potential"), runs.back().measured("height"),
                runs.back().measured("kinetic"));
    std::fflush(stdout);
  }
  for (const char* name : {"potential", "height", "kinetic"}) {
    double mean = 0, square = 0, least = HUGE_VAL, most = -HUGE_VAL;
    for (const Shipped& run : runs) {
      const double value = run.measured(name);
      mean += value / seeds;
      least = std::min(least, value);
      most = std::max(most, value);
    }
    for (const Shipped& run : runs) square += std::pow(run.measured(name) - mean, 2) / (seeds - 1);
    table.add({std::string(name), mean, std::sqrt(square), least, most});
  }
  return table;
}

void write(const std::filesystem::path& folder) {
  contensou::write_table(sliding_disc(), folder / "sliding_disc.tsv");
  contensou::write_table(polishing_machine(), folder / "polishing_machine.tsv");
  contensou::write_table(sidespin(), folder / "sidespin.tsv");
  contensou::write_table(bouncing_ball(), folder / "bouncing_ball.tsv");
  contensou::write_table(corner(), folder / "corner.tsv");
  contensou::write_table(free_body(), folder / "free_body.tsv");
  contensou::write_table(tippe_top(), folder / "tippe_top_bodies.tsv");
}

}  // namespace
}  // namespace verify::answers

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3 || (argc == 3 && std::string(argv[2]) != "--pile")) {
    std::fprintf(stderr, "usage: scene_references FOLDER [--pile]\n");
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[1];
    if (argc == 2) verify::answers::write(folder);
    if (argc == 3) contensou::write_table(verify::answers::marbles(), folder / "pile.tsv");
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "scene_references: %s\n", error.what());
    return 1;
  }
}
