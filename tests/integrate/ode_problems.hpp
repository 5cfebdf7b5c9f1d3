// Differential equations with known solutions, and what the tests of every one-step method do with them.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include "contensou/integrate/ode.hpp"

namespace ode_problems {

/// ẏ = f(t, y), the last components being quadratures.
class Problem final : public contensou::OdeSystem {
 public:
  using Rate = std::function<void(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dy)>;

  Problem(Eigen::Index size, Eigen::Index coupled, Rate rate)
      : size_(size), coupled_(coupled), rate_(std::move(rate)) {}
  Eigen::Index size() const override { return size_; }
  Eigen::Index coupled() const override { return coupled_; }
  void derivative(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dy) override {
    ++evaluations;
    rate_(t, y, dy);
  }
  long evaluations = 0;

 private:
  Eigen::Index size_, coupled_;
  Rate rate_;
};

struct WithSolution {
  Problem problem;
  std::function<Eigen::VectorXd(double)> solution;
  double end;
};

/// A planet of eccentricity 0.1 from its perihelion on, and the area ∫x ẏ dt; the solution is Kepler's
/// equation.
inline WithSolution kepler() {
  constexpr double e = 0.1;
  Problem problem(5, 4, [](double, const Eigen::VectorXd& y, Eigen::VectorXd& dy) {
    const double r2 = y[0] * y[0] + y[1] * y[1];
    const double r3 = r2 * std::sqrt(r2);
    dy << y[2], y[3], -y[0] / r3, -y[1] / r3, y[0] * y[3];
  });
  const auto solution = [](double t) {
    double anomaly = t;
    for (int k = 0; k < 100; ++k) anomaly = t + e * std::sin(anomaly);  // contracts by 0.1
    const double s = std::sin(anomaly), c = std::cos(anomaly), b = std::sqrt(1 - e * e);
    const double rate = 1 / (1 - e * c);
    // x ẏ dt = (c − e) b c dE
    const double area = b * ((2 * anomaly + std::sin(2 * anomaly)) / 4 - e * s);
    return Eigen::VectorXd{{c - e, b * s, -s * rate, b * c * rate, area}};
  };
  return {std::move(problem), solution, 4.0};
}

/// ẏ = y cos t and ∫cos 3t dt: nothing but time drives them.
inline WithSolution driven() {
  Problem problem(2, 1, [](double t, const Eigen::VectorXd& y, Eigen::VectorXd& dy) {
    dy << y[0] * std::cos(t), std::cos(3 * t);
  });
  const auto solution = [](double t) {
    return Eigen::VectorXd{{std::exp(std::sin(t)), std::sin(3 * t) / 3}};
  };
  return {std::move(problem), solution, 4.0};
}

/// Root mean square of the errors at the ends of `steps` equal steps from 0.
inline double mean_error(contensou::OdeStep& method, WithSolution& w, int steps) {
  Eigen::VectorXd y = w.solution(0), rate(y.size());
  const Eigen::VectorXd scale = Eigen::VectorXd::Constant(y.size(), 1e-12);
  const double h = w.end / steps;
  w.problem.derivative(0, y, rate);
  double sum = 0;
  for (int k = 0; k < steps; ++k) {
    if (!std::isfinite(method.attempt(w.problem, k * h, y, rate, h, scale))) return INFINITY;
    y = method.end();
    rate = method.end_rate();
    sum += (y - w.solution((k + 1) * h)).squaredNorm();
  }
  return std::sqrt(sum / steps);
}

/// Means over steps of h from twelve points of the solution.
struct StepErrors {
  double dense = 0;      ///< largest error between the ends
  double estimated = 0;  ///< in units of the components
};
inline StepErrors step_errors(contensou::OdeStep& method, WithSolution& w, double h) {
  const Eigen::Index n = w.solution(0).size();
  const double unit = 1e-6;
  const Eigen::VectorXd scale = Eigen::VectorXd::Constant(n, unit);
  Eigen::VectorXd rate(n), inside(n);
  StepErrors mean;
  for (int start = 0; start < 12; ++start) {
    const double t = start / 4.0;
    const Eigen::VectorXd y = w.solution(t);
    w.problem.derivative(t, y, rate);
    mean.estimated += unit * method.attempt(w.problem, t, y, rate, h, scale) / 12;
    double worst = 0;
    for (int k = 1; k < 20; ++k) {
      method.interpolate(w.problem, k / 20.0, inside);
      worst = std::max(worst, (inside - w.solution(t + k / 20.0 * h)).lpNorm<Eigen::Infinity>());
    }
    mean.dense += worst / 12;
  }
  return mean;
}

/// The exponent p of error ~ h^p between steps of h and h/2.
inline double order(double coarse, double fine) { return std::log2(coarse / fine); }

}  // namespace ode_problems
