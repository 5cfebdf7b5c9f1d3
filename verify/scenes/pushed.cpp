#include "pushed.hpp"

#include <cmath>
#include <vector>

#include "ode.hpp"

namespace verify::answers {

double Pushed::terminal_speed(double push) const {
  double low = 0, high = 1;
  while (patch_.at(high, 1).xi * a_ < push) low = high, high *= 2;
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    (patch_.at(middle, 1).xi * a_ < push ? low : high) = middle;
  }
  return s_ * (low + high) / 2;
}

double Pushed::rate(double push) const {
  const double u = terminal_speed(push) / s_;
  // Third of the digits, for a difference of second order.
  const double step = 1e-5 * (1 + u);
  return a_ / s_ * (patch_.at(u + step, 1).xi - patch_.at(std::abs(u - step), 1).xi * (u < step ? -1 : 1)) /
         (2 * step);
}

std::vector<double> Pushed::speeds(double push, double from, const std::vector<double>& times) const {
  std::vector<double> u{from / s_};
  const auto right = [&](double, const double* at, double* rate) {
    const double xi = patch_.at(std::abs(at[0]), 1).xi;
    *rate = push / a_ - std::copysign(xi, at[0]);
  };
  std::vector<double> found;
  double now = 0;
  for (const double t : times) {
    solve(right, now, t * a_ / s_, u);
    now = t * a_ / s_;
    found.push_back(s_ * u[0]);
  }
  return found;
}

}  // namespace verify::answers
