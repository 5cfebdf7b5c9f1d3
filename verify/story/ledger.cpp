#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "checks.hpp"

namespace verify::story {
namespace {

std::string text(double x, int digits = 4) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.*g", digits, x);
  return buffer;
}
/// A time of both pressures.
std::string both(const Told& told, double Times::*time) {
  return "Hertz " + text(told.hertz.*time, 6) + " s, uniform " + text(told.uniform.*time, 6) + " s";
}
std::string between(const Told& told, double Times::*from, double Times::*to) {
  return "Hertz " + text(told.hertz.*from, 5) + " to " + text(told.hertz.*to, 5) + " s, uniform " +
         text(told.uniform.*from, 5) + " to " + text(told.uniform.*to, 5) + " s";
}
std::string period(const Times& t) { return text(t.both_from, 3) + " < t < " + text(t.both_to, 3); }
std::string degrees(double radians) { return text(radians * 180 / std::numbers::pi, 3) + "°"; }

struct Sentence {
  std::string where;
  std::string printed;
  std::string corrected = {};
  std::string evidence = {};
  std::string consequence = {};
};
/// The verdict is the numbers': `flaw` and the correction stand only where it does not hold.
void enter(Record& record, const Sentence& s, bool holds, const char* flaw) {
  record.add(LedgerRow{.where = s.where,
                       .printed = s.printed,
                       .verdict = holds ? "holds" : flaw,
                       .corrected = holds ? "" : s.corrected,
                       .evidence = s.evidence,
                       .consequence = s.consequence});
}

bool near(const Told& told, double Times::*time) {
  return std::abs(told.hertz.*time - printed.*time) <= reading ||
         std::abs(told.uniform.*time - printed.*time) <= reading;
}

void events(const Told& told, const Weighed& weighed, Record& record) {
  enter(record,
        {.where = "Section 5.4, nutation",
         .printed = "A high-frequency nutational oscillation is superimposed on the global motion",
         .evidence = "Maxima of θ before the stick touches: " + text(told.nutation, 3) +
                     " rad/s; θ = π/2 at " + text(told.inverting, 3) + " s, after some " +
                     text(std::round(told.inverting * told.nutation / (2 * std::numbers::pi)), 3) +
                     " nutations",
         .consequence = "The inversion goes on by nutations: times of touching change by steps of some 0.04 "
                        "s where data change."},
        told.inverting * told.nutation > 10 * 2 * std::numbers::pi, "wrong");
  enter(record,
        {.where = "Section 5.4, stick touches",
         .printed = "The stick touches the floor at t = 1.5 s",
         .corrected = "at t = " + text(told.hertz.tip, 3) + " s",
         .evidence = both(told, &Times::tip) + ", to " + text(told.digits, 1) + " relative",
         .consequence = "For what could make 1.5 s see the table of hypotheses: not the pressure, not the "
                        "truncated series."},
        near(told, &Times::tip), "wrong");
  enter(record,
        {.where = "Section 5.4, body leaves",
         .printed = "after which the body loses contact with the floor",
         .evidence =
             "At the same instant, in the impact of the stick: Hertz " + text(told.body_leaves, 6) + " s"},
        told.body_leaves >= told.hertz.tip && told.body_leaves - told.hertz.tip < reading, "imprecise");
  enter(record,
        {.where = "Section 5.4, upright",
         .printed = "The top turns almost completely upright on the stick during the period 1.6 < t < 4 s",
         .corrected = "θ > 0.95π during " + text(told.hertz.upright_from, 3) + " < t < " +
                      text(told.hertz.upright_to, 3) + " s (Hertz)",
         .evidence = "θ > 0.95π: " + between(told, &Times::upright_from, &Times::upright_to),
         .consequence = "\"Almost\" names no bound."},
        near(told, &Times::upright_from) && near(told, &Times::upright_to), "imprecise");
  enter(record,
        {.where = "Section 5.4, re-inversion",
         .printed = "The rotational speed is gradually reduced by the friction, which causes a re-inversion "
                    "of the top, t > 4 s",
         .corrected = "t > " + text(told.hertz.turning, 2) + " s (Hertz)",
         .evidence = "θ is largest at: " + both(told, &Times::turning) + ", the spin then " +
                     text(told.spin_at_turning, 3) +
                     " rad/s; without the drilling torque it stays upright for 30 s",
         .consequence = "It is the drilling torque alone that slows a top that spins upright."},
        near(told, &Times::turning), "imprecise");
  enter(
      record,
      {.where = "Section 5.4, body touches",
       .printed = "The re-inversion causes the body to touch the floor at t = 4.55 s",
       .corrected = "at t = " + text(told.hertz.body, 3) + " s (Hertz), " + text(told.uniform.body, 3) +
                    " s (uniform)",
       .evidence = both(told, &Times::body) + ". A percent of one of the data changes it by up to " +
                   text(weighed.percent, 2) + " s; of " + std::to_string(weighed.tried) + " single changes " +
                   std::to_string(weighed.agreeing) + " give all four times of contact within 0.05 s",
       .consequence = "The top stands near an unstable position for seconds; when it leaves depends on "
                      "everything before."},
      near(told, &Times::body), "wrong");
  enter(record,
        {.where = "Section 5.4, rocking",
         .printed = "A rocking motion is initiated, which ends in an accumulation point of impacts",
         .evidence = std::to_string(told.impacts) +
                     " impacts located, accumulating at: " + both(told, &Times::both_from)},
        told.impacts > 10, "wrong");
  enter(record,
        {.where = "Section 5.4, double contact",
         .printed = "The top remains in double-point contact during the period 4.65 < t < 5.4 s",
         .corrected = period(told.hertz) + " s (Hertz), " + period(told.uniform) + " s (uniform)",
         .evidence = between(told, &Times::both_from, &Times::both_to),
         .consequence = "It lasts " + text(told.hertz.both_to - told.hertz.both_from, 2) + " s and " +
                        text(told.uniform.both_to - told.uniform.both_from, 2) + " s, the paper's 0.75 s."},
        near(told, &Times::both_from) && near(told, &Times::both_to), "wrong");
  enter(record,
        {.where = "Section 5.4, end",
         .printed = "Finally, the contact between stick and floor is opened and the top gradually turns to "
                    "its trivial "
                    "non-rotating equilibrium position",
         .corrected = "… and the top ends rolling on the side of its body, for ever",
         .evidence = "Hertz: from " + text(told.rolling, 5) + " s ω_z = 0 and it rolls, θ between " +
                     degrees(told.rolls_least) + " and " + degrees(told.rolls_largest) + ", spin " +
                     text(told.spin_30, 4) + " rad/s and " + text(100 * told.energy_30, 3) +
                     " % of the energy left at 30 s",
         .consequence = "The law has no rolling resistance: a sphere that rolls with ω_z = 0 loses nothing. "
                        "What brings a toy to "
                        "rest is not in this model."},
        told.theta_30 < 0.01, "wrong");
  enter(record,
        {.where = "Section 5.4, Euler angles",
         .printed = "the motion was simulated in Euler angles",
         .corrected = "coordinates without a singularity at θ = 0",
         .evidence = "In the first nutations θ goes down to " + text(told.least_theta, 2) + " rad, at " +
                     text(told.least_theta_at, 4) + " s, where φ̇ and ψ̇ grow like 1/sin θ",
         .consequence = "With fixed steps of some 1e-4 s a run ends there or leaves it on another motion; "
                        "adaptive steps pass."},
        told.least_theta > 0.05, "imprecise");
}

void radius(const Radii& radii, Record& record) {
  enter(
      record,
      {.where = "5.5, Fig. 12, slower inversion",
       .printed = "Apparently, a smaller contact radius causes a slower inversion of the Tippe-Top",
       .corrected = "below R = 1e-4 m; the inversion is fastest about R = " + text(radii.fastest, 3) + " m",
       .evidence = "θ = π/2 (Hertz, start of 5.4) at " + text(radii.at_least, 4) + " s for R = 1e-5 m, " +
                   text(radii.at_fastest, 4) + " s for " + text(radii.fastest, 3) + " m, " +
                   text(radii.at_paper, 4) + " s for 5e-4 m, " + text(radii.at_largest, 4) + " s for 2e-3 m",
       .consequence =
           "The paper's R = 5e-4 m lies on the other side, where a smaller radius inverts faster."},
      radii.fastest >= 2e-3, "imprecise");
}

void coulomb(const Limit& limit, Record& record) {
  enter(record,
        {.where = "5.5, Coulomb friction, pendulum motion",
         .printed = "With R = 0 and a pure-rolling start the top performs a pendulum motion, purely rolling, "
                    "with a frequency "
                    "given by (5.37)",
         .evidence = "θ_0 = 1e-3: precession " + text(limit.precession, 6) + ", nutation of θ " +
                     text(limit.nutation, 6) + " rad/s; (5.37) has " + text(limit.precession_537, 6) +
                     " and, as the difference of its two, " + text(limit.nutation_537, 6),
         .consequence = "Two frequencies; what is seen is the slow precession."},
        std::abs(limit.precession / limit.precession_537 - 1) < 1e-3 &&
            std::abs(limit.nutation / limit.nutation_537 - 1) < 1e-3,
        "wrong");
  record.add(LedgerRow{"5.5, Coulomb friction, air",
                       "Additional dissipation due to air resistance will even damp out the oscillation",
                       "not checkable", "", "No resistance of air is in the model", ""});
  enter(record,
        {.where = "5.5, Coulomb friction, rolling start",
         .printed = "the Tippe-Top would under the assumption of Coulomb friction not invert at all if it "
                    "was initiated with a "
                    "pure rolling initial condition",
         .evidence =
             "θ_0 = 1e-3 to 0.3, μ = 0.3, 30 s: the largest θ/θ_0 is " + text(limit.largest_rolling, 8)},
        limit.largest_rolling < 1 + 1e-6, "wrong");
  record.add(LedgerRow{"5.5, Coulomb friction, Lyapunov",
                       "there might exist slipping initial conditions arbitrary close to the trivial "
                       "equilibrium for which the motion diverges",
                       "not checkable", "",
                       "None among " + std::to_string(limit.slipping) +
                           " slipping starts at θ_0 = 1e-4 to 1e-2: θ stays below " +
                           text(limit.largest_slipping, 3) +
                           " times the larger of θ_0 and v/(r_1ψ̇_0). From the start of 5.4 θ never exceeds " +
                           text(limit.start_54, 3) + " rad",
                       "Slip near the equilibrium ends within milliseconds, since μg is not small; none "
                       "found is no proof of none."});
}

void conclusions(const Told& told, const Limit& limit, Record& record) {
  enter(record,
        {.where = "Section 6, damping",
         .printed = "The Tippe-Top experiences almost no damping",
         .corrected = "the nutation is hardly damped; the motion as a whole is",
         .evidence = text(100 * (1 - told.energy_at_tip), 3) +
                     " % of the energy is gone when the stick touches, at " + text(told.hertz.tip, 3) + " s",
         .consequence = "In one nutation it is " +
                        text(100 * (1 - std::pow(told.energy_at_tip,
                                                 2 * std::numbers::pi / told.nutation / told.hertz.tip)),
                             2) +
                        " %: little enough to need a scheme that adds none."},
        told.energy_at_tip > 0.9, "imprecise");
  enter(record,
        {.where = "Section 6, importance",
         .printed =
             "The importance of Coulomb–Contensou friction was illustrated by an analysis on the Tippe-Top",
         .evidence = "From the start of 5.4: with R = 5e-4 m θ = π/2 at " + text(told.inverting, 3) +
                     " s; with Coulomb friction θ never exceeds " + text(limit.start_54, 3) + " rad in 30 s",
         .consequence =
             "The ellipsoid with the same semi-axes does nearly as well: see the table of hypotheses."},
        limit.start_54 < std::numbers::pi / 2, "wrong");
}

}  // namespace

void enter_ledger(const Told& told, const Weighed& weighed, const Radii& radii, const Limit& limit,
                  Record& record) {
  events(told, weighed, record);
  radius(radii, record);
  coulomb(limit, record);
  conclusions(told, limit, record);
}

}  // namespace verify::story
