#include "contensou/integrate/rk4_printed.hpp"

#include <catch2/catch.hpp>

#include "stepping_problems.hpp"

using namespace contensou;
using namespace stepping_problems;

namespace {

constexpr auto printed = Method::rk4_printed;
const AnyFriction frictionless{NoFriction{}};
const AnyFriction disk{FrictionDisk{}};

/// Slowed down by its velocity alone, −1/s.
class Dragged final : public Slab {
 public:
  using Slab::Slab;
  void force(double, ConstVector, ConstVector u, VectorRef h) const override {
    h = -u.cwiseProduct(Eigen::Vector4d(m, m, m, j));
  }
};

}  // namespace

TEST_CASE("Table 2: fourth order where accelerations depend on velocities alone", "[integrate][printed]") {
  const Dragged dragged({"floor", frictionless});
  const auto error = [&](double h) {
    return std::abs(end_of(dragged, Slab::at(1, {1, 0, 0, 0}), 1, printed, h).q[0] - (1 - std::exp(-1)));
  };
  const double order = std::log2(error(0.1) / error(0.05));
  CHECK(order > 3.8);
  CHECK(order < 4.2);
}

TEST_CASE("Table 2: first order in free flight and in slip, not fourth", "[integrate][printed]") {
  const TippeTopAxis top = paper_top();
  const auto order_of = [&](const State& start, const State& reference) {
    const double coarse = difference(top, end_of(top, start, reference.t, printed, 1e-4), reference);
    const double fine = difference(top, end_of(top, start, reference.t, printed, 5e-5), reference);
    return std::log2(coarse / fine);
  };
  const State flying = top_in_flight(top);
  const double flight = order_of(flying, SmoothReference(top, -1).run(flying, flight_time, 500));
  CHECK(flight > 0.9);
  CHECK(flight < 1.1);
  const State resting = top.start(0.1, 180);
  const double slip = order_of(resting, SmoothReference(top, 0, hertz_border).run(resting, slip_time, 500));
  CHECK(slip > 0.85);
  CHECK(slip < 1.15);
}

TEST_CASE("Table 2: forces that depend on time are felt half of Δt₂ late", "[integrate][printed]") {
  // F_z/m = g + 6t: a polynomial that order four would integrate exactly; u(1) = 3 at the letter's t + Δt/8.
  const Slab slab({"floor", frictionless},
                  [](double t) { return Eigen::Vector4d(0, 0, Slab::m * (Slab::g + 6 * t), 0); });
  const double h = 0.01;
  const State end = end_of(slab, Slab::at(1, {0, 0, 0, 0}), 1, printed, h);
  CHECK(end.u[2] == Approx(3 + 6 * h / 8).epsilon(1e-13));
}

TEST_CASE("Table 2: an inelastic impact throws back with a third of the velocity", "[integrate][printed]") {
  // From αvΔt above the floor, v >> gΔt, by the stages that find the body approaching in the floor, each with
  // a = 4v/Δt: the first and the fourth (α <= 1/8) or the second (α <= 5/8) leave +v/3; the fourth alone
  // −v/3, with the body then in the floor by (1 − α)vΔt. From there the first and third turn that into +v/3,
  // or, where the third is out of the floor again (1 − α < 1/8), the first and fourth into +v/9.
  const Slab slab({"floor", frictionless});
  const double h = 1e-6, v = 10;
  const double gravity = 8 * Slab::g * h;
  for (int k = 0; k < 40; ++k) {
    const double alpha = (k + 0.5) / 40;
    const State start = Slab::at(alpha * v * h, {0, 0, -v, 0});
    const State end = end_of(slab, start, h, printed, h);
    CAPTURE(alpha);
    CHECK(end.u[2] == Approx(alpha < 0.625 ? v / 3 : -v / 3).margin(gravity));
    if (alpha > 0.625)
      CHECK(end_of(slab, start, 2 * h, printed, h).u[2] ==
            Approx(alpha < 0.875 ? v / 3 : v / 9).margin(gravity));
  }
}

TEST_CASE("Table 2: stick is unstable where all stages touch: R(-4) = 5", "[integrate][printed]") {
  // In the floor by what integrate() takes for rounding, and sinking by far less in all steps together; so
  // slow that friction's bounds are far.
  const Slab slab({"floor", disk, 0.5});
  State state = Slab::at(-1e-13, {1e-16, 0, 0, 0});
  const double h = 1e-9;
  IntegratorOptions exact;
  exact.solver_tolerance = 1e-26;
  for (int k = 1; k <= 4; ++k) {
    const double before = state.u[0];
    state = end_of(slab, state, state.t + h, printed, h, nullptr, exact);
    CAPTURE(k);
    CHECK(state.u[0] / before == Approx(5).epsilon(1e-6));
  }
}

TEST_CASE("Table 2: a body at rest exactly on the floor stays, one that is touched hovers",
          "[integrate][printed]") {
  const Slab slab({"floor", frictionless});
  const double h = 1e-3;
  CHECK(end_of(slab, Slab::at(0, {0, 0, 0, 0}), 1, printed, h).q[2] == 0);
  const State end = end_of(slab, Slab::at(0, {0, 0, -1e-9, 0}), 1, printed, h);
  CHECK(end.q[2] > 0);
  CHECK(end.q[2] < Slab::g * h * h);
  CHECK(std::abs(end.u[2]) < 1e-12);
}

TEST_CASE("Table 2: energy taken out is accounted for", "[integrate][printed]") {
  const Slab slab({"floor", frictionless});
  for (const double z : {0.1, 0.1003}) {
    RunReport report;
    const State end = end_of(slab, Slab::at(z, {0, 0, 0, 0}), 3, printed, 1e-4, &report);
    const double lost = slab.potential_energy(Slab::at(z, {}).q) - slab.potential_energy(end.q) -
                        slab.kinetic_energy(end.q, end.u);
    // In a step with contact forces of all sizes: gravity's work is by the stages', of order vgΔt m each
    // impact.
    CHECK(report.dissipated[0].total() == Approx(lost).epsilon(0.03));
  }
}
