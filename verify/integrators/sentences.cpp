// What LG03 says of its schemes, beside what was measured.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "checks.hpp"
#include "measure.hpp"

namespace verify::integrators {
namespace {

constexpr double smooth = 0.25, struck = 0.45;  ///< as in the orders themselves

double of(const Findings& found, const std::string& name) {
  const auto at = found.find(name);
  if (at == found.end()) throw std::logic_error("no finding called " + name);
  return at->second;
}

/// A sentence as a claim, and its row: it holds if the claim does, else `flaw` is what is wrong with it.
void judge(Record& record, const Claim& claim, const char* flaw, LedgerRow row) {
  record.add(claim);
  row.verdict = claim.error <= claim.bound ? "holds" : flaw;
  if (row.verdict == "holds") row.corrected.clear();
  record.add(std::move(row));
}

}  // namespace

void judge_sentences(Record& record, const Findings& found) {
  const auto n = [&](const std::string& name, int digits = 3) { return text(of(found, name), digits); };
  const auto order = [&](const std::string& phase, const char* scheme) {
    return of(found, "order." + phase + "." + scheme);
  };
  const auto orders = [&](const char* scheme) {
    std::string list;
    for (const char* phase : {"flight", "slip_top", "slip_disc", "slip_point", "roll_top"})
      list += std::string(list.empty() ? "" : ", ") + phase + " " + text(order(phase, scheme), 3);
    return list;
  };

  double from_four = 0;
  for (const char* phase : {"flight", "slip_top", "slip_disc", "slip_point"})
    from_four = std::max(from_four, std::abs(order(phase, "rk4_printed") - 4));
  judge(
      record,
      {"integrators.said.smooth", "LG03 4.2, Table 2",
       "fourth-order accuracy during smooth parts: largest distance of the measured order from 4, flight and "
       "slip",
       4, 4 - from_four, from_four, smooth, false},
      "wrong",
      {"Section 4.2, order in smooth parts (Abstract, Section 6)",
       "The four-stage Runge–Kutta method achieves a fourth-order accuracy during smooth parts of the motion",
       "", "first order; fourth with M⁻¹h, contact and friction on acceleration level in the stages",
       "rk4_printed: " + orders("rk4_printed") + "; rk4: " + orders("rk4") +
           ". Table 2's stage gives the acceleration of another state: q half of Δt₂ on, friction and "
           "contact Δt₂ "
           "on. All stages are off alike, by O(Δt), and no weights take that out.",
       "Table 2 is no more accurate per step than O(Δt); it only has a smaller constant than Table 1."});

  double from_one = 0;
  for (const char* phase : {"impact_point", "impact_top"})
    from_one = std::max(from_one, std::abs(order(phase, "rk4_printed") - 1));
  judge(record,
        {"integrators.said.impact", "LG03 4.2, Table 2",
         "first-order accuracy if an impact is encountered: largest distance of the measured order from 1", 1,
         1 - from_one, from_one, struck, false},
        "wrong",
        {"Section 4.2, order through an impact",
         "and first-order accuracy if an impact is encountered during the time-step", "",
         "no convergence: the velocity after an inelastic impact is wrong by up to a third of the impact's",
         "rk4_printed through one impact: order " + text(order("impact_point", "rk4_printed"), 2) +
             " (point), " + text(order("impact_top", "rk4_printed"), 2) + " (top); rebound " +
             n("rebound.least.rk4_printed") + " to " + n("rebound.most.rk4_printed") +
             " of the impact's speed, at every step. moreau_printed: " +
             text(order("impact_point", "moreau_printed"), 3) + ", " +
             text(order("impact_top", "moreau_printed"), 3) +
             ". A pseudo-acceleration −4γ/Δt in some stages, weighted, does not add up to −γ/Δt.",
         "An impulse must not be weighted: rk4 and moreau apply it over the whole step."});

  const double highest =
      std::max({order("flight", "moreau_printed"), order("slip_top", "moreau_printed"),
                order("slip_disc", "moreau_printed"), order("slip_point", "moreau_printed"),
                order("roll_top", "moreau_printed"), order("impact_top", "moreau_printed")});
  judge(record,
        {"integrators.said.low", "LG03 4, time-stepping",
         "low-order accuracy: largest order of Table 1 on the top, in slip and through an impact, beyond 1",
         1, highest, std::max(0.0, highest - 1), smooth, true},
        "wrong",
        {"Section 4, time-stepping, accuracy",
         "A notable disadvantage of the time-stepping method is its low-order accuracy", "", "",
         "Table 1: " + orders("moreau_printed") + ", through an impact " +
             text(order("impact_top", "moreau_printed"), 3) +
             "; 2 only without friction and velocities in h (" +
             text(order("oscillation", "moreau_printed"), 3) + ").",
         "Not of time-stepping as such: `moreau`, time-stepping too, has order 2 in all of these."});

  const double missing = of(found, "error.accumulation_top.moreau_printed");
  judge(
      record,
      {"integrators.said.accumulation", "LG03 4, time-stepping",
       "Table 1 passes the accumulation of impacts of the rocking top and comes to the right state: error at "
       "1.25e-5 s, in units of the motion's",
       0, missing, missing, 0.01, true},
      "wrong",
      {"Section 4, time-stepping, accumulation",
       "A second advantage of the time-stepping method is its capability to pass accumulation points of "
       "impacts",
       "", "",
       "Table 1 at Δt = 1.25e-5 s: state after the accumulation to " + text(missing, 2) + " (order " +
           text(order("accumulation_top", "moreau_printed"), 2) + "), which ends too early by " +
           n("error.accumulation_top_time.moreau_printed", 2) + " s (order " +
           text(order("accumulation_top_time", "moreau_printed"), 2) +
           "). Table 2 passes it, too, but never comes to rest: it hops on, " +
           n("error.accumulation_top_time.rk4_printed", 2) +
           " s and more after it. event_driven: its time to " +
           n("error.accumulation_top_time.event_driven", 1) + " s.",
       "Early like √Δt, since a contact that landed stays in the floor by vΔt and bounces lower than that "
       "are not "
       "seen."});

  const double broke = of(found, "nutation_floor.finished_until.moreau_printed.euler.0.001");
  judge(record,
        {"integrators.said.diverging", "LG03 6",
         "fastly diverging with Table 1: in the paper's Euler angles, 1e-3 s, the run from its start ends "
         "after [s]",
         0, broke, broke, 1, true},
        "wrong",
        {"Section 6, classical time-stepping",
         "Numerical simulation with the classical (low-order) time-stepping method yielded fastly diverging "
         "solutions",
         "", "",
         "Table 1 in Euler angles from the start of 5.4: breaks down at " + text(broke, 3) +
             " s (Δt = 1e-3 s), " + n("nutation_floor.finished_until.moreau_printed.euler.0.0005") +
             " s (5e-4 s). Nutation in flight grows by " +
             n("nutation_flight.numerical_rate.moreau_printed.euler.0.0001") + " 1/s at 1e-4 s, ω²Δt/2 = " +
             text(std::pow(of(found, "nutation.frequency.flight"), 2) * 1e-4 / 2) +
             " 1/s: h(q_M, u_A) is Euler's explicit method for the gyroscopic forces. With the axis for a "
             "coordinate " +
             n("nutation_flight.numerical_rate.moreau_printed.0.0001") + " 1/s; θ(1 s) is off by " +
             n("top.error.moreau_printed", 2) + " rad at 1e-4 s.",
         "The letter of Table 1, u_A in h, does it; `moreau`, of the same school, loses " +
             text(-of(found, "nutation_flight.numerical_rate.moreau.0.0001"), 1) + " 1/s."});

  const double left = of(found, "nutation_floor.amplitude_ratio.moreau_implicit.0.001");
  judge(record,
        {"integrators.said.deadening", "LG03 6",
         "fast deadening by the fully implicit version: amplitude of the nutation after 1.2 s over the exact "
         "one, "
         "1e-3 s",
         0, left, left, 0.1, true},
        "wrong",
        {"Section 6, fully implicit version",
         "or a fast deadening of the nutational oscillation if integrated with a fully implicit version", "",
         "",
         "moreau_implicit: numerical growth in flight " +
             n("nutation_flight.numerical_rate.moreau_implicit.0.001") + ", " +
             n("nutation_flight.numerical_rate.moreau_implicit.0.0001") +
             " 1/s at 1e-3, 1e-4 s, −ln(1 + ω²Δt²)/(2Δt) with ω = " + n("nutation.frequency.flight", 4) +
             " rad/s; on the floor " + text(left, 2) +
             " of the nutation is left after 1.2 s (1e-3 s), and θ(3 s) = " +
             n("top.theta_late.moreau_implicit.0.0004") + " rad at 4e-4 s where " +
             n("top.theta_late.rk4_printed.5e-05") + " is right.",
         "With the nutation goes the slip that turns the top over: it inverts late or not at all."});

  const auto rate = [&](const char* scheme) {
    return of(found, std::string("nutation_flight.numerical_rate.") + scheme);
  };
  const double implicit = rate("moreau_implicit.0.001") / rate("moreau_implicit.0.0001") / 10;
  const double explicitly = rate("moreau_printed.euler.0.0002") / rate("moreau_printed.euler.0.0001") / 2;
  const double off = std::max(std::abs(implicit - 1), std::abs(explicitly - 1));
  judge(
      record,
      {"integrators.said.weakened", "LG03 6",
       "divergence and deadening weaken with the step, in proportion: largest relative deviation of rates", 1,
       1 + off, off, 0.15, true},
      "wrong",
      {"Section 6, step-size",
       "Reducing the step-size led to different results as the divergence or deadening was weakened", "", "",
       "Rates in flight: implicit, 1e-3 and 1e-4 s, " + text(10 * implicit, 4) +
           " : 1; Table 1 in Euler angles, 2e-4 and 1e-4 s, " + text(2 * explicitly, 3) + " : 1.",
       "Both are first order in Δt: no step is small enough, each is only slower."});

  const double body = of(found, "top.body_order.rk4_printed");
  judge(record,
        {"integrators.said.correct", "LG03 6",
         "converges for a reduction of the step-size: order, at least 1, of the time the body touches again, "
         "rk4_printed, 4e-4 to 5e-5 s",
         1, body, std::max(0.0, 1 - body), smooth, false},
        "imprecise",
        {"Section 6, the presented method",
         "The presented higher-order Runge–Kutta method gives the correct result and converges for a "
         "reduction of the "
         "step-size",
         "",
         "in smooth parts, with order one; through impacts results scatter, and in Euler angles only with "
         "small steps",
         "rk4_printed: θ(1 s) to " + n("top.error.rk4_printed", 2) + " rad at 1e-4 s, order " +
             n("top.order.rk4_printed") + "; when the body touches again: errors between " +
             n("top.body_least.rk4_printed", 2) + " and " + n("top.body_most.rk4_printed", 2) +
             " s for 4e-4 to 5e-5 s, without order (slope " + text(body, 2) +
             "). In the paper's Euler angles it breaks down at " + n("top.euler.rk4_printed.0.0001", 4) +
             " s with Δt = 1e-4 s, where the top comes within " + n("top.least_inclination", 2) +
             " rad of θ = 0; with 2e-5 s θ(1 s) is off by " + n("top.euler_error.rk4_printed.2e-05", 2) +
             " rad.",
         "Dissipative motion forgives much: hops of an inelastic contact change when things happen more than "
         "what "
         "happens."});

  const double omega = of(found, "nutation.frequency.floor"), growth = of(found, "nutation.growth.floor");
  const double tip_omega = of(found, "nutation.frequency.tip"), on_tip = of(found, "nutation.growth.tip");
  const double decay = std::max({0.0, -growth / omega, -on_tip / tip_omega});
  judge(
      record,
      {"integrators.said.undamped", "LG03 6",
       "almost no damping of the nutation: its rate of decay over its frequency, the larger one of body and "
       "tip",
       0, decay, decay, 0.01, false},
      "imprecise",
      {"Section 6, nutation",
       "The Tippe-Top experiences almost no damping and exhibits high-frequency oscillation in the nutation",
       "", "on the body it grows, on the tip it is damped",
       "First 0.15 s: on the body, start of 5.4, ω = " + text(omega, 4) +
           " rad/s and the amplitude changes at " + text(growth, 2) +
           " 1/s, fed by the slip; on the tip, 0.1 rad from upright, 180 rad/s, ω = " + text(tip_omega, 4) +
           " rad/s and " + text(on_tip, 2) + " 1/s.",
       "A scheme must change amplitudes more slowly than that: ω²Δt/2 well below 1 1/s asks for Δt well "
       "below 1e-4 s "
       "of a first-order scheme."});
}

}  // namespace verify::integrators
