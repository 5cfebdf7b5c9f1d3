#include "contensou/law/force.hpp"

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "contensou/law/catalogue.hpp"
#include "doubles.hpp"

using namespace contensou;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr Load unit{.mu = 1, .lambda_n = 1};

struct Named {
  const char* name;
  AnyLaw law;
};

/// Laws that depend on u = v/s only and have a potential.
const std::vector<Named>& homogeneous_laws() {
  static const std::vector<Named> laws{{"uniform", make_law("uniform")},
                                       {"hertz", make_law("hertz")},
                                       {"power:1", make_law("power:1")},
                                       {"uniform series", make_law("uniform", "series")},
                                       {"hertz series:4", make_law("hertz", "series:4")},
                                       {"hertz printed", make_law("hertz", "printed")},
                                       {"ellipsoid", make_law("uniform", "ellipsoid")}};
  return laws;
}

/// Every kind of law there is.
const std::vector<Named>& all_laws() {
  static const std::vector<Named> laws = [] {
    std::vector<Named> all = homogeneous_laws();
    for (const char* model : {"decoupled", "pade", "pade2", "tanh:0.5"})
      all.push_back({model, make_law("hertz", model)});
    return all;
  }();
  return laws;
}

FrictionForce force(const AnyLaw& any, const Load& load, const SlipVelocity& gamma) {
  return std::visit(
      [&](const auto& law) { return std::get<FrictionForce>(friction_force(law, load, gamma)); }, any);
}

double power(const AnyLaw& any, const Load& load, const SlipVelocity& gamma) {
  return std::visit([&](const auto& law) { return potential(law, load, gamma); }, any);
}

Eigen::Matrix3d second(const AnyLaw& any, const Load& load, const SlipVelocity& gamma) {
  return std::visit([&](const auto& law) { return hessian(law, load, gamma); }, any);
}

/// Points in general position: every octant, u on both sides of 1 and not near it, no part of γ_F small.
std::vector<SlipVelocity> generic_points() {
  std::vector<SlipVelocity> points;
  for (const double angle : {0.4, 1.9, -2.6, -0.3}) {
    for (const auto& [v, s] : {std::pair{0.5, 1.0}, {0.8, -1.3}, {1.0, 0.5}, {0.9, -0.3}}) {
      points.emplace_back(v * std::cos(angle), v * std::sin(angle), s);
    }
  }
  return points;
}

}  // namespace

TEST_CASE("The force opposes the slip", "[law][force]") {
  // The 3-4-5 triangle: n = (0.6, 0.8), v = 5, s = 2.
  const UniformLaw law;
  const auto [xi, eta] = law.at(5.0, 2.0);
  const Load load{.mu = 0.5, .lambda_n = 8};
  for (const double sign : {1.0, -1.0}) {
    const auto f = force(law, load, SlipVelocity(3 * sign, -4 * sign, 2 * sign));
    CHECK(f[0] == Approx(-sign * 4 * xi * 0.6).epsilon(4 * eps));
    CHECK(f[1] == Approx(sign * 4 * xi * 0.8).epsilon(4 * eps));
    CHECK(f[2] == Approx(-sign * 4 * eta).epsilon(4 * eps));
  }
}

TEST_CASE("Pure sliding is Coulomb, pure drilling the largest torque", "[law][force]") {
  for (const auto& [name, law] : homogeneous_laws()) {
    CAPTURE(name);
    const double eta_max = std::visit([](const auto& l) { return l.extent().eta; }, law);
    const auto sliding = force(law, {0.3, 10}, {0, -7, 0});
    CHECK(sliding[0] == 0);
    CHECK(sliding[1] == Approx(3).epsilon(4 * eps));
    CHECK(sliding[2] == 0);
    const auto drilling = force(law, {0.3, 10}, {0, 0, -7});
    CHECK(drilling[0] == 0);
    CHECK(drilling[1] == 0);
    CHECK(drilling[2] == Approx(3 * eta_max).epsilon(8 * eps));
  }
}

TEST_CASE("No negative zeros", "[law][force]") {
  for (const SlipVelocity& gamma : {SlipVelocity(1, 0, 0), SlipVelocity(0, 0, 1), SlipVelocity(0, 2, 3)}) {
    const auto f = force(HertzLaw{}, unit, gamma);
    for (int i = 0; i < 3; ++i) {
      if (f[i] == 0) CHECK_FALSE(std::signbit(f[i]));
    }
  }
}

