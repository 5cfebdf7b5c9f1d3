#include "contensou/contact/covering_path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace contensou {
namespace {

constexpr double on_path = 1e-9;      // ‖h‖ that will do: Newton's method follows at the end
constexpr double arrived = 1e-8;      // z that will do
constexpr double shortest = 1e-10;    // step before a corner is stepped over
constexpr double over_corner = 1e-9;  // by this
constexpr double largest_turn = 0.5;  // correction over step: the branch is the same
constexpr int most_corrections = 7;
constexpr int most_corners = 10;
constexpr int easy = 3;               // corrections after which the step is doubled
constexpr double least_rank = 1e-15;  // on w's diagonal, for rows of zeros

/// The sign of a permutation, which is sorted: permutationP().determinant() would allocate.
double sign_by_sorting(Eigen::VectorXi& order) {
  double sign = 1;
  for (int i = 0; i < order.size(); ++i) {
    while (order[i] != i) {
      std::swap(order[i], order[order[i]]);
      sign = -sign;
    }
  }
  return sign;
}

class Path {
 public:
  Path(ScaledProblem& problem, double largest_step, CoveringPathMemory& memory)
      : problem_(problem), largest_step_(largest_step), m_(memory), n_(problem.rows()) {
    m_.jacobian.resize(n_, n_ + 1);
    m_.bordered.resize(n_ + 1, n_ + 1);
    m_.map.resize(n_);
    m_.right.resize(n_ + 1);
    m_.trial.resize(n_ + 1);
    m_.point.setZero(n_ + 1);
    m_.tangent.setZero(n_ + 1);
  }

  int follow(int most_steps) {
    double& z = m_.point[n_];
    const double& fall = m_.tangent[n_];
    z = first_touch();
    if (z == 0) return 0;
    m_.tangent[n_] = -1;
    evaluate(m_.point);
    orientation_ = factor();
    double length = z / 10;
    int corners = 0;
    for (int step = 1; step <= most_steps; ++step) {
      const bool last = z + length * fall <= 0;
      if (last) length = -z / fall;
      m_.predicted = m_.point + length * m_.tangent;
      const int corrections = correct(length);
      if (corrections >= 0) {
        m_.point = m_.trial;
        turn();
        if (last && z <= arrived) return step;
        if (corrections <= easy) length *= 2;
        if (last) length = std::max(length, z / 10);
      } else if ((length /= 4) < shortest) {
        if (++corners > most_corners) return step;
        m_.point += over_corner * m_.tangent;
        evaluate(m_.point);
        turn();
        length = 10 * over_corner;
      }
    }
    return most_steps;
  }

 private:
  /// A z a little larger than where the first contact closes.
  double first_touch() const {
    double z = 0;
    for (Eigen::Index i = 0; i < n_; ++i) {
      if (problem_.cover[i] > 0) z = std::max(z, -problem_.b[i] / problem_.cover[i]);
    }
    return 1.001 * z;
  }

  /// h and Jacobian at y = (x, z); ‖h‖.
  double evaluate(const Eigen::VectorXd& y) {
    m_.x = y.head(n_);
    problem_.velocity(m_.x, m_.velocity);
    m_.velocity += y[n_] * problem_.cover;
    problem_.natural_map(m_.x, m_.velocity, m_.map, m_.jacobian);
    return m_.map.lpNorm<Eigen::Infinity>();
  }

  /// The Jacobian bordered by the tangent; the sign of its determinant.
  double factor() {
    m_.bordered.topRows(n_) = m_.jacobian;
    m_.bordered.row(n_) = m_.tangent.transpose();
    m_.lu.compute(m_.bordered);
    m_.order = m_.lu.permutationP().indices();
    double sign = sign_by_sorting(m_.order);
    for (Eigen::Index i = 0; i <= n_; ++i) {
      if (m_.lu.matrixLU()(i, i) < 0) sign = -sign;
    }
    return sign;
  }

  /// From m_.predicted to the path, across the tangent: m_.trial. The number of corrections, −1 where it is
  /// not found.
  int correct(double length) {
    m_.trial = m_.predicted;
    double last = 0;
    for (int i = 0; i < most_corrections; ++i) {
      const double distance = evaluate(m_.trial);
      if (distance < on_path) return i;
      if (i > 1 && !(distance < 0.8 * last)) return -1;
      last = distance;
      factor();
      m_.right.head(n_) = m_.map;
      m_.right[n_] = m_.tangent.dot(m_.trial - m_.predicted);
      m_.correction = m_.lu.solve(m_.right);
      m_.trial -= m_.correction;
      if (!((m_.trial - m_.predicted).norm() < largest_turn * length)) return -1;
    }
    return -1;
  }

  /// Tangent and steps at the point evaluated last.
  void turn() {
    problem_.adapt_steps(m_.x, m_.velocity, largest_step_);
    problem_.natural_map(m_.x, m_.velocity, m_.map, m_.jacobian);
    const double sign = factor();
    m_.right.setZero();
    m_.right[n_] = 1;
    m_.tangent = m_.lu.solve(m_.right);
    m_.tangent *= sign * orientation_ / m_.tangent.norm();
  }

  ScaledProblem& problem_;
  double largest_step_;
  CoveringPathMemory& m_;
  Eigen::Index n_;
  double orientation_ = 1;
};

}  // namespace

int follow_covering_path(ScaledProblem& problem, const CoveringPathOptions& options,
                         CoveringPathMemory& memory) {
  memory.diagonal = problem.w.diagonal();
  problem.w.diagonal() *= 1 + options.regularisation;
  problem.w.diagonal().array() += least_rank;
  problem.reset_steps();
  const int steps = Path(problem, options.largest_step, memory).follow(options.most_steps);
  problem.w.diagonal() = memory.diagonal;
  memory.x = memory.point.head(problem.rows());
  return steps;
}

}  // namespace contensou
