#include "contensou/scene/scene.hpp"

#include <cmath>
#include <filesystem>
#include <numbers>

#include "contensou/law/catalogue.hpp"
#include "contensou/scene/reader.hpp"
#include "contensou/scene/simulation.hpp"
#include "contensou/text/number.hpp"

namespace contensou {
namespace {

using Formulation = TippeTopScene::Formulation;

/// Gaps this deep are rounding, as for the integrators.
constexpr double penetration_limit = 1e-12;

IntegratorOptions read_integrator(SceneReader& read, double duration) {
  IntegratorOptions options;
  const std::string key = "integrator.method";
  const std::string method = read.text(key, "the name of a method such as \"event_driven\"");
  if (read.has(key)) {
    try {
      options.method = method_named(method);
    } catch (const std::invalid_argument& error) {
      const std::string what = error.what();
      read.refuse(key, "is no method", what.substr(what.find("one of")));
    }
  }
  const std::string step = "integrator.step";
  const std::string tolerance = "integrator.tolerance";
  if (has_fixed_step(options.method)) {
    options.step = read.number(step, positive);
    read.optional_number(tolerance, positive);  // may stand, is not used
    if (duration / options.step > most_steps)
      read.refuse(step, "makes more than 1e12 steps", "a step of at least duration/1e12");
  } else {
    options.tolerance = read.number(tolerance, positive);
    options.step = read.optional_number(step, positive).value_or(options.step);
  }
  options.solver_tolerance =
      read.optional_number("integrator.solver_tolerance", positive).value_or(options.solver_tolerance);
  if (options.method == Method::moreau_printed || options.method == Method::rk4_printed) {
    options.r = read.optional_number("integrator.r", positive);
  } else {
    read.unused("integrator.r", std::string("method ") + name(options.method));
  }
  return options;
}

/// A friction that the contact names but cannot have is a matter of its pressure.
void require_pressure(const SceneReader& read, const std::string& key, const ContactScene& contact) {
  try {
    pressure_exponent(contact.pressure);
    make_friction(contact);
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();
    const std::size_t expected = what.find("expected ");
    read.refuse(
        key, "is no pressure",
        expected == std::string::npos ? what : what.substr(expected + std::string("expected ").size()));
  }
}

ContactScene read_contact(SceneReader& read, const std::string& name) {
  const std::string table = "contact." + name + '.';
  ContactScene contact;
  contact.name = name;
  const std::string law = read.choice(table + "law", {"contensou", "coulomb", "frictionless"});
  contact.law = law == "contensou" ? ContactLaw::contensou
                : law == "coulomb" ? ContactLaw::coulomb
                                   : ContactLaw::frictionless;
  contact.restitution = read.optional_number(table + "restitution", from_0_to_1).value_or(0);
  if (contact.law == ContactLaw::frictionless) {
    read.unused(table + "mu", "law frictionless");
  } else {
    contact.mu = read.number(table + "mu", not_negative);
  }
  if (contact.law != ContactLaw::contensou) {
    for (const char* key : {"pressure", "model", "radius"}) read.unused(table + key, "law " + law);
    return contact;
  }
  contact.radius = read.number(table + "radius", not_negative);
  contact.model = read.optional_choice(table + "model", {"exact", "ellipsoid"}).value_or("exact");
  contact.pressure =
      read.optional_text(table + "pressure", "\"uniform\", \"hertz\" or \"power:N\"").value_or("hertz");
  if (read.has(table + "pressure")) require_pressure(read, table + "pressure", contact);
  return contact;
}

TippeTopData read_top(SceneReader& read, double gravity) {
  constexpr Range any;
  TippeTopData top{.m = read.number("top.mass", positive),
                   .i1 = read.number("top.i1", positive),
                   .i3 = read.number("top.i3", positive),
                   .g = gravity,
                   .a1 = read.number("top.a1", any),
                   .a2 = read.number("top.a2", any),
                   .r1 = read.number("top.r1", positive),
                   .r2 = read.number("top.r2", positive)};
  // The triangle inequality of principal moments of inertia.
  if (top.i3 > 2 * top.i1) read.refuse("top.i3", "is more than any body has", "a number > 0, at most 2 i1");
  return top;
}

double read_theta(SceneReader& read, Formulation formulation) {
  const Range axis{.least = 0, .most = std::numbers::pi, .expected = "a number from 0 to pi [rad]"};
  const double theta = read.number("initial.theta", axis);
  if (formulation == Formulation::euler && (theta == 0 || theta == std::numbers::pi))
    read.refuse("initial.theta", "is where Euler angles are singular",
                "a number between 0 and pi, or scene.formulation = \"axis\"");
  return theta;
}

std::optional<double> read_height(SceneReader& read) {
  constexpr Range height{.expected = "a number [m] or \"contact\""};
  const std::string key = "initial.z_s";
  if (!read.is_text(key)) return read.number(key, height);
  if (read.text(key, height.expected) != "contact") read.refuse(key, "is not a number", height.expected);
  return {};
}

/// Throws where the top would start within the floor.
void require_above_floor(const SceneReader& read, const TippeTopScene& scene) {
  if (!scene.z_s) return;
  const std::unique_ptr<const TippeTopModel> top = make_tippe_top(scene);
  const double lowest = top->start(scene.theta, scene.psi_dot).q[2];
  if (*scene.z_s < lowest - penetration_limit * top->length_scale())
    read.refuse("initial.z_s", "puts the top into the floor",
                "\"contact\", or at least " + to_text(lowest) + " for this theta");
}

}  // namespace

std::vector<const ContactScene*> Scene::contacts() const {
  std::vector<const ContactScene*> all;
  if (const auto* top = std::get_if<TippeTopScene>(&system)) {
    for (const ContactScene& contact : top->contacts) all.push_back(&contact);
  } else {
    for (const ContactScene& contact : std::get<BodiesScene>(system).contacts) all.push_back(&contact);
  }
  return all;
}

Scene read_scene(const SceneDocument& document) {
  SceneReader read(document);
  Scene scene;
  scene.file = document.file;
  read.choice("scene.system", {"tippe_top"});
  scene.name = read.optional_text("scene.name", "a string")
                   .value_or(std::filesystem::path(document.file).stem().string());
  scene.duration = read.number("scene.duration", positive);
  const double gravity = read.number("scene.gravity", not_negative);

  auto& top = scene.system.emplace<TippeTopScene>();
  const bool euler = read.optional_choice("scene.formulation", {"axis", "euler"}) == "euler";
  top.formulation = euler ? Formulation::euler : Formulation::axis;
  top.data = read_top(read, gravity);
  top.theta = read_theta(read, top.formulation);
  top.psi_dot = read.number("initial.psi_dot", Range{});
  top.z_s = read_height(read);
  top.contacts = {read_contact(read, "body"), read_contact(read, "tip")};

  scene.integrator = read_integrator(read, scene.duration);
  const std::string interval = "output.interval";
  scene.integrator.output_interval =
      read.optional_number(interval, positive).value_or(scene.integrator.output_interval);
  if (scene.duration / scene.integrator.output_interval > most_rows)
    read.refuse(interval, "makes more than 1e6 rows", "an interval of at least duration/1e6");
  read.finish();
  require_above_floor(read, top);
  return scene;
}

std::string scene_help() {
  return "[scene]        system = \"tippe_top\"; duration [s]; gravity [m/s^2]; name (else the file's);\n"
         "               formulation = \"axis\" (if not given) or \"euler\" (Euler angles, as in LG03)\n"
         "[top]          mass [kg], i1, i3 [kg m^2], a1, a2, r1, r2 [m]: LG03 5.4\n"
         "[initial]      theta [rad], psi_dot [rad/s], z_s [m] or \"contact\": just touching the floor\n"
         "[contact.body] [contact.tip]\n"
         "               law = \"frictionless\", \"coulomb\" or \"contensou\"; mu (the last two);\n"
         "               radius [m] (contensou; 0 is the limit of a point contact: coulomb);\n"
         "               pressure (contensou; hertz if not given; see contensou law --help);\n"
         "               model = \"exact\" (contensou; if not given) or \"ellipsoid\";\n"
         "               restitution (0 if not given)\n"
         "[integrator]   method; step [s] (fixed-step methods); tolerance (the others; both may stand);\n"
         "               solver_tolerance; r [kg] (printed methods)\n"
         "[output]       interval [s] of the rows of trajectory.tsv (if not given: only start and end)\n";
}

}  // namespace contensou