TEST_CASE("γ_F times a power of two changes nothing, to the bit", "[law][force]") {
  // 3 bits in each component: exact down to the subnormals.
  const SlipVelocity gamma(3, -2.5, 1.25);
  for (const auto& [name, law] : homogeneous_laws()) {
    const auto reference = force(law, {0.3, 10}, gamma);
    const double phi = power(law, {0.3, 10}, gamma);
    const auto h = second(law, {0.3, 10}, gamma);
    // Beyond 2^±100 γ_F is scaled before use: both sides of that seam, too.
    for (const int k :
         {-1072, -1050, -1022, -500, -103, -102, -101, -100, -1, 1, 97, 98, 99, 100, 500, 1000, 1022}) {
      CAPTURE(name, k);
      const SlipVelocity scaled = gamma.unaryExpr([&](double x) { return std::ldexp(x, k); });
      CHECK(force(law, {0.3, 10}, scaled) == reference);
      if (k >= -1000) CHECK(power(law, {0.3, 10}, scaled) == std::ldexp(phi, k));
      if (k <= 1000) {
        CHECK(second(law, {0.3, 10}, scaled) == h.unaryExpr([&](double x) { return std::ldexp(x, -k); }));
      }
    }
  }
}

TEST_CASE("λ_N or μ times a power of two multiplies the force by it, to the bit", "[law][force]") {
  const SlipVelocity gamma(0.3, -0.7, 1.1);
  for (const auto& [name, law] : all_laws()) {
    const auto reference = force(law, {0.3, 10}, gamma);
    for (const int k : {-1000, -403, -402, -401, -3, 1, 397, 398, 399, 400, 1000}) {
      CAPTURE(name, k);
      const double factor = std::ldexp(1.0, k);
      CHECK(force(law, {0.3, 10 * factor}, gamma) == factor * reference);
      CHECK(force(law, {0.3 * factor, 10}, gamma) == factor * reference);
    }
  }
}

TEST_CASE("Turning the contact about its normal turns the force", "[law][force]") {
  for (const auto& [name, law] : all_laws()) {
    for (const SlipVelocity& gamma : generic_points()) {
      CAPTURE(name, gamma.transpose());
      const auto f = force(law, unit, gamma);
      // A quarter turn is exact.
      CHECK(force(law, unit, {-gamma[1], gamma[0], gamma[2]}) == FrictionForce(-f[1], f[0], f[2]));
      // Any other turn moves v by an ulp or two, n by as much, and ξ, η by no more than v relatively; the
      // printed law's cancellation (u <= 3) multiplies that by u⁴ = 81 at most.
      const double bound = (std::string(name) == "hertz printed" ? 81 : 1) * 16 * eps;
      for (const double angle : {0.1, 1.0, 2.5}) {
        Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
        turn.topLeftCorner<2, 2>() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
        CHECK((force(law, unit, turn * gamma) - turn * f).norm() <= bound);
      }
    }
  }
}

TEST_CASE("Force and power at the ends of the range of doubles", "[law][force]") {
  for (const auto& [name, law] : homogeneous_laws()) {
    CAPTURE(name);
    // ‖γ_T‖ is no double.
    const auto huge = force(law, unit, {largest, largest, 0});
    CHECK(huge[0] == Approx(-std::numbers::sqrt2 / 2).epsilon(4 * eps));
    CHECK(huge[1] == huge[0]);
    CHECK(power(law, {1e-5, 1e-5}, {largest, largest, 0}) ==
          Approx(largest * 1e-10 * std::numbers::sqrt2).epsilon(8 * eps));
    // γ_T of a few quanta has a direction, and a ratio to γ_τ of its own size.
    const auto tiny = force(law, unit, {3 * smallest, 4 * smallest, 0});
    CHECK(tiny[0] == Approx(-0.6).epsilon(4 * eps));
    CHECK(tiny[1] == Approx(-0.8).epsilon(4 * eps));
    CHECK(force(law, unit, {3 * smallest, 4 * smallest, 10 * smallest}) == force(law, unit, {3, 4, 10}));
    // μλ_N and 1/γ cancel, though neither product alone is a double.
    CHECK(force(law, {1e200, 1e-200}, {1, 0, 0})[0] == Approx(-1).epsilon(4 * eps));
    const double slope = -force(law, unit, {1e-9, 0, 1})[0] / 1e-9;
    CHECK(force(law, {1e200, 1e200}, {1e-150, 0, 1})[0] == Approx(-1e250 * slope).epsilon(1e-12));
    CHECK(power(law, {1e200, 1e200}, {1e-200, 0, 0}) == Approx(1e200).epsilon(8 * eps));
    // Overflow of the result, and its underflow.
    CHECK(force(law, {1e200, 1e200}, {1, 0, 0})[0] == -inf);
    CHECK(force(law, {1e200, 1e200}, {1, 0, 0})[1] == 0);
    CHECK(force(law, {1e-200, 1e-200}, {1, 0, 0})[0] == 0);
    // 1/γ is no double, but the second derivative is one.
    const auto h = second(law, {1e-10, 1e-10}, {0, 1e-310, 0});
    CHECK(h(0, 0) == Approx(1e-20 / 1e-310).epsilon(1e-12));  // 1e-310 itself is good to 1e-13
    CHECK(h(1, 1) == 0);
  }
}

