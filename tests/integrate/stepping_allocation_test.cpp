// No time-stepping scheme allocates in a step while the same contacts take part.

#include <catch2/catch.hpp>

#include "../allocation_counter.hpp"
#include "stepping_problems.hpp"

using namespace contensou;
using namespace stepping_problems;

TEST_CASE("Allocation: none in a step of time-stepping", "[integrate][moreau][printed]") {
  if (!allocation_counter::available()) {
    WARN("not counted: this is another C library, or a sanitizer");
    return;
  }
  const TippeTopAxis top = paper_top();
  const auto allocations = [](const TippeTopAxis& system, const State& start, Method method,
                              std::optional<double> fidelity = {}) {
    State state = start;
    IntegratorOptions options;
    options.method = method;
    options.fidelity = fidelity;
    options.step = 1e-4;
    options.tolerance = 1e-6;
    options.output_interval = 1e-3;
    long shown = 0;
    allocation_counter::reset();
    const RunReport report = integrate(system, state, 0.02, options, [&](const Sample&) {
      if (++shown == 6) allocation_counter::start();
      if (shown == 18) allocation_counter::stop();
    });
    allocation_counter::stop();
    CHECK(report.status == RunStatus::finished);
    CHECK(shown == 21);
    return allocation_counter::count();
  };
  for (const Method method :
       {Method::moreau_printed, Method::moreau, Method::moreau_implicit, Method::moreau_adaptive}) {
    CAPTURE(name(method));
    CHECK(allocations(top, top.start(0.1, 180), method) == 0);
    CHECK(allocations(top, top_in_flight(top), method) == 0);
  }
  auto contacts = tippe_top_contacts(system_test::hertz);
  contacts[0].load_radius = LoadRadius{.relative_radius = 0.015, .modulus = 1e5};
  const TippeTopAxis loaded(TippeTopData{}, contacts);
  for (const Method method : {Method::moreau, Method::moreau_implicit, Method::moreau_adaptive}) {
    CAPTURE(name(method));
    CHECK(allocations(loaded, top.start(0.1, 180), method) == 0);
    // A point contact throughout: with less fidelity it is one for a part of the time, and changes take
    // memory.
    CHECK(allocations(top, top.start(0.1, 180), method, 0.3) == 0);
  }
  // In a closed contact the stages of Table 2 find other contacts closed all the time.
  CHECK(allocations(top, top_in_flight(top), Method::rk4_printed) == 0);
}
