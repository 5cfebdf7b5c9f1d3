// The oracles of the shipped scenes against what is known otherwise.
#include <catch2/catch.hpp>
#include <cmath>

#include "contensou/law/uniform.hpp"
#include "motions/slide_and_spin.hpp"
#include "scenes/ball.hpp"
#include "scenes/pushed.hpp"
#include "scenes/slide_to_rest.hpp"

using namespace verify::answers;

namespace {

constexpr double exponents[] = {0, 0.5, 1};  // uniform, Hertz, paraboloid
constexpr double quadrature = 1e-12;         // ten times the tolerance of one integral

}  // namespace

TEST_CASE("Answers: the friction of a patch in its closed cases", "[verify][answers]") {
  const double pi = std::acos(-1.0);
  for (const double n : exponents) {
    const Patch patch(n);
    CAPTURE(n);
    CHECK(std::abs(patch.at(1, 0).xi - 1) < quadrature);
    CHECK(patch.at(1, 0).eta == 0);
    CHECK(std::abs(patch.at(0, 1).eta / patch.torque_at_rest() - 1) < quadrature);
    CHECK(std::abs(patch.at(1e-5, 1).xi / (1e-5 * patch.slope_at_rest()) - 1) < 1e-9);  // next term: u²
  }
  CHECK(std::abs(Patch(0).torque_at_rest() - 2.0 / 3) < quadrature);
  CHECK(std::abs(Patch(0.5).torque_at_rest() - 3 * pi / 16) < quadrature);
  CHECK(std::abs(Patch(1).torque_at_rest() - 8.0 / 15) < quadrature);
  // Hertz, u <= 1: LG03 (3.17)
  const double u = 0.7;
  CHECK(std::abs(Patch(0.5).at(u, 1).xi - 3 * pi / 8 * (u - u * u * u / 4)) < quadrature);
  // A seam at u = 1
  for (const double n : exponents) {
    const Patch patch(n);
    CHECK(std::abs(patch.at(1, 1 - 1e-13).xi - patch.at(1, 1 + 1e-13).xi) < quadrature);
    CHECK(std::abs(patch.at(1, 1 - 1e-13).eta - patch.at(1, 1 + 1e-13).eta) < quadrature);
  }
}

TEST_CASE("Answers: where sliding and spinning end", "[verify][answers]") {
  CHECK(std::abs(final_ratio(Patch(0), 0.5) - 0.653) < 5e-4);  // Farkas et al., PRL 90 (2003) 248302
  CHECK(limits(0).spins_only == Approx(2.0 / 3));              // Weidman, Malhotra, PRL 95 (2005) 264303
  CHECK(limits(0).slides_only == Approx(0.25));
  for (const double kappa : {0.25, 0.3, 0.4, 0.49}) {
    CAPTURE(kappa);
    CHECK(std::abs(final_ratio(Patch(0.5), kappa) - final_ratio_hertz(kappa)) < 100 * quadrature);
  }
  for (const double n : exponents) {
    const Patch patch(n);
    const Limits border = limits(n);
    CAPTURE(n);
    CHECK(std::abs(ratio(patch, 1) - border.equal) < quadrature);
    CHECK(std::abs(ratio(patch, 1e-6) - border.spins_only) < 1e-11);
    CHECK(std::abs(ratio(patch, 1e6) - border.slides_only) < 1e-11);
    CHECK(final_ratio(patch, border.spins_only) == 0);
    CHECK(std::isinf(final_ratio(patch, border.slides_only)));
    CHECK(std::abs(final_ratio(patch, border.equal) - 1) < 100 * quadrature);
  }
}

TEST_CASE("Answers: sliding and spinning to rest by two quadratures", "[verify][answers]") {
  // Constant u: linear.
  const double u = final_ratio(Patch(0), 0.5), a = 0.981, s = 1.3;
  const SlideToRest steady(Patch(0), a, 0.5, u * s, s);
  const double time = u * s / (a * Patch(0).at(u, 1).xi);
  CHECK(std::abs(steady.stopping_time() - time) < 1e-11);
  CHECK(std::abs(steady.slid() - u * s * time / 2) < 1e-11);
  CHECK(std::abs(steady.at(time / 2).ratio() - u) < 1e-11);
  for (const double v : {0.4, 2.0}) {
    const SlideToRest slide(Patch(0), a, 0.5, v, s);
    const known_motions::SlideAndSpin known(contensou::UniformLaw{}, a, 2 * a, v, s);
    CAPTURE(v);
    CHECK(std::abs(slide.stopping_time() - known.stopping_time()) < 1e-11);
    const auto end = known.at(10);
    CHECK(std::abs(slide.slid() - end.slid) < 1e-11);
    CHECK(std::abs(slide.turned() - end.turned) < 1e-11);
    const auto late = known.at(0.9 * known.stopping_time());
    const auto point = slide.at(0.9 * known.stopping_time());
    CHECK(std::abs(point.v - late.v) < 1e-11);
    CHECK(std::abs(point.s - late.s) < 1e-11);
    CHECK(std::abs(point.slid - late.slid) < 1e-11);
  }
}

TEST_CASE("Answers: a pushed patch", "[verify][answers]") {
  const Pushed machine(Patch(0), 3.4, 3.8);
  const double push = 0.44, end = machine.terminal_speed(push);
  CHECK(std::abs(3.4 * Patch(0).at(end, 3.8).xi - push) < 1e-11);
  CHECK(std::abs(machine.speed(push, end, 10) - end) < 1e-11);
  CHECK(std::abs(machine.rate(0) - 3.4 / 3.8) < 1e-8);  // ξ'(0) = 1
  // It comes closer like e^−rate t.
  const double from = end + 1e-5, t = 2;
  CHECK((machine.speed(push, from, t) - end) / 1e-5 ==
        Approx(std::exp(-machine.rate(push) * t)).epsilon(1e-4));
}

TEST_CASE("Answers: balls", "[verify][answers]") {
  CHECK(rolling_speed(0.7, 0.7) == Approx(0.5));
  // Without a patch the groove is Coulomb's: 5/2 μg/r.
  CHECK(groove_about_vertical(Patch(0), 0.03, 1e-9, 0.3, 9.81) == Approx(2.5 * 0.3 * 9.81 / 0.03));
  CHECK(groove_about_its_axis(0.03, 0, 9.81) == 0);
}