TEST_CASE("At rest the friction is a set", "[law][force]") {
  const auto response = friction_force(HertzLaw{}, {0.5, 4}, SlipVelocity::Zero());
  REQUIRE(std::holds_alternative<FrictionSet>(response));
  CHECK(std::get<FrictionSet>(response).radius_t == 2);
  CHECK(std::get<FrictionSet>(response).half_height_tau == 2 * HertzLaw{}.extent().eta);
  CHECK(potential(HertzLaw{}, {0.5, 4}, SlipVelocity::Zero()) == 0);
  CHECK_THROWS_AS(hessian(HertzLaw{}, {0.5, 4}, SlipVelocity::Zero()), std::domain_error);
  CHECK(
      std::holds_alternative<FrictionSet>(friction_force(UniformLaw{}, unit, SlipVelocity(-0.0, 0.0, -0.0))));

  const auto unloaded = friction_force(HertzLaw{}, {0.5, 0}, SlipVelocity::Zero());
  CHECK(std::get<FrictionSet>(unloaded).radius_t == 0);
  CHECK(std::get<FrictionSet>(unloaded).half_height_tau == 0);
}

TEST_CASE("tanh regularisation has a number at rest, and its own scale", "[law][force]") {
  const TanhLaw law({1, 0.6}, 0.01);
  CHECK(std::get<FrictionForce>(friction_force(law, {0.5, 4}, SlipVelocity::Zero())) ==
        FrictionForce::Zero());
  CHECK(potential(law, {0.5, 4}, SlipVelocity::Zero()) == 0);
  CHECK(hessian(law, {0.5, 4}, SlipVelocity::Zero())
            .isApprox(Eigen::Vector3d(200, 200, 120).asDiagonal().toDenseMatrix(), 8 * eps));
  const auto slow = std::get<FrictionForce>(friction_force(law, unit, SlipVelocity(0.003, 0.004, 0)));
  CHECK(slow.head<2>().norm() == Approx(std::tanh(0.5)).epsilon(8 * eps));
  CHECK(potential(law, unit, SlipVelocity(0.003, 0.004, 0)) ==
        Approx(0.01 * std::log(std::cosh(0.5))).epsilon(1e-14));
}

TEST_CASE("Without load there is no force, whatever the slip", "[law][force]") {
  for (const auto& [name, law] : all_laws()) {
    CAPTURE(name);
    for (const Load& load : {Load{0, 5}, Load{0.5, 0}}) {
      CHECK(force(law, load, {1, 2, 3}) == FrictionForce::Zero());
      CHECK(power(law, load, {largest, largest, largest}) == 0);
      CHECK(second(law, load, {1, 2, 3}) == Eigen::Matrix3d::Zero());
    }
  }
}

TEST_CASE("Wrong load and slip are refused", "[law][force]") {
  const UniformLaw law;
  const SlipVelocity gamma(1, 0, 0);
  for (const double bad : {-1.0, inf, not_a_number}) {
    CAPTURE(bad);
    for (const Load& load : {Load{bad, 1}, Load{1, bad}}) {
      CHECK_THROWS_AS(friction_force(law, load, gamma), std::invalid_argument);
      CHECK_THROWS_AS(friction_force(law, load, SlipVelocity::Zero()), std::invalid_argument);
      CHECK_THROWS_AS(potential(law, load, gamma), std::invalid_argument);
      CHECK_THROWS_AS(hessian(law, load, gamma), std::invalid_argument);
    }
  }
  for (const double bad : {inf, -inf, not_a_number}) {
    for (int i = 0; i < 3; ++i) {
      SlipVelocity wrong(1, 2, 3);
      wrong[i] = bad;
      CHECK_THROWS_AS(friction_force(law, unit, wrong), std::domain_error);
      CHECK_THROWS_AS(potential(law, unit, wrong), std::domain_error);
      CHECK_THROWS_AS(hessian(law, unit, wrong), std::domain_error);
    }
  }
  CHECK_THROWS_WITH(friction_force(law, {-0.5, 1}, gamma),
                    "friction coefficient mu -0.5: expected a finite number >= 0");
}

