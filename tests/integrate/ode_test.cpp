#include "contensou/integrate/ode.hpp"

#include <catch2/catch.hpp>

#include "ode_problems.hpp"

using namespace contensou;
using ode_problems::Problem;

TEST_CASE("OdeSystem: the Jacobian by differences", "[integrate]") {
  // Two coupled components, one of them large, and a quadrature.
  Problem problem(3, 2, [](double t, const Eigen::VectorXd& y, Eigen::VectorXd& dy) {
    dy << t * std::sin(y[0]), y[0] * y[1], y[0] * y[0] + y[1] / 1e6;
  });
  const Eigen::VectorXd y{{0.8, -3e6, 5}};
  Eigen::VectorXd rate(3);
  problem.derivative(2, y, rate);
  problem.evaluations = 0;
  Eigen::MatrixXd jacobian(3, 2);
  problem.jacobian(2, y, rate, jacobian);
  CHECK(problem.evaluations == 2);  // none for the quadrature
  Eigen::MatrixXd exact(3, 2);
  exact << 2 * std::cos(0.8), 0, -3e6, 0.8, 1.6, 1e-6;
  // Increments of 1.5e-8 (1 + |y|): curvature times half of it, and roundings of the rates divided by it.
  Eigen::MatrixXd bound(3, 2);
  const double root = std::sqrt(2.3e-16), large = root * 3e6;
  bound << root * (1.8 + 2), 1e-30, root * 3e6 * 2, root * 2, root * (2 + 2 * 3.6), root;
  bound(2, 1) = 4 * 2.3e-16 / large * 4;
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 2; ++j) {
      CAPTURE(i, j);
      CHECK(std::abs(jacobian(i, j) - exact(i, j)) <= bound(i, j));
    }
  }
}
