#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contensou/integrate/mechanical_system.hpp"

namespace contensou {

/// The integrators. Names are those of `integrator.method` in a scene.
enum class Method {
  moreau_printed,   ///< LG03 Table 1 to the letter (moreau_printed.hpp)
  rk4_printed,      ///< LG03 Table 2 to the letter (rk4_printed.hpp)
  moreau,           ///< event-capturing, contacts on velocity level, second order in smooth phases
  moreau_implicit,  ///< the fully implicit (Euler) version of Moreau's method, LG03 Section 6
  moreau_adaptive,  ///< `moreau` with error estimate and automatic step size
  rk4,              ///< fixed step, fourth order between located transitions (hybrid_run.hpp)
  event_driven,     ///< adaptive, high order, located transitions: the reference (hybrid_run.hpp)
  nscd,  ///< nonsmooth contact dynamics: many bodies, contacts found as they go (granular/nscd.hpp)
};

/// "rk4" and so on; throws std::invalid_argument with the list of names for another one.
Method method_named(std::string_view name);
const char* name(Method method);
/// Whether the method is told its step size (else its tolerance).
bool has_fixed_step(Method method);

enum class ContactMode {
  open,
  slip,   ///< closed, γ_F ≠ 0 (frictionless: closed)
  stick,  ///< closed, γ_F = 0
};

struct State {
  double t;
  Eigen::VectorXd q;
  Eigen::VectorXd u;
};

/// What an observer is shown: the motion at one time, at multiples of the output interval and at the end.
struct Sample {
  double t;
  const Eigen::VectorXd& q;
  const Eigen::VectorXd& u;
  const std::vector<ContactMode>& modes;
};

enum class EventKind {
  close,
  open,
  accumulation,  ///< of impacts
  stick,
  slip,
  spin,  ///< the spin of a slipping contact changes its sign
};
const char* name(EventKind kind);

struct Event {
  double t;
  EventKind kind;
  std::size_t contact;
};

/// What friction and impacts took out of the motion, by contact [J].
struct Dissipation {
  double sliding = 0;   ///< −∫λ_T·γ_T dt between impacts
  double drilling = 0;  ///< −∫λ_τ γ_τ dt between impacts
  double impact = 0;    ///< −½Λ·(γ⁺ + γ⁻), all rows of impulses at velocity jumps
  /// −∫λ·w̃ dt and −Λ·w̃: what the given motion w̃ of a driven surface put in, of all the above.
  double driven = 0;
  double total() const { return sliding + drilling + impact; }
};

/// What the option `fidelity` made a method leave out, in the steps it kept.
struct LeftOut {
  std::int64_t as_coulomb = 0;  ///< contacts with drilling friction solved without, each time they were
  double friction = 0;          ///< the largest error that made in friction, as a part of μΛ_N: <= fidelity
  double impulse = 0;           ///< the sum of the bounds of these errors [N s]
};

enum class RunStatus {
  finished,        ///< reached the end of the time asked for
  step_limit,      ///< options.max_steps
  solver_failed,   ///< a contact problem had no solution the solver could find; `message` says where
  step_too_small,  ///< the error control asks for steps below rounding
  not_finite,      ///< the state left the numbers (an unstable scheme)
};
const char* name(RunStatus status);

/// What an integration did. The caller cannot ignore it.
struct [[nodiscard]] RunReport {
  RunStatus status = RunStatus::finished;
  std::string message;           ///< empty if all went well
  std::int64_t steps = 0;        ///< accepted
  std::int64_t rejected = 0;     ///< steps tried in vain
  std::int64_t evaluations = 0;  ///< of accelerations or of the system's terms, whichever the method counts
  std::int64_t contact_problems = 0;  ///< inclusions solved
  std::int64_t contact_iterations = 0;
  double worst_residual = 0;  ///< of the contact problems solved
  std::vector<Event> events;
  std::vector<Dissipation> dissipated;  ///< by contact
  std::vector<double> work;             ///< by the system's works() [J]
  LeftOut left_out;
};

struct IntegratorOptions {
  Method method = Method::event_driven;
  double step = 1e-4;               ///< Δt [s], fixed-step methods; initial guess for moreau_adaptive
  double tolerance = 1e-9;          ///< adaptive methods: of the local error, see each method
  double solver_tolerance = 1e-12;  ///< of contact problems; printed schemes: `tol` of Tables 1, 2 [N s]
  std::optional<double> r = {};     ///< printed schemes: the r of (4.16) [kg]; not given: see printed.hpp
  double output_interval = std::numeric_limits<double>::infinity();  ///< [s]; infinite: only start and end
  std::int64_t max_steps = std::numeric_limits<std::int64_t>::max();
  /// Time-stepping (moreau, moreau_implicit, moreau_adaptive, nscd): a contact whose drilling friction is
  /// this small a part of μΛ_N, and changes its sliding friction by no more, may be solved as a point contact
  /// (implicit_stage.hpp). > 0. Not given: none is.
  std::optional<double> fidelity = {};
};

using Observer = std::function<void(const Sample&)>;

/// Moves `state` on to t_end, or as far as it comes: the report says how it ended. The observer is called at
/// state.t, at state.t + k·output_interval, and at the end, in order. Contacts that are closed at the start
/// (|g_N| within rounding) and do not approach start closed.
///
/// Throws std::invalid_argument with one line for options or a state that make no sense (sizes, a penetrating
/// start, t_end before the state's time, a step that is not positive).
RunReport integrate(const MechanicalSystem& system, State& state, double t_end,
                    const IntegratorOptions& options, const Observer& observer = {});

}  // namespace contensou
