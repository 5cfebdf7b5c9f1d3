// Contacts with hardly any drilling friction solved as point contacts: the bounds bound, against solutions
// with all rows.

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "contensou/integrate/coulomb_limit.hpp"
#include "stepping_problems.hpp"

using namespace contensou;
using namespace stepping_problems;

namespace {

constexpr double mu = 0.3, radius = 0.5;
constexpr Method methods[] = {Method::moreau, Method::moreau_implicit, Method::moreau_adaptive};

const AnyFriction uniform{FrictionBall(SmoothPlate(UniformLaw{}))};
const AnyFriction ellipsoid{FrictionBall(SmoothPlate(EllipsoidLaw({.xi = 1, .eta = 0.5})))};

Slab slab(const AnyFriction& friction, Slab::Push push = {}) {
  return Slab({"floor", friction, mu, radius, 0}, std::move(push));
}

/// The norm of kinetic energy, √(δuᵀMδu).
double norm(const Eigen::VectorXd& u) {
  return std::sqrt(Slab::m * u.head<3>().squaredNorm() + Slab::j * u[3] * u[3]);
}
/// What friction that is wrong by an impulse ε in γ_T and in γ_τ alike does to velocities, in that norm.
const double mobility = std::sqrt(1 / Slab::m + radius * radius / Slab::j);

double number(std::mt19937_64& g) { return static_cast<double>(g() >> 11) * 0x1p-52 - 1; }

}  // namespace

TEST_CASE("Coulomb limit: just where the friction left out is the fidelity", "[integrate][fidelity]") {
  for (const AnyFriction* friction : {&system_test::hertz, &uniform, &ellipsoid}) {
    for (const double fidelity : {0.3, 1e-2, 1e-4, 1e-8}) {
      const CoulombLimit limit(*friction, fidelity);
      const double u = limit.slip_ratio();
      CAPTURE(friction->index(), fidelity, u);
      CHECK(limit.error(u, 1) <= fidelity);
      CHECK(limit.error((1 - 1e-5) * u, 1) > fidelity);
      CHECK(limit.error(3 * u, 2) <= fidelity);
    }
  }
  // η → 1/(4u) for uniform pressure, the next term a part 1/u² smaller.
  CHECK(CoulombLimit(uniform, 1e-4).slip_ratio() == Approx(2500).epsilon(1e-5));
  for (const AnyFriction& none :
       {AnyFriction{NoFriction{}}, AnyFriction{FrictionDisk{}}, AnyFriction{FrictionCylinder(0.5)}}) {
    CHECK(std::isinf(CoulombLimit(none, 0.4).slip_ratio()));
  }
  CHECK(CoulombLimit(AnyFriction{FrictionCylinder(0.01)}, 0.02).slip_ratio() < 1e-8);
  CHECK(std::isinf(CoulombLimit().slip_ratio()));
}

TEST_CASE("Coulomb limit: a bound that is near the error", "[integrate][fidelity]") {
  CoulombLimit limit(system_test::hertz, 0.05);
  const double least = limit.slip_ratio();
  for (const double step : {0.97, 1.03, 1.5}) {
    for (double u = step < 1 ? 40 * least : least; u >= least && u <= 40 * least; u *= step) {
      CAPTURE(u / least);
      CHECK(limit.bound(u, 1) >= limit.error(u, 1));
      CHECK(limit.bound(u, 1) <= 0.05);
      // η falls like 1/u here, over a tenth.
      CHECK(limit.bound(u, 1) <= 1.12 * limit.error(u, 1));
    }
  }
  CHECK(limit.bound(1, 0) < 1e-15);
}

TEST_CASE("Fidelity: the bound of one step, at random states", "[integrate][fidelity]") {
  // Backward Euler is a resolvent of friction, which is monotone: two frictions that differ by ε in the place
  // that one finds lead to velocities that differ by no more.
  std::mt19937_64 g(41);
  int points = 0;
  for (int k = 0; k < 400; ++k) {
    const AnyFriction& friction = k % 2 == 0 ? system_test::hertz : uniform;
    const double fidelity = std::pow(10, 2 * number(g) - 2.5);
    const double speed = std::pow(10, number(g));
    const double spin = speed / radius * fidelity * std::pow(10, 1.5 * number(g));
    const State start = Slab::at(0, {speed * std::cos(k), speed * std::sin(k), 0, spin});
    RunReport report;
    const State exact = end_of(slab(friction), start, 0.01, Method::moreau_implicit, 0.01);
    const State found =
        end_of(slab(friction), start, 0.01, Method::moreau_implicit, 0.01, &report, {.fidelity = fidelity});
    CAPTURE(k, fidelity, speed, spin);
    REQUIRE(report.left_out.as_coulomb <= 1);
    CHECK(report.left_out.friction <= fidelity);
    CHECK(report.left_out.impulse ==
          Approx(report.left_out.friction * mu * Slab::m * Slab::g * 0.01).epsilon(1e-12));
    CHECK(norm(found.u - exact.u) <= mobility * report.left_out.impulse + 1e-13 * (1 + speed));
    if (report.left_out.as_coulomb == 0) CHECK((found.u - exact.u).norm() <= 1e-13 * (1 + speed));
    points += static_cast<int>(report.left_out.as_coulomb);
  }
  CHECK(points > 100);
  CHECK(points < 300);
}

