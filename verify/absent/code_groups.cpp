#include "code_groups.hpp"

#include <regex>

namespace verify::absent {

const std::vector<CodeGroup>& code_groups() {
  static const std::vector<CodeGroup> groups{
      {"contact", "rows of contacts, contact problems and their solvers",
       "^contensou::.*(contact_rows|ContactSolver::solve|solve_single_contact|solve_one_contact|solve_"
       "automatic|"
       "solve_gauss_seidel|newton_iteration|natural_map_residual|ContactInstant::|::gap$|ContactSet::|"
       "BlockSolver::|PairList::|"
       "NscdStep::(solve_contacts|look|choose))"},
      {"friction", "friction disks, cylinders and balls, their contacts' solvers",
       "^contensou::.*(FrictionDisk|FrictionBall|FrictionCylinder|SmoothPlate|detail::(Secular|search_slip|"
       "end_slip|"
       "slip_|border_point|cylindrical|require_size))"},
      {"ball", "friction with four rows: balls and their contacts' solvers",
       "^contensou::.*(FrictionBall|SmoothPlate)"},
      {"law", "forces of pressure distributions and ellipsoids",
       "^contensou::((Uniform|Hertz|Compiled|Ellipsoid|Power|Radial)Law::|[a-z_]+<contensou::[A-Z][a-z]+Law>"
       ")"},
      {"arcs", "inverse trigonometric and elliptic functions",
       "^(__)?(ieee754_)?(acos|asin|atan|atan2)(f|l)?(_[a-z0-9]+)?$|ellint|^boost::math.*(ellint|acos|"
       "asin)"}};
  return groups;
}

FunctionCount count(const Profile& profile, const CodeGroup& group) {
  const std::regex pattern(group.pattern, std::regex::extended | std::regex::optimize);
  FunctionCount sum;
  for (const auto& [name, function] : profile.functions) {
    const std::string_view qualified = qualified_name(name);
    if (!std::regex_search(qualified.begin(), qualified.end(), pattern)) continue;
    sum.calls += function.calls;
    sum.instructions += function.instructions;
  }
  return sum;
}

}  // namespace verify::absent
