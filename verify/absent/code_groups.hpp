#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "callgrind.hpp"

namespace verify::absent {

/// Functions that exist for one effect alone: if it is absent, none of them has anything to do.
struct CodeGroup {
  std::string name;
  std::string what;     ///< in words
  std::string pattern;  ///< of qualified names, as an extended regular expression
};

/// contact: rows and problems of contacts; friction: disk, balls, their one-contact solvers; law: forces of
/// pressure distributions; ball: friction with four rows; arcs: inverse trigonometric and elliptic functions.
const std::vector<CodeGroup>& code_groups();

/// All calls of a group's functions, and their own instructions.
FunctionCount count(const Profile& profile, const CodeGroup& group);

}  // namespace verify::absent