TEST_CASE("Φ = −λ_F·γ_F (Euler)", "[law][force]") {
  for (const auto& [name, law] : homogeneous_laws()) {
    for (const SlipVelocity& gamma : generic_points()) {
      CAPTURE(name, gamma.transpose());
      const Load load{0.7, 3};
      CHECK(power(law, load, gamma) == Approx(-force(law, load, gamma).dot(gamma)).epsilon(16 * eps));
    }
  }
}

TEST_CASE("Hessian against central differences of the force", "[law][force][hessian]") {
  // Along each coordinate the force is analytic in a complex disc of radius r = 0.15 about the generic points
  // (the nearest singularities are ‖γ_T‖ = 0, v >= 0.5 away, and |u| = 1, |v² − s²|/(2|γ_i| + r) > 0.17 away)
  // and bounded by M = 2 there, so |∂³λ| <= 6 M/r³. Central differences err by h²/6 of that, plus rounding: 4
  // ulp of 1 over h; the printed law's rounding grows by u³ = 27 at most. tanh with ε = 0.5: poles π/4 away.
  const double h = 1e-5;
  const double r = 0.15;
  const double bound = h * h * 2 / (r * r * r) + 27 * 4 * eps / h;
  for (const auto& [name, law] : all_laws()) {
    if (std::string(name).starts_with("pade")) continue;  // no potential
    for (const SlipVelocity& gamma : generic_points()) {
      CAPTURE(name, gamma.transpose());
      const auto exact = second(law, unit, gamma);
      for (int j = 0; j < 3; ++j) {
        const SlipVelocity step = h * SlipVelocity::Unit(j);
        const FrictionForce slope =
            (force(law, unit, gamma + step) - force(law, unit, gamma - step)) / (2 * h);
        CHECK((exact.col(j) + slope).lpNorm<Eigen::Infinity>() <= bound);
      }
    }
  }
}

TEST_CASE("Hessian: symmetric, positive semi-definite, γ_F in its null space", "[law][force][hessian]") {
  std::vector<SlipVelocity> points = generic_points();
  for (const double u : {1e-6, 1e-2, 1 - eps / 2, 1.0, 1 + eps, 1e2, 1e6})
    points.emplace_back(0.6 * u, -0.8 * u, 1);
  for (const auto& [name, law] : all_laws()) {
    const bool homogeneous = !std::string(name).starts_with("pade") && !std::string(name).starts_with("tanh");
    const bool printed = std::string(name) == "hertz printed";  // its f'' is noise for large u
    for (const SlipVelocity& gamma : points) {
      if (printed && gamma.norm() > 10) continue;
      CAPTURE(name, gamma.transpose());
      const auto h = second(law, unit, gamma);
      CHECK(h == h.transpose());
      const double size = h.norm();
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(h);
      CHECK(eigen.eigenvalues().minCoeff() >= -16 * eps * size);
      if (homogeneous && std::string(name) != "decoupled") {
        CHECK((h * gamma).norm() <= 16 * eps * size * gamma.norm());
      }
    }
  }
}

TEST_CASE("Hessian on the axes is the limit from beside them", "[law][force][hessian]") {
  for (const auto& [name, law] : all_laws()) {
    if (std::string(name) == "decoupled") continue;
    CAPTURE(name);
    // γ_T = 0: f''(0)/s in every direction of the tangent plane. Beside it by 1e-12
    // the entries differ by about that, relatively to the largest one (a Padé form
    // of first order is not smooth there: its mixed entry is of order √u).
    const double near = 1e-12;
    const double first_order = std::string(name) == "pade" ? 10 * std::sqrt(near) : 0;
    const auto drilling = second(law, unit, {0, 0, -2});
    const auto nearly_drilling = second(law, unit, {0.6 * near, 0.8 * near, -2});
    CHECK(drilling(0, 0) == drilling(1, 1));
    CHECK(drilling(0, 1) == 0);
    CHECK((drilling - nearly_drilling).norm() <= (10 * near + first_order) * drilling.norm());
    // γ_τ = 0: 1/v across the slip, tail/v for the spin. The printed form has lost all digits beside it.
    if (std::string(name) == "hertz printed") continue;
    const auto sliding = second(law, unit, {1.2, -1.6, 0});
    const auto nearly_sliding = second(law, unit, {1.2, -1.6, near});
    CHECK((sliding - nearly_sliding).norm() <= (10 * near + first_order) * sliding.norm());
  }
  const auto uniform = hessian(UniformLaw{}, {2, 3}, SlipVelocity(4, 0, 0));
  CHECK(uniform(0, 0) == 0);
  CHECK(uniform(1, 1) == Approx(6. / 4).epsilon(8 * eps));
  CHECK(uniform(2, 2) == Approx(6. / 4 / 4).epsilon(8 * eps));
  const auto hertz = hessian(HertzLaw{}, {2, 3}, SlipVelocity(0, 0, 4));
  CHECK(hertz(0, 0) == Approx(6. / 4 * 3 * std::numbers::pi / 8).epsilon(8 * eps));
  CHECK(hertz(2, 2) == 0);
}

