#include "contensou/integrate/radau5.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contensou/integrate/radau5_coefficients.hpp"

namespace contensou {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr int max_iterations = 10;
/// Newton's iteration ends when what is left is this part of the error allowed. Far below what the state asks
/// for: times the stiff rate, what is left enters the stages' rates, and with them the quadratures.
constexpr double newton_tolerance = 1e-6;
/// But no further than roundings of the state let it: so many of them.
constexpr double roundings = 4;

/// Root mean square of x_i/scale_i over the components of x.
double norm(const Eigen::VectorXd& x, const Eigen::VectorXd& scale) {
  double sum = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i) sum += (x[i] / scale[i]) * (x[i] / scale[i]);
  return std::sqrt(sum / static_cast<double>(x.size()));
}

}  // namespace

void Radau5::resize(Eigen::Index size, Eigen::Index coupled) {
  for (Eigen::VectorXd* v : {&start_, &start_rate_, &end_, &end_rate_, &argument_, &error_}) v->resize(size);
  for (auto* stages : {&z_, &k_}) {
    for (Eigen::VectorXd& v : *stages) v.resize(size);
  }
  for (Eigen::VectorXd& v : w_) v.resize(coupled);
  jacobian_.resize(size, coupled);
  real_matrix_.resize(coupled, coupled);
  complex_matrix_.resize(coupled, coupled);
  for (Eigen::VectorXd* v : {&real_side_, &real_change_}) v->resize(coupled);
  for (Eigen::VectorXcd* v : {&complex_side_, &complex_change_}) v->resize(coupled);
}

/// Solves z = h A f(start + z). From IV.8: with W = T⁻¹z and T⁻¹A⁻¹T block-diagonal, one real and one complex
/// linear system an iteration.
bool Radau5::solve_stages(OdeSystem& system, double t, double h, const Eigen::VectorXd& scale) {
  const Eigen::Index n = w_[0].size();
  const Eigen::Index size = start_.size();
  for (auto& z : z_) z.setZero();
  for (auto& w : w_) w.setZero();
  double rounding = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double part = std::numeric_limits<double>::epsilon() * start_[i] / scale[i];
    rounding += part * part;
  }
  rounding = roundings * std::sqrt(rounding / static_cast<double>(n));
  const double enough = std::max(newton_tolerance, rounding);
  double previous = infinite;
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    for (std::size_t s = 0; s < 3; ++s) {
      argument_ = start_ + z_[s];
      system.derivative(t + radau5::c[s] * h, argument_, k_[s]);
      if (!k_[s].allFinite()) return false;
    }
    const auto transformed = [&](std::size_t row, Eigen::Index i) {
      const auto& r = radau5::t_inverse[row];
      return r[0] * k_[0][i] + r[1] * k_[1][i] + r[2] * k_[2][i];
    };
    for (Eigen::Index i = 0; i < n; ++i) {
      real_side_[i] = transformed(0, i) - radau5::gamma / h * w_[0][i];
      const std::complex<double> w(w_[1][i], w_[2][i]);
      complex_side_[i] = std::complex<double>(transformed(1, i), transformed(2, i)) -
                         std::complex<double>(radau5::alpha, radau5::beta) / h * w;
    }
    real_change_ = real_.solve(real_side_);
    complex_change_ = complex_.solve(complex_side_);
    double change = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
      const double d0 = real_change_[i] / scale[i];
      change += d0 * d0 + std::norm(complex_change_[i]) / (scale[i] * scale[i]);
      w_[0][i] += real_change_[i];
      w_[1][i] += complex_change_[i].real();
      w_[2][i] += complex_change_[i].imag();
      for (std::size_t s = 0; s < 3; ++s) {
        const auto& r = radau5::t[s];
        z_[s][i] = r[0] * w_[0][i] + r[1] * w_[1][i] + r[2] * w_[2][i];
      }
    }
    change = std::sqrt(change / static_cast<double>(3 * n));
    if (!std::isfinite(change)) return false;
    const double rate = change / previous;  // of convergence; 0 at first
    if (iteration > 0 && rate >= 2) return false;
    const double left = iteration == 0 ? change : change * std::min(rate / std::max(1 - rate, 0.1), 10.0);
    if (left <= enough) {
      for (std::size_t s = 0; s < 3; ++s) {  // the quadratures
        const auto& r = radau5::a[s];
        for (Eigen::Index i = n; i < size; ++i)
          z_[s][i] = h * (r[0] * k_[0][i] + r[1] * k_[1][i] + r[2] * k_[2][i]);
      }
      return true;
    }
    previous = change;
  }
  return false;
}

