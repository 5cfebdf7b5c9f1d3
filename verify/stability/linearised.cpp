#include "linearised.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace verify::stability {
namespace {

/// Steps of the differences: where ‖γ_T‖ is at most about this part of |ω|R. The force is odd in the
/// deviation, its cubic term drops out of five points, the fifth-order one leaves 4u⁴ of itself.
constexpr double step_in_u = 3e-3;

/// Rates of (ẋ_S, ẏ_S, α, β, α̇, β̇), α̇ = ω_1 − ω n_1 and β̇ = ω_2 + ω(−n_2) to first order.
Eigen::Matrix<double, 6, 1> rates(SlippingTop& top, double spin, double spin_rate, const Deviation& d) {
  const Setting& s = top.setting();
  Eigen::VectorXd dy;
  const Eigen::VectorXd y = state(s, spin, d);
  top.derivative(0, y, dy);
  const double n1 = s.up() * y[3], n2 = s.up() * y[4];
  const double n1_rate = s.up() * dy[3], n2_rate = s.up() * dy[4];
  return Eigen::Matrix<double, 6, 1>{dy[6],
                                     dy[7],
                                     -n2_rate,
                                     n1_rate,
                                     dy[9] - spin * n1_rate - spin_rate * n1,
                                     dy[10] - spin * n2_rate - spin_rate * n2};
}

}  // namespace

double spin_rate(const Setting& setting, double spin) {
  SlippingTop top(setting);
  Eigen::VectorXd dy;
  const Eigen::VectorXd y = state(setting, spin, Deviation{});
  top.derivative(0, y, dy);
  return setting.up() * dy.tail<3>().dot(y.segment<3>(3));
}

Matrix6 jacobian(const Setting& s, double spin) {
  SlippingTop top(s);
  const double slowing = spin_rate(s, spin);
  const double u = step_in_u * s.radius * std::abs(spin);  // [m/s]
  const double angle = u / (std::abs(spin) * s.r());
  const double rate = u / s.h();
  const std::array<double, 6> steps{u, u, angle, angle, rate, rate};
  Matrix6 j;
  for (std::size_t k = 0; k < 6; ++k) {
    const auto at = [&](double times) {
      std::array<double, 6> d{};
      d[k] = times * steps[k];
      return rates(top, spin, slowing, {d[0], d[1], d[2], d[3], d[4], d[5]});
    };
    j.col(static_cast<Eigen::Index>(k)) = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * steps[k]);
  }
  return j;
}

ComplexForm complex_form(const Matrix6& j) {
  ComplexForm form{Matrix3c::Zero(), 0};
  for (Eigen::Index row = 0; row < 3; ++row) {
    const double size = j.middleRows<2>(2 * row).cwiseAbs().maxCoeff();
    for (Eigen::Index col = 0; col < 3; ++col) {
      const Eigen::Matrix2d b = j.block<2, 2>(2 * row, 2 * col);
      form.matrix(row, col) = Complex(b(0, 0) + b(1, 1), b(1, 0) - b(0, 1)) / 2.0;
      const double left = std::max(std::abs(b(0, 0) - b(1, 1)), std::abs(b(1, 0) + b(0, 1)));
      form.defect = std::max(form.defect, left / size);
    }
  }
  return form;
}

Matrix3c linearised(const Setting& setting, double spin) {
  return complex_form(jacobian(setting, spin)).matrix;
}

Modes modes(const Matrix3c& matrix) {
  // In units in which the entries are of one size: of the velocity, so that (w, ξ, ξ̇) are.
  const double time = 1 / std::max(std::abs(matrix(2, 2)), std::sqrt(std::abs(matrix(2, 1))));
  const double length = std::abs(matrix(0, 1) / matrix(0, 0)) * time;
  const Vector3c units(length / time, 1, 1 / time);
  const Matrix3c scaled = units.cwiseInverse().asDiagonal() * matrix * units.asDiagonal();
  const Eigen::ComplexEigenSolver<Matrix3c> solver(scaled);
  std::array<Eigen::Index, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](Eigen::Index i, Eigen::Index k) {
    return solver.eigenvalues()[i].real() > solver.eigenvalues()[k].real();
  });
  Modes m;
  for (std::size_t k = 0; k < 3; ++k) {
    m.eigenvalue[k] = solver.eigenvalues()[order[k]];
    const Vector3c vector = units.asDiagonal() * solver.eigenvectors().col(order[k]);
    m.vectors.col(static_cast<Eigen::Index>(k)) = vector / vector[1];
  }
  return m;
}

std::array<SlowMode, 3> slow_modes(const Setting& setting, double spin) {
  const Modes here = modes(linearised(setting, spin));
  const Matrix3c left = here.vectors.inverse();
  const double slowing = spin_rate(setting, spin);
  // Relative step of the spin: the difference's own error is its square.
  constexpr double step = 1e-3;
  const Modes below = modes(linearised(setting, spin * (1 - step)));
  const Modes above = modes(linearised(setting, spin * (1 + step)));
  const auto nearest = [](const Modes& m, Complex to) {
    Eigen::Index best = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (std::abs(m.eigenvalue[k] - to) < std::abs(m.eigenvalue[static_cast<std::size_t>(best)] - to))
        best = static_cast<Eigen::Index>(k);
    }
    return best;
  };
  std::array<SlowMode, 3> slow;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const Complex lambda = here.eigenvalue[k];
    const Vector3c change =
        slowing * (above.vectors.col(nearest(above, lambda)) - below.vectors.col(nearest(below, lambda))) /
        (2 * step * spin);
    const Vector3c parts = left * change;  // of the modes
    SlowMode& mode = slow[k];
    mode.eigenvalue = lambda;
    mode.rate = lambda.real() - parts[i].real();
    mode.shape = here.vectors.col(i);
    mode.outgrown = here.eigenvalue[0].real() - lambda.real();  // they are in order
    mode.nearest = std::abs(here.eigenvalue[(k + 1) % 3] - lambda);
    for (std::size_t l = 0; l < 3; ++l) {
      if (l == k) continue;
      const auto other = static_cast<Eigen::Index>(l);
      mode.shape += parts[other] / (here.eigenvalue[l] - lambda) * here.vectors.col(other);
      mode.nearest = std::min(mode.nearest, std::abs(here.eigenvalue[l] - lambda));
    }
  }
  return slow;
}

Eigen::VectorXd state(const Setting& setting, double spin, const SlowMode& mode, double inclination) {
  const Vector3c z = mode.shape * (inclination / std::abs(mode.shape[1]));
  return state(setting, spin,
               Deviation{z[0].real(), z[0].imag(), z[1].real(), z[1].imag(), z[2].real(), z[2].imag()});
}

}  // namespace verify::stability
