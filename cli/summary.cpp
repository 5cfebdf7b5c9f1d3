#include "summary.hpp"

#include <nlohmann/json.hpp>

#include "contensou/scene/effects.hpp"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;
using namespace contensou;

/// The settings that the method used, and no others.
Json settings(const IntegratorOptions& options, int threads) {
  Json json;
  if (has_fixed_step(options.method)) {
    json["step"] = options.step;
  } else {
    json["tolerance"] = options.tolerance;
  }
  if (options.method == Method::moreau_adaptive) json["first_step"] = options.step;
  json["solver_tolerance"] = options.solver_tolerance;
  if (options.r) json["r"] = *options.r;
  if (options.method == Method::nscd) json["threads"] = threads;
  return json;
}

Json contact_settings(const ContactScene& contact) {
  Json json{{"law", name(contact.law)}, {"rows", contact.rows()}};
  if (contact.law == ContactLaw::contensou) {
    json["pressure"] = contact.pressure;
    json["model"] = contact.model;
    if (contact.modulus) {
      json["modulus"] = *contact.modulus;
    } else {
      json["radius"] = contact.radius;
    }
  }
  if (contact.law != ContactLaw::frictionless) json["mu"] = contact.mu;
  json["restitution"] = contact.restitution;
  json["effects"] = effects(contact);
  return json;
}

Json dissipated(const Outcome& outcome) {
  Json json = Json::object();
  for (std::size_t i = 0; i < outcome.report.dissipated.size(); ++i) {
    const Dissipation& by = outcome.report.dissipated[i];
    Json& contact = json[outcome.contacts[i]] = {
        {"sliding", by.sliding}, {"drilling", by.drilling}, {"impact", by.impact}};
    if (by.driven != 0) contact["driven"] = by.driven;
  }
  return json;
}

/// What loads put in and the air took, by name.
Json work(const Outcome& outcome) {
  Json json = Json::object();
  for (std::size_t i = 0; i < outcome.report.work.size(); ++i)
    json[outcome.works[i]] = outcome.report.work[i];
  return json;
}

}  // namespace

std::string summary(const Command& command, const Scene& scene, const Outcome& outcome) {
  const RunReport& report = outcome.report;
  Json contacts = Json::object();
  for (const ContactScene* contact : scene.contacts()) contacts[contact->name] = contact_settings(*contact);
  Json json{{"scene", scene.name},
            {"file", command.scene},
            {"set", command.set},
            {"unset", command.unset},
            {"version", CONTENSOU_VERSION},
            {"method", name(scene.integrator.method)},
            {"settings", settings(scene.integrator, scene.threads)},
            {"effects", effects(scene)},
            {"contacts", contacts},
            {"status", name(report.status)},
            {"message", report.message},
            {"t", outcome.t},
            {"duration", scene.duration},
            {"wall_seconds", outcome.wall_seconds},
            {"steps", report.steps},
            {"rejected", report.rejected},
            {"evaluations", report.evaluations},
            {"contact_problems", report.contact_problems},
            {"iterations", report.contact_iterations},
            {"worst_residual", report.worst_residual},
            {"events", report.events.size()},
            {"energy_initial", outcome.energy.initial},
            {"energy_final", outcome.energy.final},
            {"dissipated", dissipated(outcome)},
            {"work", work(outcome)},
            {"energy_balance",
             {{"supplied", outcome.energy.supplied},
              {"dissipated", outcome.energy.dissipated},
              {"imbalance", outcome.energy.imbalance()},
              {"relative", outcome.energy.relative()}}}};
  if (scene.fidelity) {
    json["fidelity"] = *scene.fidelity;
    json["left_out"] = {{"contacts_as_coulomb", report.left_out.as_coulomb},
                        {"largest_error_of_friction", report.left_out.friction},
                        {"bound_of_impulses", report.left_out.impulse}};
  }
  if (const auto* top = std::get_if<TippeTopScene>(&scene.system))
    json["formulation"] = top->formulation == TippeTopScene::Formulation::euler ? "euler" : "axis";
  constexpr int indent = 2;
  return json.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace cli