/// err = (γ/h I − J)⁻¹ (f(start) + Σ e_s z_s/h), once more through f where that is too large: IV.8 (8.19),
/// (8.20).
double Radau5::estimate(OdeSystem& system, double t, double h, const Eigen::VectorXd& rate,
                        const Eigen::VectorXd& scale) {
  const Eigen::Index n = w_[0].size();
  const Eigen::Index size = start_.size();
  const auto combined = [&](Eigen::Index i) {
    return (radau5::error[0] * z_[0][i] + radau5::error[1] * z_[1][i] + radau5::error[2] * z_[2][i]) / h;
  };
  const auto through = [&](const Eigen::VectorXd& f) {
    for (Eigen::Index i = 0; i < n; ++i) real_side_[i] = f[i] + combined(i);
    real_change_ = real_.solve(real_side_);
    error_.head(n) = real_change_;
    for (Eigen::Index i = n; i < size; ++i) {  // rows of γ/h I − J below the coupled ones
      double sum = f[i] + combined(i);
      for (Eigen::Index j = 0; j < n; ++j) sum += jacobian_(i, j) * real_change_[j];
      error_[i] = sum * h / radau5::gamma;
    }
    return norm(error_, scale);
  };
  const double first = through(rate);
  if (first < 1) return first;
  argument_ = start_ + error_;
  system.derivative(t, argument_, k_[0]);
  return k_[0].allFinite() ? through(k_[0]) : infinite;
}

double Radau5::attempt(OdeSystem& system, double t, const Eigen::VectorXd& y, const Eigen::VectorXd& rate,
                       double h, const Eigen::VectorXd& scale) {
  const Eigen::Index n = system.coupled();
  if (start_.size() != y.size() || w_[0].size() != n) resize(y.size(), n);
  start_ = y;
  start_rate_ = rate;
  system.jacobian(t, start_, start_rate_, jacobian_);
  if (!jacobian_.allFinite()) return infinite;
  real_matrix_ = -jacobian_.topRows(n);
  complex_matrix_ = real_matrix_.cast<std::complex<double>>();
  real_matrix_.diagonal().array() += radau5::gamma / h;
  complex_matrix_.diagonal().array() += std::complex<double>(radau5::alpha, radau5::beta) / h;
  real_.compute(real_matrix_);
  complex_.compute(complex_matrix_);

  if (!solve_stages(system, t, h, scale)) return infinite;
  const double error = estimate(system, t, h, start_rate_, scale);
  if (!std::isfinite(error)) return infinite;
  argument_ = start_ + z_[2];
  system.derivative(t + h, argument_, k_[0]);
  if (!k_[0].allFinite()) return infinite;
  end_.swap(argument_);
  end_rate_.swap(k_[0]);
  return error;
}

void Radau5::interpolate(OdeSystem& /*system*/, double theta, Eigen::VectorXd& y) {
  // Lagrange's polynomial through the start and the stages, at 0, c₀, c₁, 1.
  const auto& c = radau5::c;
  std::array<double, 3> weight;
  for (std::size_t s = 0; s < 3; ++s) {
    weight[s] = theta / c[s];
    for (std::size_t j = 0; j < 3; ++j) {
      if (j != s) weight[s] *= (theta - c[j]) / (c[s] - c[j]);
    }
  }
  y = start_ + weight[0] * z_[0] + weight[1] * z_[1] + weight[2] * z_[2];
}

}  // namespace contensou
