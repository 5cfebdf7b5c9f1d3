#include "contensou/scene/scene.hpp"

namespace contensou {

std::string scene_help() {
  return "[scene]        system = \"bodies\" or \"tippe_top\"; duration [s]; gravity [m/s^2], a number or a\n"
         "               vector; name (else the file's); fidelity: what may be left out (else nothing);\n"
         "               formulation of the tippe-top = \"axis\" (if not given) or \"euler\"\n"
         "[integrator]   method; step [s] (fixed-step methods); tolerance (the others; both may stand);\n"
         "               solver_tolerance; r [kg] (printed methods); threads (nscd)\n"
         "[output]       interval [s] of the rows of trajectory.tsv (if not given: only start and end);\n"
         "               columns (else a choice by the system)\n"
         "[contact.NAME] law = \"frictionless\", \"coulomb\" or \"contensou\"; mu (the last two);\n"
         "               between = [\"A\", \"B\"] (bodies): what touches; restitution (else 0);\n"
         "               contensou: pressure (see contensou law --help) or \"table\" with table_radius and\n"
         "               table_pressure; radius [m] (0 is the limit of a point contact: coulomb) or "
         "\"hertz\"\n"
         "               with modulus [Pa]; model = \"exact\" (if not given), \"ellipsoid\" or "
         "\"uncoupled\"\n"
         "[outcome.NAME] kind = \"final\", \"minimum\", \"maximum\", \"crossing\" (of value) or "
         "\"trajectory\",\n"
         "               of column; \"event\" or \"count\" of event, of contact; occurrence of the event\n"
         "Bodies:\n"
         "[body.NAME]    rotation = \"free\", \"upright\", \"driven\" or \"none\"; mass [kg]; inertia [kg "
         "m^2];\n"
         "               position [m]; touching (a plane); orientation [w, x, y, z]; velocity [m/s];\n"
         "               spin [rad/s]; linear_drag [N s/m]; angular_drag [N m s]\n"
         "[body.NAME.sphere.NAME]  centre, radius [m]\n"
         "[body.NAME.base]         height [m]: a flat round base\n"
         "[balls.NAME]   count; radius [m]; mass [kg]; rotation = \"free\" or \"none\"; lower, spacing [m]\n"
         "               and across = [NX, NY] of their lattice; jitter [m] with seed; velocity, spin,\n"
         "               linear_drag, angular_drag as of a body\n"
         "[plane.NAME]   normal (of length 1, outward), offset [m]\n"
         "[box.NAME]     lower, upper [m]; sides: any of bottom, top, west, east, south, north\n"
         "[load.NAME]    body; force [N], torque [N m]; times [s] with factors; frequency [Hz], phase [rad]\n"
         "Tippe-top:\n"
         "[top]          mass [kg], i1, i3 [kg m^2], a1, a2, r1, r2 [m]: LG03 5.4\n"
         "[initial]      theta [rad], psi_dot [rad/s], z_s [m] or \"contact\": just touching the floor\n"
         "[contact.body] [contact.tip]\n";
}

}  // namespace contensou
