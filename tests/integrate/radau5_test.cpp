#include "contensou/integrate/radau5.hpp"

#include <catch2/catch.hpp>
#include <complex>
#include <limits>

#include "contensou/integrate/radau5_coefficients.hpp"
#include "ode_problems.hpp"

using namespace contensou;
using namespace ode_problems;

namespace {

constexpr double rounding = 1e-14;  // a few products of numbers up to 10, each rounded

Eigen::Matrix3d matrix(const radau5::Matrix3& rows) {
  Eigen::Matrix3d m;
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j)
      m(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  return m;
}

Eigen::Array3d powers(double k) { return Eigen::Array3d(radau5::c[0], radau5::c[1], radau5::c[2]).pow(k); }

/// The method's stability function: y(h) of ẏ = λy with z = hλ; the (2, 3) Padé approximation of e^z.
std::complex<double> growth(std::complex<double> z) {
  return (1.0 + z * (2.0 / 5 + z / 20.0)) / (1.0 - z * (3.0 / 5 - z * (3.0 / 20 - z / 60.0)));
}

/// ẏ = λ(y − sin t) + cos t, from y(0) = 0: y = sin t, however stiff.
Problem prothero_robinson(double lambda) {
  return {1, 1, [lambda](double t, const Eigen::VectorXd& y, Eigen::VectorXd& dy) {
            dy << lambda * (y[0] - std::sin(t)) + std::cos(t);
          }};
}

/// Error at t = 1.
double error_of_prothero_robinson(double lambda, int steps) {
  Problem problem = prothero_robinson(lambda);
  Radau5 method;
  Eigen::VectorXd y = Eigen::VectorXd::Zero(1), rate(1);
  problem.derivative(0, y, rate);
  const double h = 1.0 / steps;
  for (int k = 0; k < steps; ++k) {
    if (!std::isfinite(method.attempt(problem, k * h, y, rate, h, Eigen::VectorXd::Constant(1, 1e-12))))
      return INFINITY;
    y = method.end();
    rate = method.end_rate();
  }
  return std::abs(y[0] - std::sin(1.0));
}

}  // namespace

