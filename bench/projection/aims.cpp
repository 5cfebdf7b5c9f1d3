#include "aims.hpp"

#include <cstdio>
#include <string>
#include <vector>

#include "common/stopwatch.hpp"
#include "contensou/ball/friction_ball.hpp"
#include "contensou/ball/smooth_plate.hpp"
#include "contensou/law/hertz.hpp"
#include "contensou/law/uniform.hpp"
#include "points.hpp"

namespace bench {
namespace {

constexpr std::size_t count = 1024;  // so few that a pass is short beside a time slice of the machine

/// Projections of all forces, one after the other.
template <class Law>
Task projections(Law law, const std::vector<Eigen::Vector3d>& forces, volatile double& sink, bool chain) {
  return {[ball = contensou::FrictionBall(contensou::SmoothPlate(law)), &forces, &sink, chain] {
            double sum = 0;
            for (const Eigen::Vector3d& force : forces) {
              const Eigen::Vector3d given(chain ? force[0] + 0 * sum : force[0], force[1], force[2]);
              sum += ball.project(given, 1).point[0];
            }
            sink = sum;
          },
          static_cast<double>(forces.size())};
}

/// Evaluations of the law at the forces' components, taken for speeds.
template <class Law>
Task evaluations(Law law, const std::vector<Eigen::Vector3d>& forces, volatile double& sink) {
  return {[law, &forces, &sink] {
            double sum = 0;
            for (const Eigen::Vector3d& force : forces) {
              const auto [xi, eta] = law.at(std::abs(force[0]), std::abs(force[2]));
              sum += xi + eta;
            }
            sink = sum;
          },
          static_cast<double>(forces.size())};
}

}  // namespace

contensou::Table measure_projection_aims(const std::filesystem::path& reference) {
  const auto forces = [&](const std::string& pressure, bool outside_only) {
    std::vector<Eigen::Vector3d> found;
    for (const Point& point : points(reference, pressure, count)) {
      if (!outside_only || point.place != Place::inside) found.push_back(point.force);
    }
    return found;
  };
  contensou::Table table{
      {"The exact projection on the friction ball against its aim; forces as in "
       "cost_projection.tsv.",
       "all: all 1024 forces; outside: those outside alone; chain: each waits for the one "
       "before. law: one evaluation of the law at random u.",
       "value: of a time the lower quartile over 41 interleaved rounds of the fastest pass of a round, as "
       "in cost_projection.tsv; of a ratio, taken",
       "within a round, the median; with the median and the quartiles"},
      {"quantity", "unit", "value", "aim", "reached", "lower_quartile", "median", "upper_quartile"},
      {}};
  for (const std::string pressure : {"uniform", "hertz"}) {
    const auto all = forces(pressure, false);
    const auto outside = forces(pressure, true);
    volatile double sink = 0;
    const auto tasks = [&](auto law) {
      const contensou::EllipsoidLaw ellipsoid(law.extent());
      return std::vector<Task>{projections(law, all, sink, false), projections(law, outside, sink, false),
                               projections(law, all, sink, true), evaluations(law, all, sink),
                               projections(ellipsoid, all, sink, false)};
    };
    const std::vector<Task> to_time =
        pressure == "uniform" ? tasks(contensou::UniformLaw{}) : tasks(contensou::HertzLaw{});
    const auto seconds = time_interleaved(to_time, {.rounds = 41, .visit = 2e-3, .budget = 10});

    const auto add = [&](const std::string& what, const std::string& unit, const std::vector<double>& values,
                         double aim) {
      const bool has_aim = aim > 0;
      const double value = quantile(values, has_aim ? 0.25 : 0.5);
      table.add({pressure + ", " + what, unit, value, has_aim ? "< " + contensou::to_text(aim) : "-",
                 std::string(!has_aim      ? "-"
                             : value < aim ? "yes"
                                           : "no"),
                 quantile(values, 0.25), quantile(values), quantile(values, 0.75)});
      std::printf("  %-8s %-36s %8.3g %s  aim %-6s %s\n", pressure.c_str(), what.c_str(), value, unit.c_str(),
                  table.rows.back()[3].c_str(), table.rows.back()[4].c_str());
    };
    const auto ratio = [&](std::size_t a, std::size_t b) {
      std::vector<double> of_round;
      for (std::size_t i = 0; i < seconds[a].size(); ++i) of_round.push_back(seconds[a][i] / seconds[b][i]);
      return of_round;
    };
    constexpr double aim = 300e-9;
    add("projection, all", "s", seconds[0], aim);
    add("projection, outside", "s", seconds[1], aim);
    add("projection, all, chain", "s", seconds[2], aim);
    add("projection / law", "1", ratio(0, 3), 0);
    add("projection / ellipsoid's projection", "1", ratio(0, 4), 0);
  }
  return table;
}

}  // namespace bench
