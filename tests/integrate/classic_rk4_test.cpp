#include "contensou/integrate/classic_rk4.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "ode_problems.hpp"

using namespace contensou;
using namespace ode_problems;

TEST_CASE("ClassicRk4: order 4 at the end, 3 between", "[integrate]") {
  for (auto make : {&kepler, &driven}) {
    WithSolution w = make();
    ClassicRk4 method;
    const double coarse = mean_error(method, w, 128), fine = mean_error(method, w, 256);
    CAPTURE(coarse, fine);
    CHECK(order(coarse, fine) > 3.8);
    CHECK(order(coarse, fine) < 4.3);
    const StepErrors long_step = step_errors(method, w, 0.1), short_step = step_errors(method, w, 0.05);
    CAPTURE(long_step.dense, short_step.dense);
    CHECK(order(long_step.dense, short_step.dense) > 3.8);  // local error: one more than the order
    CHECK(order(long_step.dense, short_step.dense) < 4.3);
    CHECK(long_step.estimated == 0);  // it has none
  }
}

TEST_CASE("ClassicRk4: linear problems grow by e^z up to z^4", "[integrate]") {
  const double z = -1.3;
  Problem problem(1, 1, [z](double, const Eigen::VectorXd& y, Eigen::VectorXd& dy) { dy << z * y[0]; });
  ClassicRk4 method;
  method.attempt(problem, 0, Eigen::VectorXd::Ones(1), Eigen::VectorXd::Constant(1, z), 1,
                 Eigen::VectorXd::Ones(1));
  CHECK(method.end()[0] == Approx(1 + z * (1 + z / 2 * (1 + z / 3 * (1 + z / 4)))).epsilon(1e-14));
}

TEST_CASE("ClassicRk4: cubics between, ends of the extension, evaluations", "[integrate]") {
  // y = t³ − t from t = 1 to 3: its rate by Simpson's rule is exact, and it is its own Hermite cubic.
  Problem problem(1, 1, [](double t, const Eigen::VectorXd&, Eigen::VectorXd& dy) { dy << 3 * t * t - 1; });
  ClassicRk4 method;
  method.attempt(problem, 1, Eigen::VectorXd::Zero(1), Eigen::VectorXd::Constant(1, 2), 2,
                 Eigen::VectorXd::Ones(1));
  CHECK(problem.evaluations == 4);  // three stages and the next step's first
  Eigen::VectorXd inside(1);
  for (int k = 0; k <= 16; ++k) {
    method.interpolate(problem, k / 16.0, inside);
    const double t = 1 + k / 8.0;
    CAPTURE(k);
    CHECK(std::abs(inside[0] - t * (t * t - 1)) < 1e-14 * 24);
  }
  CHECK(problem.evaluations == 4);
  method.interpolate(problem, 0, inside);
  CHECK(inside[0] == 0);
  method.interpolate(problem, 1, inside);
  CHECK(inside == method.end());
  CHECK(method.end_rate()[0] == 26);
}

TEST_CASE("ClassicRk4: its own end as the next start", "[integrate]") {
  WithSolution w = kepler();
  ClassicRk4 method, other;
  const Eigen::VectorXd y = w.solution(0), scale = Eigen::VectorXd::Ones(y.size());
  Eigen::VectorXd rate(y.size());
  w.problem.derivative(0, y, rate);
  method.attempt(w.problem, 0, y, rate, 0.1, scale);
  other.attempt(w.problem, 0, y, rate, 0.1, scale);
  const Eigen::VectorXd y1 = other.end(), rate1 = other.end_rate();
  method.attempt(w.problem, 0.1, method.end(), method.end_rate(), 0.1, scale);
  other.attempt(w.problem, 0.1, y1, rate1, 0.1, scale);
  CHECK(method.end() == other.end());
  CHECK(method.end_rate() == other.end_rate());
}

TEST_CASE("ClassicRk4: numbers that are not finite are reported, the last good end is kept", "[integrate]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Eigen::VectorXd y = Eigen::VectorXd::Ones(1);
  for (int bad = 1; bad <= 4; ++bad) {
    int call = -100;
    Problem problem(1, 1, [&](double, const Eigen::VectorXd& x, Eigen::VectorXd& dy) {
      dy << (++call == bad ? nan : x[0]);
    });
    ClassicRk4 method;
    REQUIRE(method.attempt(problem, 0, y, y, 0.1, y) == 0);
    const double kept = method.end()[0], kept_rate = method.end_rate()[0];
    call = 0;
    CAPTURE(bad);
    CHECK(method.attempt(problem, 0, y, y, 0.2, y) == std::numeric_limits<double>::infinity());
    CHECK(method.end()[0] == kept);
    CHECK(method.end_rate()[0] == kept_rate);
  }
}
