#pragma once

#include <array>
#include <cstddef>

namespace reference {

/// One step of the Gragg–Bulirsch–Stoer method: the modified midpoint rule with 2, 4, ... 2k substeps,
/// extrapolated in h² to order 2k. Writes the difference of the last two columns into `error`.
template <std::size_t columns, class Vector, class Function>
Vector extrapolated_step(const Function& f, const Vector& x, const typename Vector::value_type& h,
                         Vector& error) {
  using Real = typename Vector::value_type;
  const Vector slope = f(x);
  std::array<Vector, columns> row;  // Aitken–Neville, overwritten from the right
  for (std::size_t j = 0; j < columns; ++j) {
    const int n = 2 * static_cast<int>(j + 1);
    const Real step = h / n;
    Vector before = x, now = x;
    for (std::size_t i = 0; i < x.size(); ++i) now[i] += step * slope[i];
    for (int k = 1; k < n; ++k) {
      const Vector rate = f(now);
      for (std::size_t i = 0; i < x.size(); ++i) {
        const Real next = before[i] + 2 * step * rate[i];
        before[i] = now[i];
        now[i] = next;
      }
    }
    row[j] = now;
    for (std::size_t l = j; l-- > 0;) {
      const Real ratio = Real(n) / static_cast<int>(2 * (l + 1));
      for (std::size_t i = 0; i < x.size(); ++i) {
        const Real change = (row[l + 1][i] - row[l][i]) / (ratio * ratio - 1);
        row[l][i] = row[l + 1][i] + change;
        if (l == 0) error[i] = change;
      }
    }
  }
  return row[0];
}

}  // namespace reference
