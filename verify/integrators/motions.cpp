#include "motions.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "contensou/system/ball_on_plane.hpp"
#include "contensou/system/harmonic_oscillator.hpp"
#include "contensou/system/point_mass.hpp"
#include "contensou/system/sliding_disc.hpp"
#include "contensou/system/tippe_top_axis.hpp"
#include "contensou/system/tippe_top_euler.hpp"
#include "measure.hpp"
#include "motions/bounces.hpp"
#include "motions/free_rotation.hpp"
#include "motions/point_slide.hpp"
#include "motions/slide_and_spin.hpp"
#include "smooth_reference.hpp"

namespace verify::integrators {
namespace {

using namespace contensou;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
namespace known = known_motions;

const AnyFriction frictionless{NoFriction{}};
const AnyFriction point{FrictionDisk{}};
const AnyFriction hertz{FrictionBall(SmoothPlate(HertzLaw{}))};

constexpr double gravity = 9.81;
constexpr double spin = 180;      ///< LG03 5.4 [rad/s]
constexpr double top_rate = 100;  ///< of the size of the top's spin
constexpr double reference_tolerance = 1e-13;
constexpr double check_tolerance = 1e-12;

const std::vector<double> top_steps{4e-4, 2e-4, 1e-4, 5e-5};

VectorXd numbers(std::initializer_list<double> values) {
  VectorXd v(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), v.begin());
  return v;
}

std::shared_ptr<const TippeTopAxis> top_with(const AnyFriction& friction, double mu, double restitution = 0) {
  return std::make_shared<TippeTopAxis>(TippeTopData{}, tippe_top_contacts(friction, mu, 5e-4, restitution));
}

Motion::Path to(const State& start, const State& end) { return {start, end, 0}; }

// --- free flight ---

/// Thrown up, turning about all axes.
State top_in_flight(const TippeTopAxis& top) {
  State s = top.start(0.7, spin, 0.1);
  s.u.tail<3>() += Vector3d(20, -10, 5);
  s.u.head<3>() = Vector3d(0.1, 0.2, 0.3);
  return s;
}

/// Euler's top in closed form, and a parabola.
State flown(const TippeTopAxis& top, const State& start, double t) {
  const Vector3d e = top.axis(start.q), omega = top.spin(start.q, start.u);
  Eigen::Matrix3d frame;  // columns: the body's axes at the start
  frame.col(2) = e;
  frame.col(0) = e.cross(Vector3d::UnitX()).normalized();
  frame.col(1) = e.cross(frame.col(0));
  const known::SymmetricRotation rotation(top.data().i1, top.data().i3, frame.transpose() * omega);
  const Eigen::Matrix3d attitude = frame * rotation.attitude(t);
  State end{t, VectorXd(6), VectorXd(6)};
  const Vector3d fall(0, 0, -top.data().g), v = start.u.head<3>();
  end.q << start.q.head<3>() + v * t + fall * t * t / 2, attitude.col(2);
  end.u << v + fall * t, attitude * rotation.omega(t);
  return end;
}

Motion flight() {
  const auto top = top_with(hertz, 0.3);
  const State start = top_in_flight(*top);
  return {"flight", "the top in free flight, nutating",    "closed form", top,
          top_rate, {to(start, flown(*top, start, 0.05))}, top_steps};
}

Motion oscillation() {
  const auto system = std::make_shared<HarmonicOscillator>(HarmonicOscillatorData{.m = 2, .k = 18});
  const double t = 2, w = system->frequency();
  return {"oscillation",
          "a harmonic oscillator, ω = 3/s",
          "closed form",
          system,
          w,
          {to({0, numbers({1}), numbers({0.5})}, {t, numbers({std::cos(w * t) + 0.5 / w * std::sin(w * t)}),
                                                  numbers({0.5 * std::cos(w * t) - w * std::sin(w * t)})})},
          {4e-2, 2e-2, 1e-2, 5e-3}};
}

// --- slip ---

Motion slip_top() {
  const auto top = top_with(hertz, 0.3);
  const State start = top->start(0.1, spin);
  const double t = 0.02;
  const State end = smooth_reference(*top, Kept::slip, start, t, 400);
  Motion motion{"slip_top",
                "the paper's start: the top slips and drills on its body, Hertz",
                "Fehlberg's method of order 8 for the slipping top; checked: event_driven",
                top,
                top_rate,
                {to(start, end)},
                top_steps};
  motion.doubt =
      difference(*top, top_rate, end, run(*top, start, t, Method::event_driven, reference_tolerance).end);
  return motion;
}

Motion slip_disc() {
  const double mu = 0.3, m = 2, i = 0.5, radius = 0.6;
  const auto disc = std::make_shared<SlidingDisc>(SlidingDiscData{.m = m, .i = i, .g = gravity},
                                                  SystemContact{"floor", hertz, mu, radius, 0});
  const double v = 0.5, omega = 3;  // u from 0.28 down to 0: does not pass u = 1
  const known::SlideAndSpin<HertzLaw> slide(HertzLaw{}, mu * gravity, mu * gravity * m * radius * radius / i,
                                            v, omega * radius);
  const double t = 0.5 * slide.stopping_time();
  const auto at = slide.at(t);
  return {"slip_disc",
          "a disc slides and spins, Hertz, up to half the time to rest",
          "quadrature",
          disc,
          1,
          {to({0, numbers({0, 0, 0, 0}), numbers({v, 0, 0, omega})},
              {t, numbers({at.slid, 0, 0, at.turned / radius}), numbers({at.v, 0, 0, at.s / radius})})},
          {t / 20, t / 40, t / 80, t / 160}};
}

Motion slip_point() {
  const double mu = 0.8, tilt = 0.3;
  const auto block = std::make_shared<PointMass>(PointMassData{.m = 2, .g = gravity, .tilt = tilt},
                                                 SystemContact{"floor", point, mu, 0, 0});
  const known::PointSlide slide(Vector2d(0.5, 2), gravity * std::sin(tilt), mu * gravity * std::cos(tilt));
  const double t = 0.5 * slide.stopping_time();
  const auto at = slide.at(t);
  return {"slip_point",
          "a block slides across an incline, Coulomb, up to half the time to rest",
          "closed form",
          block,
          1,
          {to({0, numbers({0, 0, 0}), numbers({0.5, 2, 0})},
              {t, numbers({at.displacement.x(), at.displacement.y(), 0}),
               numbers({at.velocity.x(), at.velocity.y(), 0})})},
          {t / 20, t / 40, t / 80, t / 160}};
}

// --- stick, rolling ---

Motion roll_top() {
  const auto top = top_with(point, 5);
  State start = top->start(0.7, 30);
  start.u.tail<3>() += Vector3d(3, 0, 2);
  ContactRows rows(6);
  top->contact_rows(0, 0, start.q, start.u, rows);
  start.u.head<3>() -= Vector3d(rows.velocity[1], rows.velocity[2], rows.velocity[0]);
  const double t = 0.1;
  const State end = smooth_reference(*top, Kept::roll, start, t, 400);
  Motion motion{"roll_top",
                "the top rolls on its body, R = 0, μ = 5",
                "Fehlberg's method of order 8 for the rolling top; checked: event_driven",
                top,
                top_rate,
                {to(start, end)},
                top_steps};
  motion.doubt =
      difference(*top, top_rate, end, run(*top, start, t, Method::event_driven, reference_tolerance).end);
  return motion;
}

Motion roll_ball() {
  const double tilt = 0.2, t = 1;
  const auto ball = std::make_shared<BallOnPlane>(BallOnPlaneData{.m = 1, .r = 1, .g = gravity, .tilt = tilt},
                                                  SystemContact{"plane", point, 0.5, 0, 0});
  const double a = 5.0 / 7 * gravity * std::sin(tilt);
  return {"roll_ball",
          "a ball rolls down an incline, Coulomb",
          "closed form",
          ball,
          1,
          {to({0, numbers({0, 0, 1}), VectorXd::Zero(6)},
              {t, numbers({a * t * t / 2, 0, 1}), numbers({a * t, 0, 0, 0, a * t, 0})})},
          {4e-3, 2e-3, 1e-3, 5e-4}};
}

Motion stick_block() {
  const auto block =
      std::make_shared<PointMass>(PointMassData{.m = 2, .g = gravity, .tilt = 0.2, .force_y = 1},
                                  SystemContact{"floor", point, 0.5, 0, 0});
  const State start{0, VectorXd::Zero(3), VectorXd::Zero(3)};
  return {"stick_block",
          "a block is held on an incline by friction, Coulomb",
          "closed form",
          block,
          1,
          {to(start, {1, start.q, start.u})},
          {4e-3, 2e-3, 1e-3, 5e-4}};
}

// --- impacts ---

/// A point that bounces and slides all the time, from z with v along x: whatever its impacts, its momentum
/// along x falls by μ times what the floor gave it upwards.
Motion::Path thrown(double z, double v, double mu, double restitution, double t) {
  const known::Bounces bounces(z, 0, gravity, restitution);
  const auto at = bounces.at(t);
  const double given = gravity * t + at.velocity;
  const double passed = gravity * t * t / 2 + at.z - z;
  return {{0, numbers({0, 0, z}), numbers({v, 0, 0})},
          {t, numbers({v * t - mu * passed, 0, at.z}), numbers({v - mu * given, 0, at.velocity})},
          bounces.accumulation_time()};
}

std::shared_ptr<const MechanicalSystem> thrown_point(double mu, double restitution) {
  return std::make_shared<PointMass>(PointMassData{.m = 2, .g = gravity},
                                     SystemContact{"floor", point, mu, 0, restitution});
}

Motion impact_point(const char* phase, const char* what, double restitution) {
  Motion motion{phase, what, "closed form", thrown_point(0.3, restitution), 1, {}, {4e-3, 2e-3, 1e-3, 5e-4}};
  // They land at 0.1 s; ends before a rebound by v/3, or by v/2, is over.
  for (int k = 0; k < 8; ++k) motion.paths.push_back(thrown(0.05 + 3.7e-4 * k, 2, 0.3, restitution, 0.14));
  return motion;
}

/// By event_driven, checked with the top in Euler's angles.
Motion impact_top(const char* phase, const char* what, double restitution) {
  const auto top = top_with(hertz, 0.3, restitution);
  const TippeTopEuler euler(TippeTopData{}, tippe_top_contacts(hertz, 0.3, 5e-4, restitution));
  Motion motion{phase, what,     "event_driven, 1e-13; checked: in Euler angles, 1e-12", top, top_rate,
                {},    top_steps};
  const double t = 0.03, theta = 0.3;
  for (int k = 0; k < 8; ++k) {
    const double z = top->start(theta, spin).q[2] + 2e-3 + 3.1e-5 * k;
    const State start = top->start(theta, spin, z);
    const State end = run(*top, start, t, Method::event_driven, reference_tolerance).end;
    const State other = run(euler, euler.start(theta, spin, z), t, Method::event_driven, check_tolerance).end;
    State same{t, VectorXd(6), VectorXd(6)};
    same.q << other.q.head<3>(), euler.axis(other.q);
    same.u << other.u.head<3>(), euler.spin(other.q, other.u);
    motion.doubt = std::max(motion.doubt, difference(*top, top_rate, end, same));
    motion.paths.push_back(to(start, end));
  }
  return motion;
}

// --- accumulation ---

Motion bouncing_ball() {
  Motion motion{"accumulation_ball",
                "a ball bounces to rest and slides, ε = 0.6",
                "closed form",
                thrown_point(0.3, 0.6),
                1,
                {},
                {8e-3, 4e-3, 2e-3, 1e-3, 5e-4}};
  for (int k = 0; k < 8; ++k) motion.paths.push_back(thrown(0.1 + 3.7e-4 * k, 3, 0.3, 0.6, 0.7));
  motion.timed = true;
  return motion;
}

/// The paper's top shortly before its body touches again, rocking to rest in double contact.
Motion rocking_top() {
  const auto top = top_with(hertz, 0.3);
  Motion motion{"accumulation_top",
                "the paper's top rocks to rest on body and tip, 4.74 s to 4.91 s",
                "event_driven, 1e-13; checked: 1e-12",
                top,
                top_rate,
                {},
                top_steps,
                {1e-4, 5e-5, 2.5e-5, 1.25e-5}};
  const double before = 4.74, after = 4.91;
  State start = run(*top, paper_start(), before, Method::event_driven, reference_tolerance).end;
  for (int k = 0; k < 6; ++k) {
    start = run(*top, start, before + 1.7e-5 * k, Method::event_driven, reference_tolerance).end;
    const Run best = run(*top, start, after, Method::event_driven, reference_tolerance);
    const Run check = run(*top, start, after, Method::event_driven, check_tolerance);
    const double end = last_closing(best.report.events).value_or(std::nan(""));
    motion.doubt = std::max(motion.doubt, difference(*top, top_rate, best.end, check.end));
    motion.doubt_of_time =
        std::max(motion.doubt_of_time, std::abs(end - last_closing(check.report.events).value_or(INFINITY)));
    motion.paths.push_back({start, best.end, end});
  }
  motion.timed = true;
  return motion;
}

}  // namespace

std::shared_ptr<const MechanicalSystem> paper_top() { return top_with(hertz, 0.3); }
State paper_start() { return top_with(hertz, 0.3)->start(0.1, spin); }

std::vector<Motion> all_motions() {
  return {flight(),
          oscillation(),
          slip_top(),
          slip_disc(),
          slip_point(),
          roll_top(),
          roll_ball(),
          stick_block(),
          impact_point("impact_point", "a point dropped on the floor slides on, ε = 0", 0),
          impact_top("impact_top", "the top dropped on the floor slides on, ε = 0", 0),
          impact_point("bounce_point", "a point dropped on the floor bounces once, ε = 0.5", 0.5),
          impact_top("bounce_top", "the top dropped on the floor bounces once, ε = 0.5", 0.5),
          bouncing_ball(),
          rocking_top()};
}

}  // namespace verify::integrators
