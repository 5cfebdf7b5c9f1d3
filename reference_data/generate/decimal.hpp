#pragma once

#include <optional>
#include <string>

#include "ball.hpp"

namespace reference {

/// The decimal with `digits` significant digits that every number of the ball
/// rounds to (to nearest, ties to even), as d.ddd...e[+-]XX; empty if the ball
/// does not settle it (or contains zero without being zero). An exact zero is "0".
std::optional<std::string> correctly_rounded(const Ball& value, int digits);

/// The double nearest to every number of the ball; throws std::runtime_error if the ball does not settle it.
double nearest_double(const Ball& value);

}  // namespace reference
