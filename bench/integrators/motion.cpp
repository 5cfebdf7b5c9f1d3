#include "motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "common/pareto.hpp"
#include "contensou/ball/friction_ball.hpp"
#include "contensou/ball/smooth_plate.hpp"
#include "contensou/law/hertz.hpp"
#include "contensou/system/tippe_top_axis.hpp"
#include "contensou/system/tippe_top_euler.hpp"
#include "contensou/text/number.hpp"

namespace bench {
namespace {

using contensou::EventKind;
using contensou::Method;

constexpr std::size_t body = 0;

/// [s] The top stands on its tip for 3.4 s. What the body does this soon after the tip's touch belongs to
/// that touch: coarse steps rock there for a while.
constexpr double standing = 1;

/// [s] Impacts of the accumulating series are at most 0.074 s apart; after them nothing closes for 0.68 s.
constexpr double end_of_series = 0.1;

void tell_impacts(const std::vector<contensou::Event>& events, Story& story) {
  std::size_t last = body;  // on which the top starts
  for (const contensou::Event& event : events) {
    if (event.kind == EventKind::accumulation) {
      story.accumulation = event.t;
      std::erase_if(story.impacts, [&](double t) { return t >= event.t; });
      return;
    }
    if (event.kind != EventKind::close || event.contact == last) continue;
    if (story.impacts.size() == 1 && event.t - story.impacts.front() < standing) continue;
    if (story.impacts.size() > 1 && event.t - story.impacts.back() > end_of_series) break;
    story.impacts.push_back(event.t);
    last = event.contact;
  }
  if (!story.impacts.empty()) story.accumulation = story.impacts.back();
}

std::string failure(const contensou::RunReport& report, const Story& story, double t_end) {
  if (report.status != contensou::RunStatus::finished) return name(report.status);
  if (t_end <= early_motion || story.impacts.size() > 1) return "";
  return story.impacts.empty() ? "the tip never touches" : "the body never touches";
}

}  // namespace

std::string setting(const Scheme& scheme) {
  const char* size = has_fixed_step(scheme.method) ? ", step " : ", tolerance ";
  return scheme.formulation + size + contensou::to_text(scheme.size);
}

std::unique_ptr<contensou::TippeTopModel> paper_top(const std::string& formulation) {
  const contensou::AnyFriction hertz{contensou::FrictionBall(contensou::SmoothPlate(contensou::HertzLaw{}))};
  const auto contacts = contensou::tippe_top_contacts(hertz);
  const contensou::TippeTopData data;
  if (formulation == "axis") return std::make_unique<contensou::TippeTopAxis>(data, contacts);
  return std::make_unique<contensou::TippeTopEuler>(data, contacts);
}

Story story_of(const contensou::TippeTopModel& top, const Scheme& scheme, double t_end) {
  contensou::State state = top.start(0.1, 180);
  contensou::IntegratorOptions options;
  options.method = scheme.method;
  (has_fixed_step(scheme.method) ? options.step : options.tolerance) = scheme.size;
  const contensou::RunReport report = integrate(top, state, t_end, options);
  Story story;
  tell_impacts(report.events, story);
  story.theta = top.inclination(state.q);
  story.t = state.t;
  story.steps = report.steps;
  story.failure = failure(report, story, t_end);
  return story;
}

Errors errors(const Story& whole, double theta_early, const Reference& reference) {
  Errors e;
  const std::vector<double>& exact = reference.whole.impacts;
  for (std::size_t k = 0; k < exact.size(); ++k) {
    const double t = k < whole.impacts.size() ? whole.impacts[k] : whole.accumulation;
    e.events = worse(e.events, std::abs(t - exact[k]));
    if (k < 2) e.touches = e.events;
  }
  e.accumulation = std::abs(whole.accumulation - reference.whole.accumulation);
  e.theta_early = std::abs(theta_early - reference.theta_early);
  e.theta_end = std::abs(whole.theta - reference.whole.theta);
  return e;
}

Reference reference() {
  const auto told = [](const Scheme& scheme, double t_end) {
    Story story = story_of(*paper_top(scheme.formulation), scheme, t_end);
    if (!story.told())
      throw std::runtime_error(std::string("bench_integrators: the reference fails: ") + name(scheme.method) +
                               ", " + setting(scheme) + ": " + story.failure);
    return story;
  };
  // Below 3e-15 a tolerance changes nothing but rounding.
  const Scheme best{Method::event_driven, "axis", 3e-15};
  const std::array witnesses{Scheme{Method::event_driven, "axis", 1e-14},
                             Scheme{Method::event_driven, "axis", 1e-15},
                             Scheme{Method::event_driven, "euler", 1e-14},
                             Scheme{Method::event_driven, "euler", 3e-15}, Scheme{Method::rk4, "axis", 1e-5}};
  Reference found{told(best, whole_motion), told(best, early_motion).theta, {}, ""};
  for (const Scheme& witness : witnesses) {
    const Errors e = errors(told(witness, whole_motion), told(witness, early_motion).theta, found);
    found.bars.events = std::max(found.bars.events, e.events);
    found.bars.touches = std::max(found.bars.touches, e.touches);
    found.bars.accumulation = std::max(found.bars.accumulation, e.accumulation);
    found.bars.theta_early = std::max(found.bars.theta_early, e.theta_early);
    found.bars.theta_end = std::max(found.bars.theta_end, e.theta_end);
    found.witnesses +=
        (found.witnesses.empty() ? "" : "; ") + std::string(name(witness.method)) + ", " + setting(witness);
  }
  return found;
}

}  // namespace bench
