#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "contensou/integrate/method_limits.hpp"
#include "contensou/integrate/schemes.hpp"
#include "contensou/text/number.hpp"

namespace contensou {
namespace {

struct Entry {
  Method method;
  const char* name;
  bool fixed_step;
  Scheme* run;
};

/// It needs to know bodies, not rows: run_nscd() is called by who has them.
RunReport refuse_nscd(const MechanicalSystem&, State&, double, const IntegratorOptions&, const Observer&) {
  throw std::invalid_argument("integrator: nscd is for scenes of bodies, expected another method");
}

constexpr std::array<Entry, 8> entries{{
    {Method::moreau_printed, "moreau_printed", true, run_moreau_printed},
    {Method::rk4_printed, "rk4_printed", true, run_rk4_printed},
    {Method::moreau, "moreau", true, run_moreau},
    {Method::moreau_implicit, "moreau_implicit", true, run_moreau_implicit},
    {Method::moreau_adaptive, "moreau_adaptive", false, run_moreau_adaptive},
    {Method::rk4, "rk4", true, run_rk4},
    {Method::event_driven, "event_driven", false, run_event_driven},
    {Method::nscd, "nscd", true, refuse_nscd},
}};

const Entry& entry(Method method) {
  for (const Entry& e : entries) {
    if (e.method == method) return e;
  }
  throw std::invalid_argument("integrator: not a method");
}

[[noreturn]] void reject(const char* what, double value, const char* expected) {
  throw std::invalid_argument(std::string("integrator: ") + what + " " + to_text(value) + ", expected " +
                              expected);
}

void require_positive(const char* what, double value) {
  if (!(value > 0 && std::isfinite(value))) reject(what, value, "a number > 0");
}

void require_valid(const IntegratorOptions& options) {
  if (has_fixed_step(options.method) || options.method == Method::moreau_adaptive)
    require_positive("step", options.step);
  // rk4: of its implicit steps' iterations.
  if (!has_fixed_step(options.method) || options.method == Method::rk4)
    require_positive("tolerance", options.tolerance);
  require_positive("solver_tolerance", options.solver_tolerance);
  if (options.r) require_positive("r", *options.r);
  if (options.fidelity) require_positive("fidelity", *options.fidelity);
  if (!(options.output_interval > 0)) reject("output_interval", options.output_interval, "a number > 0");
}

/// Contacts this deep are closed: as an integration at its tolerance may leave them.
double penetration_limit(const MechanicalSystem& system) { return 1e-9 * system.length_scale(); }

void require_valid(const MechanicalSystem& system, const State& state, double t_end) {
  if (state.q.size() != system.coordinates() || state.u.size() != system.velocities())
    throw std::invalid_argument("integrator: the state is of another size than the system");
  if (!state.q.allFinite() || !state.u.allFinite() || !std::isfinite(state.t))
    throw std::invalid_argument("integrator: the state has a number that is not finite");
  if (!(t_end >= state.t && std::isfinite(t_end)))
    reject("t_end", t_end, ("a number >= " + to_text(state.t)).c_str());
  for (std::size_t i = 0; i < system.contacts().size(); ++i) {
    const double gap = system.gap(i, state.t, state.q);
    if (!(gap >= -penetration_limit(system)))
      throw std::invalid_argument("contact " + system.contacts()[i].name + ": gap " + to_text(gap) +
                                  " m at the start, expected one that is not negative");
  }
}

}  // namespace

Method method_named(std::string_view text) {
  std::string names;
  for (const Entry& e : entries) {
    if (e.name == text) return e.method;
    names += std::string(names.empty() ? "" : ", ") + e.name;
  }
  throw std::invalid_argument("method " + std::string(text) + ": expected one of " + names);
}

const char* name(Method method) { return entry(method).name; }
bool has_fixed_step(Method method) { return entry(method).fixed_step; }

const char* name(EventKind kind) {
  switch (kind) {
    case EventKind::close:
      return "close";
    case EventKind::open:
      return "open";
    case EventKind::accumulation:
      return "accumulation";
    case EventKind::stick:
      return "stick";
    case EventKind::slip:
      return "slip";
    case EventKind::spin:
      return "spin";
  }
  return "";
}

const char* name(RunStatus status) {
  switch (status) {
    case RunStatus::finished:
      return "finished";
    case RunStatus::step_limit:
      return "step_limit";
    case RunStatus::solver_failed:
      return "solver_failed";
    case RunStatus::step_too_small:
      return "step_too_small";
    case RunStatus::not_finite:
      return "not_finite";
  }
  return "";
}

RunReport integrate(const MechanicalSystem& system, State& state, double t_end,
                    const IntegratorOptions& options, const Observer& observer) {
  const Entry& chosen = entry(options.method);
  require_valid(options);
  require_valid(system, state, t_end);
  require_possible(system, options);
  constexpr double countable = 9007199254740992;  // 2^53
  if (std::isfinite(options.output_interval) && (t_end - state.t) / options.output_interval > countable)
    reject("output_interval", options.output_interval, "one that can be counted to t_end");
  system.restore(state.q);
  return chosen.run(system, state, t_end, options, observer);
}

}  // namespace contensou
