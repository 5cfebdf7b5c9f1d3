#include <contensou/contact/contact_solver.hpp>
#include <iostream>

int main() {
  // A billiard ball drops on the table at 1 m/s, sliding at 0.5 m/s and spinning at 300 rad/s; SI units.
  const double mass = 0.17, radius = 0.0286, inertia = 0.4 * mass * radius * radius, patch = 2e-3;
  const contensou::AnyFriction friction =
      contensou::FrictionBall(contensou::SmoothPlate(contensou::HertzLaw{}));
  contensou::ContactProblem problem{.groups = {{&friction, {0.2}}}, .delassus = {}, .free_velocity = {}};
  const double slide = 1 / mass + radius * radius / inertia, spin = patch * patch / inertia;
  problem.delassus = Eigen::Vector4d(1 / mass, slide, slide, spin).asDiagonal();  // rows N, T1, T2, tau
  problem.free_velocity = Eigen::Vector4d(-(1 + 0.5) * 1, 0.5, 0, 300 * patch);   // restitution 0.5

  contensou::ContactSolver solver;
  Eigen::VectorXd impulse;  // on entry the initial guess; empty: none
  const contensou::SolverReport report = solver.solve(problem, impulse);
  std::cout << "normal " << impulse[0] << ", friction " << impulse[1] << ", torque / R " << impulse[3]
            << " N s, " << (report.status == contensou::SolverStatus::solved ? "solved" : "not solved")
            << '\n';
}
