#pragma once

#include <array>

/// Radau IIA with three stages and its transformation: E. Hairer, G. Wanner, Solving Ordinary Differential
/// Equations II, 2nd ed., Springer 1996, Section IV.5 (tableau) and IV.8 (T, γ, α, β, error estimate).
/// T⁻¹A⁻¹T = (γ) ⊕ (α −β; β α).
namespace contensou::radau5 {

using Row = std::array<double, 3>;
using Matrix3 = std::array<Row, 3>;

inline constexpr double root6 = 2.449489742783178098197284074705892;

inline constexpr Row c{(4 - root6) / 10, (4 + root6) / 10, 1};
inline constexpr Matrix3 a{{
    {(88 - 7 * root6) / 360, (296 - 169 * root6) / 1800, (-2 + 3 * root6) / 225},
    {(296 + 169 * root6) / 1800, (88 + 7 * root6) / 360, (-2 - 3 * root6) / 225},
    {(16 - root6) / 36, (16 + root6) / 36, 1.0 / 9},
}};

inline constexpr Matrix3 t{{
    {9.1232394870892942792e-02, -0.14125529502095420843, -3.0029194105147424492e-02},
    {0.24171793270710701896, 0.20412935229379993199, 0.38294211275726193779},
    {0.96604818261509293619, 1, 0},
}};
inline constexpr Matrix3 t_inverse{{
    {4.3255798900631553510, 0.33919925181580986954, 0.54177053993587487119},
    {-4.1787185915519047273, -0.32768282076106238708, 0.47662355450055045196},
    {-0.50287263494578687595, 2.5719269498556054292, -0.59603920482822492497},
}};

inline constexpr double gamma = 3.6378342527444957322;
inline constexpr double alpha = 2.6810828736277521339;
inline constexpr double beta = 3.0504301992474105694;

/// Of z in the error estimate.
inline constexpr Row error{-(13 + 7 * root6) / 3, (-13 + 7 * root6) / 3, -1.0 / 3};

}  // namespace contensou::radau5