TEST_CASE("Where the potential has a kink there is no Hessian", "[law][force][hessian]") {
  const DecoupledLaw law({1, 0.6});
  CHECK_THROWS_AS(hessian(law, unit, SlipVelocity(0, 0, 1)), std::domain_error);
  CHECK_THROWS_AS(hessian(law, unit, SlipVelocity(1, 0, 0)), std::domain_error);
  CHECK_NOTHROW(hessian(law, unit, SlipVelocity(1, 0, 1e-30)));
  // Little spin beside much slip is spin all the same.
  CHECK(force(law, unit, {1e300, 0, -1e-300})[2] == 0.6);
  CHECK(force(law, unit, {0, -1e-300, 1e300})[1] == 1);
}

TEST_CASE("Hessian keeps its digits where ξ is subnormal", "[law][force][hessian]") {
  // v/s = 5e-320: ξ has four digits left, ξ/v = f''(0)/s has them all.
  for (const auto& [name, law] : all_laws()) {
    if (std::string(name) == "decoupled") continue;
    CAPTURE(name);
    const auto h = second(law, unit, {3e-320, 4e-320, 1});
    const auto limit = second(law, unit, {0, 0, 1});
    CHECK((h - limit).norm() <= 8 * eps * limit.norm());
  }
}

TEST_CASE("No NaN from finite input", "[law][force]") {
  std::mt19937_64 random(2003);
  std::uniform_int_distribution<int> exponent(-1074, 1023);
  std::uniform_real_distribution<double> mantissa(-2, 2);
  const auto any = [&] { return std::ldexp(mantissa(random), exponent(random)); };
  std::size_t nans = 0;
  for (int i = 0; i < 20000; ++i) {
    const SlipVelocity gamma(any(), any(), any());
    if (!gamma.allFinite() || gamma == SlipVelocity::Zero()) continue;
    const Load load{std::min(std::abs(any()), largest), std::min(std::abs(any()), largest)};
    for (const auto& [name, law] : all_laws()) {
      bool nan = force(law, load, gamma).hasNaN() || std::isnan(power(law, load, gamma));
      try {
        nan = nan || second(law, load, gamma).hasNaN();
      } catch (const std::domain_error&) {
        // disk × interval far from the diagonal: no second derivative within the range of doubles
        if (std::string(name) != "decoupled") throw;
      }
      if (nan) {
        ++nans;
        CAPTURE(name, gamma.transpose(), load.mu, load.lambda_n);
        CHECK_FALSE(nan);
      }
    }
  }
  CHECK(nans == 0);
}

namespace {

/// A law a user might bring: the ball itself, Φ = √(v² + s²).
struct RoundLaw {
  Friction at(double v, double s) const { return {v / std::hypot(v, s), s / std::hypot(v, s)}; }
  Curvature curvature(double v, double s) const {
    const double cube = std::pow(std::hypot(v, s), 3);
    return {s * s / cube, -v * s / cube, v * v / cube};
  }
  Extent extent() const { return {1, 1}; }
};

}  // namespace

TEST_CASE("A user's own law goes through the same door", "[law][force]") {
  const SlipVelocity gamma(2, -3, 6);  // norm 7
  const auto f = std::get<FrictionForce>(friction_force(RoundLaw{}, {0.5, 2}, gamma));
  CHECK((f + gamma / 7).norm() <= 4 * eps);
  CHECK(potential(RoundLaw{}, {0.5, 2}, gamma) == Approx(7).epsilon(4 * eps));
  const Eigen::Matrix3d h = hessian(RoundLaw{}, {0.5, 2}, gamma);
  const Eigen::Matrix3d expected = Eigen::Matrix3d::Identity() / 7 - gamma * gamma.transpose() / 343;
  CHECK((h - expected).norm() <= 8 * eps);
}
