#include "contensou/scene/effect_table.hpp"

#include <algorithm>

#include "contensou/law/catalogue.hpp"
#include "contensou/text/number.hpp"

namespace contensou {
namespace {

using Rows = std::vector<EffectRow>;

std::string vector_text(const Eigen::Vector3d& v) {
  return to_text(v[0]) + ' ' + to_text(v[1]) + ' ' + to_text(v[2]);
}

/// Names of what has a property, in a line.
template <class Range, class Has>
std::string names_of(const Range& range, const Has& has) {
  std::string names;
  for (const auto& item : range) {
    if (has(item)) names += (names.empty() ? "" : ", ") + item.name;
  }
  return names;
}

void add_scene(const TippeTopScene& top, Rows& rows) {
  const bool gravity = top.data.g > 0;
  rows.push_back({"scene", "gravity", gravity, 0, gravity ? to_text(top.data.g) + " m/s^2" : "not there"});
  rows.push_back({"scene", "gyroscopic terms", true, 0, "of a symmetric top"});
  for (const char* effect : {"air drag", "loads", "driven bodies"})
    rows.push_back({"scene", effect, false, 0, "not for a tippe-top"});
}

bool gyroscopic(const BodyData& body) {
  return body.rotation == Rotation::free &&
         (body.inertia[0] != body.inertia[1] || body.inertia[1] != body.inertia[2]);
}

void add_scene(const BodiesScene& scene, Rows& rows) {
  const BodiesData& data = scene.data;
  const auto add = [&](const char* effect, const std::string& names, const char* otherwise) {
    rows.push_back({"scene", effect, !names.empty(), 0, names.empty() ? otherwise : names});
  };
  add("gravity", data.gravity.isZero(0) ? "" : vector_text(data.gravity) + " m/s^2", "not there");
  add("gyroscopic terms", names_of(data.bodies, gyroscopic), "no free body with unequal moments of inertia");
  add("air drag", names_of(data.bodies, [](const BodyData& body) { return body.drag.any(); }), "not there");
  add("loads", names_of(data.loads, [](const LoadData&) { return true; }), "not there");
  add("driven bodies",
      names_of(data.bodies, [](const BodyData& body) { return body.rotation == Rotation::driven; }),
      "not there");
}

/// What friction of four rows is computed by.
std::string drilling_code(const ContactScene& contact) {
  if (contact.model == "uncoupled") return "disk and interval, each by itself";
  if (contact.model == "ellipsoid") return "friction ball, ellipsoid in closed form";
  if (contact.pressure == "table") return "friction ball, law compiled from the table of the pressure";
  const double n = pressure_exponent(contact.pressure);
  if (n == 0 || n == 0.5) return "friction ball, " + contact.pressure + " in closed form";
  return "friction ball, law compiled from " + contact.pressure;
}

/// What friction is computed by, or why there is none.
std::string friction_code(const ContactScene& contact) {
  const std::string mu = ", mu = " + to_text(contact.mu);
  if (contact.rows() == 4) return drilling_code(contact) + mu;
  if (contact.rows() == 3) return "friction disk" + mu;
  return "law frictionless";
}

std::string why_no_drilling(const ContactScene& contact) {
  return contact.law == ContactLaw::contensou ? "radius 0: a point contact"
                                              : std::string("law ") + name(contact.law);
}

std::string why_no_coupling(const ContactScene& contact) {
  return contact.rows() < 4 ? "no drilling friction" : "model uncoupled";
}

std::string radius_code(const ContactScene& contact) {
  if (contact.modulus) return "Hertz, LG03 (3.2), E* = " + to_text(*contact.modulus) + " Pa";
  return contact.rows() < 4 ? "no drilling friction" : "constant, " + to_text(contact.radius) + " m";
}

void add_contact(const ContactScene& contact, Rows& rows) {
  const std::string where = "contact." + contact.name;
  const bool slides = contact.rows() >= 3, drills = contact.rows() >= 4;
  const bool coupled = drills && contact.model != "uncoupled";
  const auto add = [&](const char* effect, bool runs, int count, const std::string& how) {
    rows.push_back({where, effect, runs, runs ? count : 0, how});
  };
  add("unilateral contact", true, 1, slides ? "normal force and friction solved together" : "normal force");
  add("restitution", contact.restitution > 0, 0,
      contact.restitution > 0 ? "Newton's law, e = " + to_text(contact.restitution)
                              : "0: impacts do not rebound");
  add("sliding friction", slides, 2, friction_code(contact));
  add("drilling friction", drills, 1, drills ? friction_code(contact) : why_no_drilling(contact));
  add("coupling of sliding and drilling", coupled, 0,
      coupled ? drilling_code(contact) : why_no_coupling(contact));
  add("load-dependent radius", contact.modulus.has_value(), 0, radius_code(contact));
}

bool locates_events(Method method) { return method == Method::event_driven || method == Method::rk4; }

void add_events(const Scene& scene, Rows& rows) {
  const std::vector<const ContactScene*> contacts = scene.contacts();
  const bool located = locates_events(scene.integrator.method);
  const auto at_least = [&](int count) {
    return std::any_of(contacts.begin(), contacts.end(),
                       [count](const ContactScene* contact) { return contact->rows() >= count; });
  };
  const auto add = [&](const char* effect, bool there, const char* what, const char* otherwise) {
    const char* steps = "no search: contacts are solved for in each step";
    rows.push_back({"integrator", effect, located && there, 0, !there ? otherwise : located ? what : steps});
  };
  add("search for closing and opening", at_least(1), "gaps and normal forces", "no contact");
  add("search for stick and slip", at_least(3), "friction left, slip that ends", "no friction");
  add("search for reversed spin", at_least(4), "spin of slipping contacts", "no drilling friction");
}

void add_integrator(const Scene& scene, Rows& rows) {
  const IntegratorOptions& options = scene.integrator;
  const bool fixed = has_fixed_step(options.method);
  const auto add = [&](const char* effect, bool runs, const std::string& how) {
    rows.push_back({"integrator", effect, runs, 0, how});
  };
  add("method", true, name(options.method));
  add("step", fixed, fixed ? to_text(options.step) + " s" : "the method chooses its steps");
  add("tolerance", !fixed, fixed ? "the step is fixed" : to_text(options.tolerance));
  const bool contacts = !scene.contacts().empty();
  add("solver_tolerance", contacts, contacts ? to_text(options.solver_tolerance) : "no contact");
  add_events(scene, rows);
  const bool fidelity = options.fidelity.has_value() || scene.fidelity.has_value();
  add("fidelity", fidelity,
      fidelity ? "leaves out less than " + to_text(options.fidelity.value_or(scene.fidelity.value_or(0))) +
                     " of mu lambda_N"
               : "nothing is left out");
}

}  // namespace

std::string row_names(const ContactScene& contact) {
  const int rows = contact.rows();
  return rows == 1 ? "N" : rows == 3 ? "N T1 T2" : "N T1 T2 tau";
}

std::vector<EffectRow> effect_rows(const Scene& scene) {
  Rows rows;
  std::visit([&](const auto& system) { add_scene(system, rows); }, scene.system);
  for (const ContactScene* contact : scene.contacts()) add_contact(*contact, rows);
  add_integrator(scene, rows);
  return rows;
}

}  // namespace contensou
