#include "contensou/scene/read_integrator.hpp"

#include <limits>
#include <stdexcept>

#include "contensou/scene/read_contact.hpp"

namespace contensou {
namespace {

constexpr double nscd_solver_tolerance = 1e-8;  // of many contacts, by an iteration of first order
constexpr int most_threads = 1024;

Method read_method(SceneReader& read, bool bodies) {
  const std::string key = "integrator.method";
  const std::string text = read.text(key, "the name of a method such as \"event_driven\"");
  if (!read.has(key)) return IntegratorOptions().method;
  try {
    const Method method = method_named(text);
    if (method == Method::nscd && !bodies)
      read.refuse(key, "is for scenes of bodies", "another method, or scene.system = \"bodies\"");
    return method;
  } catch (const SceneError&) {
    throw;
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();
    read.refuse(key, "is no method", what.substr(what.find("one of")));
  }
}

/// The method's own of step and tolerance; the other may stand.
void read_accuracy(SceneReader& read, double duration, IntegratorOptions& options) {
  const std::string step = "integrator.step";
  const std::string tolerance = "integrator.tolerance";
  if (has_fixed_step(options.method)) {
    options.step = read.number(step, positive);
    read.optional_number(tolerance, positive);
    if (duration / options.step > most_steps)
      read.refuse(step, "makes more than 1e12 steps", "a step of at least duration/1e12");
  } else {
    options.tolerance = read.number(tolerance, positive);
    options.step = read.optional_number(step, positive).value_or(options.step);
  }
}

}  // namespace

void read_integrator(SceneReader& read, Scene& scene) {
  scene.duration = read.number("scene.duration", positive);
  IntegratorOptions& options = scene.integrator;
  options.method = read_method(read, std::holds_alternative<BodiesScene>(scene.system));
  const std::string method = std::string("method ") + name(options.method);
  read_accuracy(read, scene.duration, options);

  const bool nscd = options.method == Method::nscd;
  if (nscd) options.solver_tolerance = nscd_solver_tolerance;
  options.solver_tolerance =
      read.optional_number("integrator.solver_tolerance", positive).value_or(options.solver_tolerance);
  if (options.method == Method::moreau_printed || options.method == Method::rk4_printed) {
    options.r = read.optional_number("integrator.r", positive);
  } else {
    read.unused("integrator.r", method);
  }
  if (nscd) {
    scene.threads = read.optional_whole("integrator.threads", 1, most_threads).value_or(1);
  } else {
    read.unused("integrator.threads", method);
  }
  if (is_time_stepping(options.method)) {
    constexpr Range part{.least = 0,
                         .most = 1 - std::numeric_limits<double>::epsilon(),
                         .least_too = false,
                         .expected = "a number between 0 and 1"};
    scene.fidelity = read.optional_number("scene.fidelity", part);
    options.fidelity = scene.fidelity;
  } else {
    read.unused("scene.fidelity", method);
  }

  const std::string interval = "output.interval";
  options.output_interval = read.optional_number(interval, positive).value_or(options.output_interval);
  if (scene.duration / options.output_interval > most_rows)
    read.refuse(interval, "makes more than 1e6 rows", "an interval of at least duration/1e6");
}

}  // namespace contensou
