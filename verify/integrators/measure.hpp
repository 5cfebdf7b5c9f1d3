#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contensou/integrate/motion.hpp"

namespace verify::integrators {

/// All of them, in the order of all tables.
inline constexpr contensou::Method schemes[] = {
    contensou::Method::moreau_printed,  contensou::Method::rk4_printed,     contensou::Method::moreau,
    contensou::Method::moreau_implicit, contensou::Method::moreau_adaptive, contensou::Method::rk4,
    contensou::Method::event_driven};

/// A run to t_end with a step [s] or, for methods that choose their steps, a tolerance.
struct Run {
  bool refused = false;  ///< the method does not do such a motion: `why`
  std::string why;
  contensou::State end;
  contensou::RunReport report;
  bool finished() const { return !refused && report.status == contensou::RunStatus::finished; }
};
Run run(const contensou::MechanicalSystem& system, const contensou::State& start, double t_end,
        contensou::Method method, double setting, const contensou::Observer& observer = {},
        double output_interval = 0);

/// Largest of the errors of the coordinates in their scales and of the velocities per `rate` [1/s] of the
/// scale of length (the first three: of all systems here those along the axes) or of 1.
double difference(const contensou::MechanicalSystem& system, double rate, const contensou::State& a,
                  const contensou::State& b);

/// When the last contact closed, or impacts accumulated; nothing where none did.
std::optional<double> last_closing(const std::vector<contensou::Event>& events);

double energy(const contensou::MechanicalSystem& system, const contensou::State& state);
double dissipated(const contensou::RunReport& report);

/// Slope of ln y over ln x, least squares, over the y > floor. NaN where fewer than two are.
double slope(const std::vector<double>& x, const std::vector<double>& y, double floor);

/// "0.123" with so many digits.
std::string text(double value, int digits = 3);

}  // namespace verify::integrators
