#include "methods.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <variant>

#include "contensou/ball/catalogue.hpp"
#include "contensou/ball/friction_disk.hpp"
#include "contensou/law/catalogue.hpp"

namespace bench {
namespace {

using Force = Eigen::Vector3d;

struct Nearest {
  Force point;
  int iterations;
};

/// For a function Nearest(const Force&).
template <class F>
ProjectionMethod method(std::string name, std::string setting, std::string pressure, F nearest_to) {
  return {std::move(name),
          std::move(setting),
          std::move(pressure),
          [nearest_to](Forces forces, std::span<Force> nearest) {
            for (std::size_t i = 0; i < forces.size(); ++i) nearest[i] = nearest_to(forces[i]).point;
          },
          [nearest_to](Forces forces) {
            double nothing = 0;  // 0 · result: no change to the force, but known only when the result is
            for (const Force& force : forces) {
              const Force waiting(force[0] + nothing, force[1], force[2]);
              nothing = 0 * nearest_to(waiting).point[0];
            }
            return nothing;
          },
          [nearest_to](Forces forces) {
            double sum = 0;
            int most = 0;
            for (const Force& force : forces) {
              const int iterations = nearest_to(force).iterations;
              sum += iterations;
              most = std::max(most, iterations);
            }
            return std::pair(sum / static_cast<double>(forces.size()), most);
          }};
}

/// A ball of the catalogue. Shared, because some are large and all are only read.
ProjectionMethod ball_method(std::string name, std::string setting, const std::string& pressure,
                             const std::string& model) {
  return std::visit(
      [&](auto ball) {
        return method(std::move(name), std::move(setting), pressure,
                      [shared = std::make_shared<const decltype(ball)>(std::move(ball))](const Force& force) {
                        const auto q = shared->project(force, 1);
                        return Nearest{q.point, q.iterations};
                      });
      },
      contensou::make_ball(pressure, model));
}

/// What one would do with the law and nothing else: bisection in the angle of the normal.
ProjectionMethod bisection(const std::string& pressure, int steps) {
  return std::visit(
      [&](auto law) {
        return method(
            "bisection", std::to_string(steps) + " steps", pressure,
            [steps, shared = std::make_shared<const decltype(law)>(std::move(law))](const Force& force) {
              const double t = std::hypot(force[0], force[1]);
              const double tau = std::abs(force[2]);
              double low = 0;
              double high = 1;
              contensou::Friction x{};
              for (int i = 0; i < steps; ++i) {
                const double v = (low + high) / 2;
                x = shared->at(v, 1 - v);
                if (t <= x.xi && tau <= x.eta) return Nearest{force, i + 1};
                ((t - x.xi) * (1 - v) > (tau - x.eta) * v ? low : high) = v;
              }
              const double turned = t > 0 ? x.xi / t : 0;
              return Nearest{{force[0] * turned, force[1] * turned, std::copysign(x.eta, force[2])}, steps};
            });
      },
      contensou::make_law(pressure, "exact"));
}

/// What a point contact has instead: Coulomb's disk, two rows, no torque.
ProjectionMethod point_contact(const std::string& pressure) {
  return method("coulomb_disk", "2 rows", pressure, [](const Force& force) {
    const auto q = contensou::FrictionDisk{}.project(force.head<2>(), 1);
    return Nearest{{q.point[0], q.point[1], 0}, q.iterations};
  });
}

}  // namespace

std::vector<ProjectionMethod> projection_methods() {
  std::vector<ProjectionMethod> methods;
  for (const std::string pressure : {"uniform", "hertz", "power:1"}) {
    const auto add = [&](const std::string& name, const std::string& setting, const std::string& model) {
      methods.push_back(ball_method(name, setting, pressure, model));
    };
    methods.push_back(point_contact(pressure));
    add("disk", "3 rows", "disk");
    add("decoupled", "same semi-axes", "decoupled");
    add("ellipsoid", "same semi-axes", "ellipsoid");
    if (pressure == "uniform") add("printed", "(2.18)", "printed");
    if (pressure == "hertz") add("printed", "(3.19)", "printed");
    add("series", "3 terms, corrected", "corrected");
    for (const int terms : {5, 10, 20, 40}) {
      add("series", std::to_string(terms) + " terms", "series:" + std::to_string(terms));
    }
    for (const int cells : {4, 8, 16, 32, 64, 128, 256}) {
      add("table", std::to_string(cells) + " cells", "table:" + std::to_string(cells));
    }
    for (const int steps : {8, 16, 32, 52}) methods.push_back(bisection(pressure, steps));
    add("exact", "this library", "exact");
  }
  return methods;
}

}  // namespace bench
