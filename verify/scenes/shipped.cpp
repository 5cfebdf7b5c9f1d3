#include "shipped.hpp"

#include <algorithm>
#include <stdexcept>

#include "contensou/scene/document.hpp"
#include "contensou/scene/scene.hpp"
#include "contensou/scene/simulation.hpp"

namespace verify::answers {

Shipped::Shipped(const std::string& scene, const std::vector<std::string>& changes) {
  contensou::SceneDocument document =
      contensou::read_document(std::string(CONTENSOU_SCENES) + "/" + scene + ".toml");
  for (const std::string& change : changes) contensou::set_value(document, change);
  const contensou::Scene read = contensou::read_scene(document);
  measures_ = read.measures;
  tolerance_ = read.integrator.tolerance;
  contensou::Simulation simulation = contensou::compose(read);
  outcome_ = contensou::run(simulation);
  end_ = simulation.state;
  if (report().status != contensou::RunStatus::finished)
    throw std::runtime_error(scene + ": " + contensou::name(report().status) + ", " + report().message);
}

double Shipped::measured(const std::string& name) const {
  for (const contensou::MeasureScene& measure : measures_) {
    if (measure.name == name) return contensou::evaluate(measure, outcome_);
  }
  throw std::invalid_argument("no outcome " + name);
}

double Shipped::at(const std::string& column, std::size_t row) const {
  const auto& names = outcome_.columns;
  const auto found = std::find(names.begin(), names.end(), column);
  if (found == names.end()) throw std::invalid_argument("no column " + column);
  return outcome_.rows.at(row * names.size() + static_cast<std::size_t>(found - names.begin()));
}

std::vector<double> Shipped::times_until(double end) const {
  std::vector<double> found;
  for (std::size_t i = 0; i < rows() && at("t", i) < end; ++i) found.push_back(at("t", i));
  return found;
}

std::vector<double> Shipped::times(contensou::EventKind kind, const std::string& contact) const {
  std::vector<double> found;
  for (const contensou::Event& event : report().events) {
    if (event.kind == kind && (contact.empty() || outcome_.contacts[event.contact] == contact))
      found.push_back(event.t);
  }
  return found;
}

}  // namespace verify::answers
