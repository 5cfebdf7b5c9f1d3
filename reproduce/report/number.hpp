#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Numbers as a reader wants them, as HTML: powers of ten raised, a true minus sign, ∞.
namespace report {

/// The number a cell holds, all of it; nothing for other text.
std::optional<double> number(std::string_view text);

/// 0.0012345 as 0.001234, 1.2e-17 as 1.2·10⁻¹⁷: `digits` of them, no zeros at the end.
std::string rounded(double x, int digits = 4);

/// The same rounded up, so that "at most" stays true: 2.6241 as 2.63.
std::string rounded_up(double x, int digits = 3);

/// All the digits that stand there: 9.999999999999997e-07 as 9.999999999999997·10⁻⁷.
std::string unrounded(std::string_view number);

}  // namespace report
