#pragma once

#include <limits>

#include "contensou/contact/blocks.hpp"
#include "contensou/contact/small_linear.hpp"

namespace contensou::detail {

/// Newton's method on one contact's natural map Λ − Π(Λ − rγ) = 0, LG03 (4.17), with a line search on its
/// norm: for the last digits, and for contacts that the equations of slip_search.hpp do not cover. Improves
/// `impulse` as far as it can and returns the map's residual ‖Λ − Π‖/r, a velocity; infinity where Λ − rγ
/// overflows at the start.
template <class Domain>
double polish(const Domain& domain, double mu, const ContactMatrix<Domain>& w, const ContactVector<Domain>& b,
              double goal, ContactVector<Domain>& impulse, int& iterations) {
  using Vector = ContactVector<Domain>;
  using Matrix = ContactMatrix<Domain>;
  constexpr int most_iterations = 40;
  constexpr double least_step = 0x1p-8;
  constexpr double least_fall = 0x1p-10;
  const double r = 1 / row_sum_norm(w);
  const auto argument = [&](const Vector& z) -> Vector { return z - r * (w * z + b); };
  Vector x = argument(impulse);
  if (!x.allFinite()) return std::numeric_limits<double>::infinity();
  Matrix jacobian;
  Vector rest = impulse - project_contact(domain, mu, x, jacobian);
  for (int i = 0; i < most_iterations && rest.norm() > r * goal; ++i) {
    const Matrix system = Matrix::Identity() - jacobian * (Matrix::Identity() - r * w);
    const Vector step = -solve_pivoted<Vector::RowsAtCompileTime>(system, rest);
    if (!step.allFinite()) break;
    double t = 1;
    Vector next_rest = rest;
    Vector next = impulse;
    for (; t >= least_step; t /= 2) {
      next = impulse + t * step;
      x = argument(next);
      if (!x.allFinite()) continue;
      next_rest = next - project_contact(domain, mu, x, jacobian);
      if (next_rest.norm() < (1 - least_fall * t) * rest.norm()) break;
    }
    ++iterations;
    if (t < least_step) break;
    impulse = next;
    rest = next_rest;
  }
  return rest.norm() / r;
}

}  // namespace contensou::detail
