#include "contensou/integrate/dop853.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "ode_problems.hpp"

using namespace contensou;
using namespace ode_problems;
using dop853::Weights;

namespace {

constexpr double rounding = 1e-14;  // ~50 products of numbers up to 50, each rounded

/// Σ_j w_j x_j
double sum(const Weights& w, const Weights& x) {
  double s = 0;
  for (std::size_t j = 0; j < w.size(); ++j) s += w[j] * x[j];
  return s;
}

/// A rooted tree of Butcher's theory: a method of order p has Σ_i b_i Φ_i = 1/γ for all trees of up to p
/// nodes.
struct Tree {
  int nodes;
  double density;  ///< γ
  Weights stages;  ///< Φ_i
};

/// Hangs every forest of `left` nodes, made of trees[0 .. last], below a root on which `root` is built so
/// far.
void hang(const std::vector<Tree>& trees, std::size_t last, int left, const Tree& root,
          std::vector<Tree>& out) {
  if (left == 0) out.push_back({root.nodes, root.density * root.nodes, root.stages});
  for (std::size_t k = 0; left > 0 && k <= last && k < trees.size(); ++k) {
    const Tree& branch = trees[k];
    if (branch.nodes > left) continue;
    Tree next{root.nodes + branch.nodes, root.density * branch.density, root.stages};
    for (std::size_t i = 0; i < next.stages.size(); ++i) next.stages[i] *= sum(dop853::a[i], branch.stages);
    hang(trees, k, left - branch.nodes, next, out);
  }
}

std::vector<Tree> trees_up_to(int nodes) {
  Weights ones;
  ones.fill(1);
  std::vector<Tree> trees;
  for (int n = 1; n <= nodes; ++n) {
    std::vector<Tree> larger;
    hang(trees, trees.size(), n - 1, {1, 1, ones}, larger);
    trees.insert(trees.end(), larger.begin(), larger.end());
  }
  return trees;
}

/// The largest p up to which Σ w Φ = target/γ holds, to rounding, for all trees.
int order_of(const Weights& w, double target, const std::vector<Tree>& trees) {
  int failing = std::numeric_limits<int>::max();
  for (const Tree& tree : trees) {
    if (!(std::abs(sum(w, tree.stages) - target / tree.density) < rounding))
      failing = std::min(failing, tree.nodes);
  }
  return failing - 1;
}

}  // namespace

TEST_CASE("DOP853: rows sum to the stages' times", "[integrate]") {
  for (std::size_t i = 0; i < dop853::stages; ++i) {
    CAPTURE(i);
    double row = 0, size = 0;
    for (const double weight : dop853::a[i]) row += weight, size += std::abs(weight);
    CHECK(std::abs(row - dop853::c[i]) <= 4e-16 * (1 + size));
    for (std::size_t j = i; j < dop853::stages; ++j) CHECK(dop853::a[i][j] == 0);  // explicit
  }
}

TEST_CASE("DOP853: all order conditions, of the step and of its companions", "[integrate]") {
  const std::vector<Tree> trees = trees_up_to(9);
  REQUIRE(trees.size() == 1 + 1 + 2 + 4 + 9 + 20 + 48 + 115 + 286);  // rooted trees of 1 to 9 nodes
  CHECK(order_of(dop853::b, 1, trees) == 8);
  CHECK(order_of(dop853::error5, 0, trees) == 5);
  CHECK(order_of(dop853::b3, 1, trees) == 3);
}

TEST_CASE("DOP853: order 8 at the end, 7 between, estimate h^8", "[integrate]") {
  for (auto make : {&kepler, &driven}) {
    WithSolution w = make();
    Dop853 method;
    const double coarse = mean_error(method, w, 16), fine = mean_error(method, w, 32);
    CAPTURE(coarse, fine);
    CHECK(order(coarse, fine) > 7.7);
    CHECK(order(coarse, fine) < 8.5);
    const StepErrors long_step = step_errors(method, w, 0.2), short_step = step_errors(method, w, 0.1);
    CAPTURE(long_step.dense, short_step.dense, long_step.estimated, short_step.estimated);
    CHECK(order(long_step.dense, short_step.dense) > 7.7);  // local error: one more than the order
    CHECK(order(long_step.dense, short_step.dense) < 8.5);
    CHECK(order(long_step.estimated, short_step.estimated) > 7.7);
    CHECK(order(long_step.estimated, short_step.estimated) < 8.5);
  }
}

