#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "checks.hpp"
#include "contensou/output/table.hpp"
#include "measure.hpp"
#include "motions.hpp"

namespace verify::integrators {
namespace {

using contensou::Method;

/// What theory says an error does as the step (or the tolerance) shrinks.
struct Forecast {
  enum class Kind {
    order,    ///< goes like (step or tolerance)^order, within the margin
    exact,    ///< rounding, or the solver's tolerance
    bounded,  ///< without an order, at most `bound`
    within,   ///< without an order, at most `bound` times the tolerance
    refused,  ///< the scheme does not do such a motion
    open,     ///< not foretold: measured
  };
  Kind kind;
  double order = 0;
  double margin = 0;
  double bound = 0;
};

// Margins: four halvings from ωΔt = 0.07 leave a few per cent of Δt in the slope of a smooth error; step
// controls that reject and round make their slopes rougher; in impacts, where an impact falls in its step
// changes the error by up to its own size, of which the worst of 6 or 8 is taken.
constexpr double smooth = 0.25, controlled = 0.3, struck = 0.45;

constexpr Forecast order(double p, double margin = smooth) { return {Forecast::Kind::order, p, margin}; }
constexpr Forecast by_tolerance(double p) { return {Forecast::Kind::order, p, controlled}; }
constexpr Forecast exact{Forecast::Kind::exact};
constexpr Forecast at_most(double bound) { return {Forecast::Kind::bounded, 0, 0, bound}; }
constexpr Forecast refused{Forecast::Kind::refused};
constexpr Forecast open{Forecast::Kind::open};
/// What an inelastic impact leaves of the velocity, +v/3 to +v/9, does not depend on the step.
constexpr Forecast never = order(0, struck);

struct Phase {
  std::string_view name;
  std::string_view quantity;
  std::array<Forecast, std::size(schemes)> of;  ///< in the order of `schemes`
};

// moreau_printed: h(q_M, u_A) is of first order, friction is that of the end's velocity; where h depends on q
//   alone and without friction Störmer's scheme, of second order; constant accelerations are exact, but for
//   the rounding that opens a contact for one step, gΔt². A contact that landed stays as deep as vΔt: bounces
//   that rise less, with √Δt or slower, are not seen, and an accumulation ends too early by as much.
// rk4_printed: each stage's acceleration is that of a state Δt₂/2 (q) and Δt₂ (friction) later: first order.
//   Where contacts stick its errors grow fivefold in each step until friction's bounds end it, and landed
//   bodies hop on: not foretold.
// moreau: SDIRK2 in smooth phases; a landing found by linear interpolation, O(Δt²). In accumulations bounces
//   shorter than a step are left out, and the end comes O(Δt) too early; the momentum given is that of the
//   whole series, so that what moves on afterwards is of second order.
// moreau_adaptive: third-order local error: Δt like tolerance^⅓, errors like tolerance^⅔. Parabolas have no
//   error, and the floor of the step goes like tolerance^⅓: so does the end of the bouncing.
// event_driven: error per step: errors like the tolerance. Where slip comes to rest steps are bounded by the
//   time left, and few: errors of a few tolerances or less. The bounces of an accumulation that are summed are
//   as high as errors; their impulses, friction with them, are those of their limit: nothing is missing where
//   all else is constant (the ball), and on the top what changes meanwhile times their height.
constexpr Forecast two_thirds = by_tolerance(2.0 / 3);
constexpr Forecast one = by_tolerance(1);
constexpr Forecast few{Forecast::Kind::within, 0, 0, 30};
constexpr Forecast one_free_step = at_most(9.81 * 4e-3 * 4e-3);
constexpr double impacts_of_series = 0.75;  // their number in the series changes with the step
constexpr Phase phases[] = {
    {"flight", "state", {order(1), order(1), order(2), order(1), two_thirds, order(4), one}},
    {"oscillation", "state", {order(2), order(1), order(2), order(1), two_thirds, order(4), one}},
    {"slip_top", "state", {order(1), order(1), order(2), order(1), two_thirds, order(4), one}},
    {"slip_disc", "state", {order(1), order(1), order(2), order(1), two_thirds, order(4), few}},
    {"slip_point", "state", {order(1), order(1), order(2), order(1), two_thirds, order(4), few}},
    {"roll_top", "state", {order(1), open, order(2), order(1), two_thirds, order(4), one}},
    {"roll_ball", "state", {one_free_step, open, exact, order(1), exact, exact, exact}},
    {"stick_block", "state", {exact, open, exact, exact, exact, exact, exact}},
    {"impact_point",
     "state",
     {order(1, struck), never, order(2, struck), order(1, struck), open, exact, exact}},
    {"impact_top",
     "state",
     {order(1, struck), never, order(2, struck), order(1, struck), order(2.0 / 3, struck), order(4, struck),
      one}},
    {"bounce_point", "state", {refused, refused, order(2, struck), order(1, struck), open, exact, exact}},
    {"bounce_top",
     "state",
     {refused, refused, order(2, struck), order(1, struck), order(2.0 / 3, struck), order(4, struck), one}},
    {"accumulation_ball",
     "state",
     {refused, refused, order(2, struck), order(1, struck), open, exact, exact}},
    {"accumulation_ball",
     "time",
     {refused, refused, order(1, struck), order(1, struck), order(1.0 / 3, controlled), exact, exact}},
    {"accumulation_top",
     "state",
     {order(1, struck), open, order(2, struck), order(1, struck), order(2.0 / 3, struck),
      order(4, impacts_of_series), order(1, struck)}},
    {"accumulation_top",
     "time",
     {order(0.5, struck), open, order(1, struck), order(1, struck), order(2.0 / 3, struck),
      order(4, impacts_of_series), order(1, struck)}},
};

/// In the motions' units: far above rounding of a thousand steps, and above solver_tolerance [N s] by masses
/// of 1 kg and more, a thousand times.
constexpr double rounding = 1e-9;
/// Errors below are not counted: of the references, and of rounding.
constexpr double least_floor = 1e-12;
constexpr double above_doubt = 10;

const std::vector<double> loose{1e-4, 1e-5, 1e-6, 1e-7, 1e-8};
const std::vector<double> tight{1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11};

const std::vector<double>& settings(const Motion& motion, Method method) {
  if (method == Method::rk4 || (contensou::has_fixed_step(method) && motion.fine_steps.empty()))
    return motion.steps;
  if (contensou::has_fixed_step(method)) return motion.fine_steps;
  return method == Method::moreau_adaptive ? loose : tight;
}

struct Measured {
  std::vector<double> settings, state, time;
  std::vector<double> mean_step;  ///< over all paths [s]
  std::vector<std::string> status;
  bool refused = false, finished = true;
};

Measured measure(const Motion& motion, Method method) {
  Measured m;
  m.settings = settings(motion, method);
  for (const double setting : m.settings) {
    double state = 0, time = 0, duration = 0, steps = 0;
    std::string status = "finished";
    for (const Motion::Path& path : motion.paths) {
      const Run r = run(*motion.system, path.start, path.end.t, method, setting);
      m.refused = m.refused || r.refused;
      if (!r.finished()) {
        m.finished = false;
        status = r.refused ? "refused" : name(r.report.status);
        state = time = std::nan("");
        break;
      }
      duration += path.end.t - path.start.t;
      steps += static_cast<double>(r.report.steps);
      state = std::max(state, difference(*motion.system, motion.rate, r.end, path.end));
      if (motion.timed)
        time = std::max(time, std::abs(last_closing(r.report.events).value_or(INFINITY) - path.last_closing));
    }
    m.state.push_back(state);
    m.time.push_back(time);
    m.status.push_back(status);
    m.mean_step.push_back(duration / steps);
  }
  return m;
}

struct Judged {
  double order = 0, low = 0, high = 0;
  std::string verdict;
};

double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

Judged judge(const Forecast& forecast, const Measured& m, const std::vector<double>& errors, double floor,
             const std::string& id, const std::string& words, Record& record) {
  const double nothing = std::nan("");
  if (forecast.kind == Forecast::Kind::refused || m.refused) {
    const bool right = m.refused && forecast.kind == Forecast::Kind::refused;
    record.add(Claim{id, "LG03 Tables 1, 2", words + ": refused, since the letter has no restitution", 1,
                     right ? 1.0 : 0.0, right ? 0.0 : 1.0, 0, true});
    return {nothing, nothing, nothing, "refused"};
  }
  if (forecast.kind == Forecast::Kind::exact || forecast.kind == Forecast::Kind::bounded) {
    const bool exactly = forecast.kind == Forecast::Kind::exact;
    const double bound = exactly ? rounding : forecast.bound;
    // Where the step or tolerance counts, the finest is what is bounded.
    const double worst = !m.finished ? nothing : exactly ? largest(errors) : errors.back();
    record.add(Claim{id, "integrators",
                     words + (exactly ? ": exact, largest error" : ": error at the finest"), 0, worst, worst,
                     bound, true});
    return {nothing, nothing, nothing, !(worst <= bound) ? "fails" : exactly ? "exact" : "bounded"};
  }
  if (forecast.kind == Forecast::Kind::within) {
    std::vector<double> ratios;
    for (std::size_t k = 0; k < errors.size(); ++k)
      ratios.push_back(std::max(0.0, errors[k] - floor) / m.settings[k]);
    const double worst = m.finished ? largest(ratios) : nothing;
    record.add(Claim{id, "integrators", words + ": largest error over its tolerance", 0, worst, worst,
                     forecast.bound, true});
    return {nothing, nothing, nothing, worst <= forecast.bound ? "bounded" : "fails"};
  }
  const double p = m.finished ? slope(m.settings, errors, floor) : nothing;
  if (forecast.kind == Forecast::Kind::open) return {p, nothing, nothing, m.finished ? "measured" : "fails"};
  const double off = std::abs(p - forecast.order);
  record.add(Claim{id, "integrators",
                   words + (contensou::has_fixed_step(contensou::method_named(id.substr(id.rfind('.') + 1)))
                                ? ": order in the step"
                                : ": order in the tolerance"),
                   forecast.order, p, off, forecast.margin, true});
  return {p, forecast.order - forecast.margin, forecast.order + forecast.margin,
          off <= forecast.margin ? "holds" : "fails"};
}

}  // namespace

void check_orders(const std::filesystem::path& folder, Record& record, Findings& found) {
  contensou::Table orders{
      {"Orders of the integrators, measured: slope of ln(error) over ln(step), least squares; over "
       "ln(tolerance) for moreau_adaptive and event_driven.",
       "error of `state`: largest of the coordinates' in their scales and the velocities' in theirs, at the "
       "motion's end, worst of its paths; of `time` [s]: when the last contact closed or impacts "
       "accumulated.",
       "step: in s; tolerance: dimensionless. low, high: what theory says, for reasons given in "
       "verify/integrators/orders.cpp. Errors below `floor` (references, rounding) are not counted."},
      {"phase", "scheme", "quantity", "coarsest", "error_coarsest", "finest", "error_finest", "floor",
       "order", "low", "high", "verdict"},
      {}};
  contensou::Table errors{
      {"The errors behind integrator_orders.tsv. setting: step [s] or tolerance; mean_step [s]: "
       "also of methods that choose their steps."},
      {"phase", "scheme", "quantity", "setting", "mean_step", "error", "status"},
      {}};
  for (const Motion& motion : all_motions()) {
    record.add(Claim{"integrators.reference." + motion.phase, "verify/integrators",
                     motion.what + ": the reference (" + motion.reference + ") and its check differ by", 0,
                     motion.doubt, motion.doubt, 1e-9, true});
    if (motion.timed) {
      record.add(Claim{"integrators.reference." + motion.phase + ".time", "verify/integrators",
                       motion.what + ": the times of its end differ by [s]", 0, motion.doubt_of_time,
                       motion.doubt_of_time, 1e-9, true});
    }
    for (std::size_t s = 0; s < std::size(schemes); ++s) {
      const std::string scheme = contensou::name(schemes[s]);
      const Measured m = measure(motion, schemes[s]);
      for (const Phase& phase : phases) {
        if (phase.name != motion.phase) continue;
        const bool state = phase.quantity == "state";
        const double floor =
            std::max(least_floor, above_doubt * (state ? motion.doubt : motion.doubt_of_time));
        const std::vector<double>& e = state ? m.state : m.time;
        const std::string middle = motion.phase + (state ? "" : "_time");
        const Judged j = judge(phase.of[s], m, e, floor, "integrators.order." + middle + "." + scheme,
                               scheme + ", " + motion.what + (state ? "" : ": when it ends"), record);
        found["order." + middle + "." + scheme] = j.order;
        found["error." + middle + "." + scheme] = e.back();
        orders.add({motion.phase, scheme, std::string(phase.quantity), m.settings.front(), e.front(),
                    m.settings.back(), e.back(), floor, j.order, j.low, j.high, j.verdict});
        for (std::size_t k = 0; k < e.size(); ++k) {
          errors.add({motion.phase, scheme, std::string(phase.quantity), m.settings[k], m.mean_step[k], e[k],
                      m.status[k]});
        }
      }
    }
  }
  contensou::write_table(orders, folder / "integrator_orders.tsv");
  contensou::write_table(errors, folder / "integrator_errors.tsv");
}

}  // namespace verify::integrators