TEST_CASE("Fidelity: the bound of a run that ends with all rows", "[integrate][fidelity]") {
  // Fast and hardly spinning at first; sliding and spin end together, so later all rows are needed.
  const State start = Slab::at(0, {3, 1, 0, 1});
  for (const Method method : methods) {
    for (const double t_end : {0.2, 0.8, 1.5}) {
      const IntegratorOptions loose{.tolerance = 1e-5, .fidelity = 0.1};
      RunReport exact_report, report;
      const State exact =
          end_of(slab(uniform), start, t_end, method, 1e-3, &exact_report, {.tolerance = 1e-5});
      const State found = end_of(slab(uniform), start, t_end, method, 1e-3, &report, loose);
      CAPTURE(name(method), t_end);
      REQUIRE(report.status == RunStatus::finished);
      CHECK(report.left_out.as_coulomb > 0);
      CHECK(report.left_out.friction <= 0.1);
      // η is 1/(4u) at first, u = 6.3; later the least slip ratio less a margin of a quarter is reached.
      CHECK(report.left_out.friction > (t_end == 0.2 ? 0.04 : 0.07));
      // By the steps' own errors more in the adaptive one, which are not the same.
      const double steps = method == Method::moreau_adaptive ? 1e-3 : 1e-12;
      CHECK(norm(found.u - exact.u) <= mobility * report.left_out.impulse + steps);
      CHECK(exact_report.left_out.as_coulomb == 0);
      CHECK(exact_report.left_out.impulse == 0);
      if (t_end == 0.2 && method != Method::moreau_adaptive) {
        CHECK(report.left_out.as_coulomb == (method == Method::moreau ? 2 : 1) * report.steps);
        CHECK(norm(found.u - exact.u) > 0.05 * mobility * report.left_out.impulse);
      }
      if (t_end == 1.5) CHECK(found.u.norm() <= 1e-12);
    }
  }
}

TEST_CASE("Fidelity: a step that leaves the limit is made again with all rows", "[integrate][fidelity]") {
  // Within a step of 0.1 s friction takes μgΔt = 0.3 m/s of 0.4: from 1.3 times the least slip ratio to 0.33.
  const double least = CoulombLimit(uniform, 0.05).slip_ratio();
  const State start = Slab::at(0, {0.4, 0, 0, 0.4 / (1.3 * least * radius)});
  RunReport exact_report, report;
  const State exact = end_of(slab(uniform), start, 0.1, Method::moreau_implicit, 0.1, &exact_report);
  const State found =
      end_of(slab(uniform), start, 0.1, Method::moreau_implicit, 0.1, &report, {.fidelity = 0.05});
  CHECK(report.left_out.as_coulomb == 0);
  CHECK(report.contact_problems > exact_report.contact_problems);
  CHECK((found.u - exact.u).norm() <= 1e-14);
}

TEST_CASE("Fidelity: where nothing can be left out nothing changes", "[integrate][fidelity]") {
  const TippeTopAxis top = paper_top();
  for (const Method method : methods) {
    for (const State& start : {top.start(0.1, 180), top_in_flight(top)}) {
      RunReport report;
      const State off = end_of(top, start, 0.05, method, 1e-4);
      const State on = end_of(top, start, 0.05, method, 1e-4, &report, {.fidelity = 1e-300});
      CHECK(report.left_out.as_coulomb == 0);
      CHECK(off.q == on.q);
      CHECK(off.u == on.u);
    }
  }
}

TEST_CASE("Fidelity: with a radius that follows the load", "[integrate][fidelity]") {
  SystemContact floor{"floor", uniform, mu, 0.7, 0};
  const double weight = Slab::m * Slab::g;
  floor.load_radius =
      LoadRadius{.relative_radius = 4 * radius * radius * radius / (3 * weight), .modulus = 1};
  const State start = Slab::at(0, {3, 1, 0, 1});
  RunReport by_load, by_hand;
  const State a = end_of(Slab(floor), start, 0.8, Method::moreau, 1e-3, &by_load, {.fidelity = 0.1});
  const State b = end_of(slab(uniform), start, 0.8, Method::moreau, 1e-3, &by_hand, {.fidelity = 0.1});
  CHECK((a.u - b.u).norm() <= 1e-12);
  // In its first stage the contact has no load yet and so no radius: that one is looked at after the solve.
  CHECK(by_load.left_out.as_coulomb == by_hand.left_out.as_coulomb);
  CHECK(by_load.left_out.friction == Approx(by_hand.left_out.friction).epsilon(1e-10));
}

TEST_CASE("Fidelity: what is asked for is a number > 0", "[integrate][fidelity]") {
  State state = Slab::at(0, {1, 0, 0, 1});
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(integrate(slab(uniform), state, 1, {.method = Method::moreau, .fidelity = bad}),
                    std::invalid_argument);
  }
}