TEST_CASE("DOP853: polynomials, ends of the extension, evaluations", "[integrate]") {
  // Order 7 between: t^6 is integrated to t^7/7 exactly at every θ.
  Problem problem(1, 1,
                  [](double t, const Eigen::VectorXd&, Eigen::VectorXd& dy) { dy << 7 * std::pow(t, 6); });
  Dop853 method;
  const Eigen::VectorXd y = Eigen::VectorXd::Zero(1), rate = Eigen::VectorXd::Zero(1);
  method.attempt(problem, 0, y, rate, 2, Eigen::VectorXd::Ones(1));
  CHECK(problem.evaluations == 12);
  Eigen::VectorXd inside(1);
  for (int k = 0; k <= 8; ++k) {
    method.interpolate(problem, k / 8.0, inside);
    CAPTURE(k);
    CHECK(std::abs(inside[0] - std::pow(k / 4.0, 7)) <
          128 * 1e-13);  // weights up to 400, differences of them
  }
  CHECK(problem.evaluations == 15);
  method.interpolate(problem, 0, inside);
  CHECK(inside[0] == 0);
  method.interpolate(problem, 1, inside);
  CHECK(std::abs(inside[0] - method.end()[0]) <= 2e-16 * 128);
  CHECK(method.end_rate()[0] == Approx(448).epsilon(1e-15));
}

TEST_CASE("DOP853: its own end as the next start", "[integrate]") {
  WithSolution w = kepler();
  Dop853 method, other;
  const Eigen::VectorXd y = w.solution(0), scale = Eigen::VectorXd::Ones(y.size());
  Eigen::VectorXd rate(y.size());
  w.problem.derivative(0, y, rate);
  method.attempt(w.problem, 0, y, rate, 0.1, scale);
  other.attempt(w.problem, 0, y, rate, 0.1, scale);
  const Eigen::VectorXd y1 = other.end(), rate1 = other.end_rate();
  CHECK(method.attempt(w.problem, 0.1, method.end(), method.end_rate(), 0.1, scale) ==
        other.attempt(w.problem, 0.1, y1, rate1, 0.1, scale));
  CHECK(method.end() == other.end());
  CHECK(method.end_rate() == other.end_rate());
}

TEST_CASE("DOP853: numbers that are not finite are reported, the last good end is kept", "[integrate]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Eigen::VectorXd y = Eigen::VectorXd::Ones(1), rate = Eigen::VectorXd::Ones(1);
  const Eigen::VectorXd scale = Eigen::VectorXd::Ones(1);
  for (int bad = 1; bad <= 12; ++bad) {
    int call = -100;
    Problem problem(1, 1, [&](double, const Eigen::VectorXd& x, Eigen::VectorXd& dy) {
      dy << (++call == bad ? nan : x[0]);
    });
    Dop853 method;
    REQUIRE(std::isfinite(method.attempt(problem, 0, y, rate, 0.1, scale)));
    const double kept = method.end()[0], kept_rate = method.end_rate()[0];
    call = 0;
    CAPTURE(bad);
    CHECK(method.attempt(problem, 0, y, rate, 0.2, scale) == std::numeric_limits<double>::infinity());
    CHECK(method.end()[0] == kept);
    CHECK(method.end_rate()[0] == kept_rate);
  }
  Problem explosive(1, 1, [](double, const Eigen::VectorXd& x, Eigen::VectorXd& dy) { dy << x[0] * x[0]; });
  Dop853 method;
  CHECK(method.attempt(explosive, 0, 1e200 * y, rate, 1e200, scale) ==
        std::numeric_limits<double>::infinity());
}
