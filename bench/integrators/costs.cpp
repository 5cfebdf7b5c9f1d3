#include "costs.hpp"

#include <map>
#include <memory>
#include <string>

#include "common/stopwatch.hpp"

namespace bench {
namespace {

using contensou::Method;

/// Down to what one can wait for: some seconds for the slowest run of a method.
std::vector<double> sizes(Method method) {
  switch (method) {
    case Method::moreau_printed:
      return {2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5};
    case Method::rk4_printed:
      return {4e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4};
    case Method::moreau:
      return {2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5};
    case Method::moreau_implicit:
      return {1e-3, 5e-4, 2e-4, 1e-4, 5e-5};
    case Method::moreau_adaptive:
      return {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};
    case Method::rk4:
      return {4e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5};
    case Method::event_driven:
      return {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13};
    case Method::nscd:
      break;  // for bodies: bench/bodies
  }
  return {};
}

std::vector<Scheme> schemes() {
  std::vector<Scheme> all;
  for (const Method method : {Method::moreau_printed, Method::rk4_printed, Method::moreau_implicit,
                              Method::moreau, Method::moreau_adaptive, Method::rk4, Method::event_driven}) {
    for (const char* formulation : {"axis", "euler"}) {
      for (const double size : sizes(method)) all.push_back({method, formulation, size});
    }
  }
  return all;
}

}  // namespace

std::vector<CostRow> measure_integrators(const Reference& reference) {
  std::vector<CostRow> rows;
  for (Scheme& scheme : schemes()) rows.push_back({std::move(scheme), {}, {}});
  std::map<std::string, std::unique_ptr<contensou::TippeTopModel>> tops;
  for (const char* formulation : {"axis", "euler"}) tops[formulation] = paper_top(formulation);

  // Each run tells its story while it is timed: the long ones are made once.
  std::vector<Story> early(rows.size());
  std::vector<Task> whole_runs, early_runs;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CostRow& row = rows[i];
    const contensou::TippeTopModel& top = *tops.at(row.scheme.formulation);
    whole_runs.push_back({[&row, &top] { row.whole = story_of(top, row.scheme, whole_motion); }, 1});
    early_runs.push_back(
        {[&row, &top, &told = early[i]] { told = story_of(top, row.scheme, early_motion); }, 1});
  }
  const auto whole_times =
      time_interleaved(whole_runs, {.rounds = 15, .visit = 1e-3, .budget = 0.2, .least = 1});
  const auto early_times =
      time_interleaved(early_runs, {.rounds = 15, .visit = 1e-3, .budget = 0.05, .least = 1});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CostRow& row = rows[i];
    if (!row.whole.told()) continue;
    row.errors = errors(row.whole, early[i].theta, reference);
    row.seconds = quantile(whole_times[i], 0.25);
    row.seconds_early = quantile(early_times[i], 0.25);
  }
  return rows;
}

}  // namespace bench