TEST_CASE("Radau5: the transformation brings A^-1 to block form", "[integrate]") {
  const Eigen::Matrix3d t = matrix(radau5::t);
  CHECK((matrix(radau5::t_inverse) * t - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < rounding);
  Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
  block(0, 0) = radau5::gamma;
  block(1, 1) = block(2, 2) = radau5::alpha;
  block(2, 1) = radau5::beta;
  block(1, 2) = -radau5::beta;
  // A⁻¹T = T·block, without an inverse.
  CHECK((matrix(radau5::a) * t * block - t).cwiseAbs().maxCoeff() < rounding);
}

TEST_CASE("Radau5: simplifying order conditions B(5), C(3), D(2)", "[integrate]") {
  const Eigen::Matrix3d a = matrix(radau5::a);
  const Eigen::Array3d b = a.row(2).transpose();  // the last stage is the end
  for (int k = 1; k <= 5; ++k) CHECK(std::abs((b * powers(k - 1)).sum() - 1.0 / k) < rounding);
  CHECK(std::abs((b * powers(5)).sum() - 1.0 / 6) > 1e-3);
  const auto stages = [&](int k) {
    return (a * powers(k - 1).matrix() - powers(k).matrix() / k).cwiseAbs().maxCoeff();
  };
  for (int k = 1; k <= 3; ++k) CHECK(stages(k) < rounding);
  CHECK(stages(4) > 1e-3);
  for (int k = 1; k <= 2; ++k) {
    const Eigen::Array3d left = a.transpose() * (b * powers(k - 1)).matrix();
    CHECK((left - b * (1 - powers(k)) / k).abs().maxCoeff() < rounding);
  }
  // The companion of the error estimate integrates up to t² exactly, as a method of order 3 does.
  const Eigen::Array3d e(radau5::error[0], radau5::error[1], radau5::error[2]);
  CHECK(std::abs((e * powers(1)).sum() + 1) < rounding);
  CHECK(std::abs((e * powers(2)).sum()) < rounding);
  CHECK(std::abs((e * powers(3)).sum()) < rounding);
  CHECK(std::abs((e * powers(4)).sum()) > 1e-2);
}

TEST_CASE("Radau5: order 5 at the end, 3 between, estimate h^4", "[integrate]") {
  for (auto make : {&kepler, &driven}) {
    WithSolution w = make();
    Radau5 method;
    const double coarse = mean_error(method, w, 64), fine = mean_error(method, w, 128);
    CAPTURE(coarse, fine);
    CHECK(order(coarse, fine) > 4.7);
    CHECK(order(coarse, fine) < 5.3);
    const StepErrors long_step = step_errors(method, w, 0.1), short_step = step_errors(method, w, 0.05);
    CAPTURE(long_step.dense, short_step.dense, long_step.estimated, short_step.estimated);
    CHECK(order(long_step.dense, short_step.dense) > 3.7);  // local error: one more than the order
    CHECK(order(long_step.dense, short_step.dense) < 4.3);
    CHECK(order(long_step.estimated, short_step.estimated) > 3.7);
    CHECK(order(long_step.estimated, short_step.estimated) < 4.3);
  }
}

TEST_CASE("Radau5: linear problems grow by the stability function", "[integrate]") {
  // ẏ = λy for complex λ, as a plane.
  for (const std::complex<double> z :
       {std::complex<double>(0.5, 0), {-2, 0}, {-30, 0}, {0, 3}, {-5, 8}, {-1e6, 1e5}}) {
    Problem problem(2, 2, [z](double, const Eigen::VectorXd& y, Eigen::VectorXd& dy) {
      dy << z.real() * y[0] - z.imag() * y[1], z.imag() * y[0] + z.real() * y[1];
    });
    Radau5 method;
    Eigen::VectorXd rate(2);
    const Eigen::VectorXd start{{1, 0}};
    problem.derivative(0, start, rate);
    method.attempt(problem, 0, start, rate, 1, Eigen::VectorXd::Constant(2, 1e-11));
    CAPTURE(z);
    // Newton's iteration leaves a thousandth of the scale.
    CHECK(std::abs(std::complex<double>(method.end()[0], method.end()[1]) - growth(z)) <
          2e-14 * (1 + std::abs(growth(z))));
  }
}

TEST_CASE("Radau5: stiffness restricts neither step nor accuracy", "[integrate]") {
  // Prothero and Robinson: the error is C h³/|λ| (Hairer, Wanner II, IV.15), with C < φ''''/4! = 1/24.
  const double coarse = error_of_prothero_robinson(-1e6, 5), fine = error_of_prothero_robinson(-1e6, 10);
  CAPTURE(coarse, fine);
  CHECK(fine < 1e-3 / 24 * 1e-6);
  CHECK(order(coarse, fine) > 2.7);
  CHECK(order(coarse, fine) < 3.3);
  CHECK(error_of_prothero_robinson(-1e9, 10) < 1e-3 / 24 * 1e-9 + 2e-15);
  CHECK(error_of_prothero_robinson(-1e12, 10) < 2e-15);  // rounding of ten steps
}

TEST_CASE("Radau5: fast transients die out and are not taken for errors", "[integrate]") {
  // ẏ = λy from 1, z = hλ → −∞: y(h) → 3/|z|, and the estimate's second form → γ/|z|. The next terms are
  // smaller by some 12/|z|.
  const double z = -1e6;
  Problem problem(1, 1, [z](double, const Eigen::VectorXd& y, Eigen::VectorXd& dy) { dy << z * y[0]; });
  Radau5 method;
  const double unit = 1e-6;
  const double estimated =
      unit * method.attempt(problem, 0, Eigen::VectorXd::Ones(1), Eigen::VectorXd::Constant(1, z), 1,
                            Eigen::VectorXd::Constant(1, unit));
  CHECK(method.end()[0] == Approx(growth(z).real()).epsilon(1e-3));
  CHECK(estimated == Approx(radau5::gamma / -z).epsilon(1e-3));
}

TEST_CASE("Radau5: quadratures are what they are among the coupled components", "[integrate]") {
  const auto rate_of = [](double t, const Eigen::VectorXd& y, Eigen::VectorXd& dy) {
    dy << y[1], -std::sin(y[0]), y[0] * y[1] + std::cos(t), y[1] * y[1];
  };
  const Eigen::VectorXd start{{1, 0.5, 2, 3}}, scale = Eigen::VectorXd::Constant(4, 1e-10);
  Eigen::VectorXd rate(4);
  rate_of(0.3, start, rate);
  Problem apart(4, 2, rate_of), together(4, 4, rate_of);
  Radau5 one, other;
  const double error = one.attempt(apart, 0.3, start, rate, 0.2, scale);
  const double error_together = other.attempt(together, 0.3, start, rate, 0.2, scale);
  CHECK((one.end() - other.end()).cwiseAbs().maxCoeff() < 2e-3 * 1e-10);  // Newton's tolerance, twice
  CHECK((one.end_rate() - other.end_rate()).cwiseAbs().maxCoeff() < 4e-3 * 1e-10);
  CHECK(error == Approx(error_together).epsilon(1e-6));  // forward differences in the Jacobian
  Eigen::VectorXd a(4), b(4);
  one.interpolate(apart, 0.37, a);
  other.interpolate(together, 0.37, b);
  CHECK((a - b).cwiseAbs().maxCoeff() < 4e-3 * 1e-10);
}

TEST_CASE("Radau5: ends of the extension, its own end as the next start", "[integrate]") {
  WithSolution w = kepler();
  Radau5 method, other;
  const Eigen::VectorXd y = w.solution(0), scale = Eigen::VectorXd::Constant(y.size(), 1e-10);
  Eigen::VectorXd rate(y.size()), inside(y.size());
  w.problem.derivative(0, y, rate);
  method.attempt(w.problem, 0, y, rate, 0.1, scale);
  other.attempt(w.problem, 0, y, rate, 0.1, scale);
  method.interpolate(w.problem, 0, inside);
  CHECK(inside == y);
  method.interpolate(w.problem, 1, inside);
  CHECK((inside - method.end()).cwiseAbs().maxCoeff() <= 4e-16);
  w.problem.derivative(0.1, method.end(), rate);
  CHECK(method.end_rate() == rate);
  const Eigen::VectorXd y1 = other.end(), rate1 = other.end_rate();
  CHECK(method.attempt(w.problem, 0.1, method.end(), method.end_rate(), 0.1, scale) ==
        other.attempt(w.problem, 0.1, y1, rate1, 0.1, scale));
  CHECK(method.end() == other.end());
  CHECK(method.end_rate() == other.end_rate());
}

TEST_CASE("Radau5: numbers that are not finite are reported, the last good end is kept", "[integrate]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Eigen::VectorXd y = Eigen::VectorXd::Ones(1), rate = Eigen::VectorXd::Ones(1);
  const Eigen::VectorXd scale = Eigen::VectorXd::Constant(1, 1e-8);
  int calls = 0, bad = -1;
  Problem problem(1, 1, [&](double, const Eigen::VectorXd& x, Eigen::VectorXd& dy) {
    dy << (++calls == bad ? nan : x[0] * x[0]);
  });
  Radau5 method;
  REQUIRE(std::isfinite(method.attempt(problem, 0, y, rate, 0.1, scale)));
  const int last = calls;
  REQUIRE(last > 5);
  const double kept = method.end()[0], kept_rate = method.end_rate()[0];
  for (bad = 1; bad <= last; ++bad) {
    calls = 0;
    CAPTURE(bad, last);
    CHECK(method.attempt(problem, 0, y, rate, 0.1, scale) == std::numeric_limits<double>::infinity());
    CHECK(method.end()[0] == kept);
    CHECK(method.end_rate()[0] == kept_rate);
  }
  // ẏ = y² from 1 leaves the numbers at t = 1: a step of 100 has no solution to be found.
  bad = -1;
  CHECK(method.attempt(problem, 0, y, rate, 1e200, scale) == std::numeric_limits<double>::infinity());
}
