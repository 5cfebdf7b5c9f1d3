#include "contensou/integrate/dop853.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace contensou {
namespace {

using dop853::Weights;

constexpr std::size_t count_nonzero(const Weights& w) {
  std::size_t count = 0;
  for (const double weight : w) count += weight != 0 ? 1 : 0;
  return count;
}

/// The stages that have a weight.
template <const Weights& W>
constexpr auto nonzero() {
  std::array<std::size_t, count_nonzero(W)> list{};
  std::size_t next = 0;
  for (std::size_t j = 0; j < W.size(); ++j) {
    if (W[j] != 0) list[next++] = j;
  }
  return list;
}

/// Where the stages' numbers are.
struct Stages {
  std::array<const double*, dop853::stages> k;

  explicit Stages(const std::array<Eigen::VectorXd, dop853::stages>& vectors) {
    for (std::size_t j = 0; j < k.size(); ++j) k[j] = vectors[j].data();
  }
  /// Σ_j W_j k_j, component i: unrolled, without the terms of weight zero.
  template <const Weights& W>
  double sum(Eigen::Index i) const {
    return [&]<std::size_t... J>(std::index_sequence<J...>) {
      constexpr auto list = nonzero<W>();
      return (... + (W[list[J]] * k[list[J]][i]));
    }
    (std::make_index_sequence<count_nonzero(W)>{});
  }
};

}  // namespace

void Dop853::resize(Eigen::Index n) {
  for (Eigen::VectorXd* v : {&start_, &end_, &end_rate_, &argument_, &slope_, &error5_, &error3_})
    v->resize(n);
  for (Eigen::VectorXd& v : k_) v.resize(n);
  for (Eigen::VectorXd& v : extension_) v.resize(n);
}

template <std::size_t S>
void Dop853::evaluate_stage(OdeSystem& system) {
  const Stages stages(k_);
  const double h = h_;
  const double* const start = start_.data();
  double* __restrict__ const argument = argument_.data();
  const Eigen::Index n = start_.size();
  for (Eigen::Index i = 0; i < n; ++i) argument[i] = start[i] + h * stages.sum<dop853::a[S]>(i);
  system.derivative(t_ + dop853::c[S] * h, argument_, k_[S]);
}

double Dop853::attempt(OdeSystem& system, double t, const Eigen::VectorXd& y, const Eigen::VectorXd& rate,
                       double h, const Eigen::VectorXd& scale) {
  if (start_.size() != y.size()) resize(y.size());
  t_ = t;
  h_ = h;
  extended_ = false;
  start_ = y;
  k_[0] = rate;
  [&]<std::size_t... S>(std::index_sequence<S...>) { (evaluate_stage<S + 1>(system), ...); }
  (std::make_index_sequence<11>{});

  const Stages stages(k_);
  const Eigen::Index n = start_.size();
  const double* const start = start_.data();
  double* __restrict__ const argument = argument_.data();
  double* __restrict__ const slope = slope_.data();
  double* __restrict__ const error5 = error5_.data();
  double* __restrict__ const error3 = error3_.data();
  for (Eigen::Index i = 0; i < n; ++i) {
    slope[i] = stages.sum<dop853::b>(i);
    argument[i] = start[i] + h * slope[i];
    error5[i] = stages.sum<dop853::error5>(i);
    error3[i] = slope[i] - stages.sum<dop853::b3>(i);
  }
  const double error = error_norm(scale);
  if (!std::isfinite(error) || !argument_.allFinite()) return std::numeric_limits<double>::infinity();
  system.derivative(t + h, argument_, k_[12]);
  if (!k_[12].allFinite()) return std::numeric_limits<double>::infinity();
  end_.swap(argument_);
  end_rate_ = k_[12];
  return error;
}

/// Hairer, Nørsett and Wanner's: |h| ‖e₅‖²/√(‖e₅‖² + ‖e₃‖²/100), root mean squares.
double Dop853::error_norm(const Eigen::VectorXd& scale) const {
  double square5 = 0, square3 = 0;
  for (Eigen::Index i = 0; i < scale.size(); ++i) {
    const double inverse = 1 / scale[i];
    square5 += (error5_[i] * inverse) * (error5_[i] * inverse);
    square3 += (error3_[i] * inverse) * (error3_[i] * inverse);
  }
  const double mixed = square5 + 0.01 * square3;
  if (mixed == 0) return 0;
  return std::abs(h_) * square5 / std::sqrt(mixed * static_cast<double>(scale.size()));
}

void Dop853::extend(OdeSystem& system) {
  evaluate_stage<13>(system);
  evaluate_stage<14>(system);
  evaluate_stage<15>(system);
  const Stages stages(k_);
  for (Eigen::Index i = 0; i < start_.size(); ++i) {
    // Hermite's cubic, in differences, and what makes it one of degree 7.
    const double difference = h_ * slope_[i];
    const double bend = h_ * k_[0][i] - difference;
    extension_[0][i] = difference;
    extension_[1][i] = bend;
    extension_[2][i] = difference - h_ * k_[12][i] - bend;
    extension_[3][i] = h_ * stages.sum<dop853::d[0]>(i);
    extension_[4][i] = h_ * stages.sum<dop853::d[1]>(i);
    extension_[5][i] = h_ * stages.sum<dop853::d[2]>(i);
    extension_[6][i] = h_ * stages.sum<dop853::d[3]>(i);
  }
  extended_ = true;
}

void Dop853::interpolate(OdeSystem& system, double theta, Eigen::VectorXd& y) {
  if (!extended_) extend(system);
  const double rest = 1 - theta;
  const auto& e = extension_;
  y.resize(start_.size());
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    const double high = e[3][i] + theta * (e[4][i] + rest * (e[5][i] + theta * e[6][i]));
    y[i] = start_[i] + theta * (e[0][i] + rest * (e[1][i] + theta * (e[2][i] + rest * high)));
  }
}

}  // namespace contensou
