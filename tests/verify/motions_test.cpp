// The motions that are known in closed form satisfy the equations of motion of the systems they are for.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "../system/differences.hpp"
#include "../system/small_contacts.hpp"
#include "contensou/law/hertz.hpp"
#include "contensou/law/uniform.hpp"
#include "contensou/system/ball_on_plane.hpp"
#include "contensou/system/free_body.hpp"
#include "contensou/system/point_mass.hpp"
#include "contensou/system/sliding_disc.hpp"
#include "motions/ball_slide.hpp"
#include "motions/bounces.hpp"
#include "motions/free_rotation.hpp"
#include "motions/point_slide.hpp"
#include "motions/slide_and_spin.hpp"

using namespace contensou;
using namespace known_motions;
using namespace system_test;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// u̇ and q̇ by differences are those of the system under the contact force λ.
template <class Motion>
void check_obeys(const MechanicalSystem& system, const Motion& motion, double t,
                 const Eigen::VectorXd& lambda) {
  const State s = motion(t);
  const Eigen::VectorXd change = rate([&](double dt) -> Eigen::VectorXd {
    const State later = motion(t + dt);
    return (Eigen::VectorXd(s.q.size() + s.u.size()) << later.q, later.u).finished();
  });
  Eigen::VectorXd expected_rates(s.q.size());
  Eigen::VectorXd expected(s.u.size());
  system.coordinate_rates(s.q, s.u, expected_rates);
  system.free_acceleration(t, s.q, s.u, expected);
  ContactRows rows(s.u.size());
  system.contact_rows(0, t, s.q, s.u, rows);
  expected += rows.response.leftCols(lambda.size()) * lambda;
  CHECK((change.head(s.q.size()) - expected_rates).norm() <= difference_bound);
  CHECK((change.tail(s.u.size()) - expected).norm() <= difference_bound);
}

constexpr double mu = 0.9;
constexpr double gravity = 2;
constexpr double tilt = 0.4;

}  // namespace

TEST_CASE("Known motions: bounces", "[motions]") {
  const Bounces bounces(1.2, 0.7, gravity, 0.8);
  double before = 0;
  for (int k = 0; k < 5; ++k) {
    const double t = bounces.impact_time(k);
    CHECK(t > before);
    before = t;
    CHECK(std::abs(bounces.at(t).z) <= 1e-14);
    const double in = bounces.at(t - 1e-7).velocity + gravity * -1e-7;
    const double out = bounces.at(t + 1e-7).velocity + gravity * 1e-7;
    CHECK(in < 0);
    CHECK(std::abs(out + 0.8 * in) <= 1e-14);
    const double inside = t + 0.3 * (bounces.impact_time(k + 1) - t);
    CHECK(std::abs(rate([&](double dt) { return bounces.at(inside + dt).velocity; }) + gravity) <= 1e-12);
    CHECK(std::abs(rate([&](double dt) { return bounces.at(inside + dt).z; }) -
                   bounces.at(inside).velocity) <= 1e-12);
  }
  CHECK(std::abs(bounces.impact_time(400) - bounces.accumulation_time()) <= 1e-14);
  CHECK(bounces.at(bounces.accumulation_time() - 1e-3).z > 0);
  CHECK(bounces.at(bounces.accumulation_time() + 1e-3).z == 0);
  // from rest the bounces take (1 + ε)/(1 − ε) of the fall
  const Bounces dropped(1, 0, gravity, 0.5);
  CHECK(std::abs(dropped.accumulation_time() - 3.0) <= 1e-15);
  CHECK(Bounces(1, 0, gravity, 0).accumulation_time() == 1);
}

TEST_CASE("Known motions: a block with Coulomb friction on an incline", "[motions]") {
  const PointMass block({.m = 1.3, .g = gravity, .tilt = tilt}, coulomb_floor(mu));
  const double pull = gravity * std::sin(tilt);
  const double friction = mu * gravity * std::cos(tilt);
  for (const Vector2d& v : {Vector2d(0.8, 1.1), Vector2d(-1.2, -0.5), Vector2d(0.9, 0), Vector2d(-0.9, 0)}) {
    const PointSlide slide(v, pull, friction);
    const auto motion = [&](double t) {
      const auto [w, x] = slide.at(t);
      return State{t, Eigen::VectorXd{{x[0], x[1], 0}}, Eigen::VectorXd{{w[0], w[1], 0}}};
    };
    const double end = slide.stopping_time();
    CHECK((slide.at(0).velocity - v).norm() <= 1e-15);
    CHECK(slide.at(end).velocity.norm() == 0);
    CHECK((slide.at(end + 1).displacement - slide.at(end).displacement).norm() == 0);
    CHECK((slide.at(end * (1 - 1e-9)).displacement - slide.at(end).displacement).norm() <= 1e-9);
    for (const double part : {0.1, 0.4, 0.7}) {
      const double t = part * end;
      const Vector2d w = slide.at(t).velocity;
      const double load = 1.3 * gravity * std::cos(tilt);
      const Vector2d force = -mu * load * w.normalized();
      check_obeys(block, motion, t, Eigen::Vector3d(load, force[0], force[1]));
    }
  }
  // On a level plane: v²/(2μg) in v/(μg)
  const PointSlide level({3, 4}, 0, 2);
  CHECK(level.stopping_time() == 2.5);
  CHECK((level.at(2.5).displacement - Vector2d(3.75, 5)).norm() <= 1e-15);
}

TEST_CASE("Known motions: a ball slides until it rolls", "[motions]") {
  const BallOnPlaneData data{.m = 1.3, .r = 0.7, .g = gravity, .tilt = tilt};
  const BallOnPlane ball(data, coulomb_floor(mu));
  const double pull = gravity * std::sin(tilt);
  const double grip = mu * gravity * std::cos(tilt);
  const double load = 1.3 * gravity * std::cos(tilt);
  const Vector2d contact(1.1, 0.8);
  const PointSlide gamma(contact, pull, 3.5 * grip);
  const BallSlide slide{{0.4, -0.6}, contact, pull};
  const auto motion = [&](double t) {
    const auto [w, slid] = gamma.at(t);
    const Vector2d x = slide.displacement(t, slid);
    const Vector2d v = slide.velocity(t, w);
    const Vector2d spin = BallSlide::spin(v, w, data.r);
    return State{t, Eigen::VectorXd{{x[0], x[1], data.r}},
                 Eigen::VectorXd{{v[0], v[1], 0, spin[0], spin[1], 0.9}}};
  };
  const double end = gamma.stopping_time();
  for (const double t : {0.2 * end, 0.6 * end}) {
    ContactRows rows(6);
    const State s = motion(t);
    ball.contact_rows(0, t, s.q, s.u, rows);
    const Vector2d w(rows.velocity[1], rows.velocity[2]);
    CHECK((w - gamma.at(t).velocity).norm() <= 1e-15);
    const Vector2d force = -mu * load * w.normalized();
    check_obeys(ball, motion, t, Eigen::Vector3d(load, force[0], force[1]));
  }
  // rolling, held by 2/7 of the pull
  check_obeys(ball, motion, 1.5 * end, Eigen::Vector3d(load, -2.0 / 7 * 1.3 * pull, 0));

  // started without spin on a level plane: 5/7 of the velocity after 2v/(7μg)
  const PointSlide level({3, 4}, 0, 3.5 * 0.4);
  const BallSlide plain{{3, 4}, {3, 4}, 0};
  CHECK(std::abs(level.stopping_time() - 2 * 5 / (7 * 0.4)) <= 1e-15);
  CHECK((plain.velocity(9, level.at(9).velocity) - 5.0 / 7 * Vector2d(3, 4)).norm() <= 1e-15);
  // the path while sliding: 12/49 v²/(μg)
  const double rolls = level.stopping_time();
  CHECK((plain.displacement(rolls, level.at(rolls).displacement) - 12.0 / 49 * 5 / 0.4 * Vector2d(3, 4))
            .norm() <= 1e-14);
}

TEST_CASE("Known motions: a free body by Jacobi's functions", "[motions]") {
  // all six orders of the moments, angular momentum about the largest and about the smallest
  for (const Vector3d& inertia :
       {Vector3d(0.7, 1.1, 1.5), Vector3d(1.1, 0.7, 1.5), Vector3d(0.7, 1.5, 1.1), Vector3d(1.5, 1.1, 0.7),
        Vector3d(1.1, 1.5, 0.7), Vector3d(1.5, 0.7, 1.1)}) {
    for (const Vector3d& omega :
         {Vector3d(0.3, -0.2, 0.9), Vector3d(-0.9, 0.3, 0.2), Vector3d(0.2, -0.8, -0.3)}) {
      const FreeBody body({inertia[0], inertia[1], inertia[2]});
      const FreeRotation rotation(inertia, omega);
      CHECK((rotation.omega(0) - omega).norm() <= 1e-14);
      CHECK((rotation.attitude(0) - Matrix3d::Identity()).norm() <= 1e-14);
      for (const double t : {0.7, 5.3}) {
        const Eigen::VectorXd u = rotation.omega(t);
        const Matrix3d attitude = rotation.attitude(t);
        const Eigen::Quaterniond quaternion(attitude);
        const Eigen::VectorXd q{{quaternion.w(), quaternion.x(), quaternion.y(), quaternion.z()}};
        CHECK((attitude.transpose() * attitude - Matrix3d::Identity()).norm() <= 1e-14);
        CHECK((body.angular_momentum(q, u) - inertia.cwiseProduct(omega)).norm() <= 1e-13);
        Eigen::VectorXd expected(3);
        body.free_acceleration(t, q, u, expected);
        const Vector3d change = rate([&](double dt) -> Vector3d { return rotation.omega(t + dt); });
        CHECK((change - expected).norm() <= difference_bound);
        const Matrix3d turning = rate([&](double dt) -> Matrix3d { return rotation.attitude(t + dt); });
        for (int k = 0; k < 3; ++k) {
          CHECK((turning.col(k) - attitude * Vector3d(u).cross(Vector3d::Unit(k))).norm() <=
                difference_bound);
        }
      }
    }
  }
}

TEST_CASE("Known motions: a free symmetric body, and as the limit of three moments", "[motions]") {
  const Vector3d omega(0.5, -0.4, 0.9);
  for (const double along : {0.6, 1.9}) {
    const FreeBody body({1.1, 1.1, along});
    const SymmetricRotation rotation(1.1, along, omega);
    for (const double t : {0.0, 3.1}) {
      const Eigen::VectorXd u = rotation.omega(t);
      const Matrix3d attitude = rotation.attitude(t);
      Eigen::VectorXd expected(3);
      body.free_acceleration(t, Eigen::Vector4d(1, 0, 0, 0), u, expected);
      const Vector3d change = rate([&](double dt) -> Vector3d { return rotation.omega(t + dt); });
      CHECK((change - expected).norm() <= difference_bound);
      const Matrix3d turning = rate([&](double dt) -> Matrix3d { return rotation.attitude(t + dt); });
      for (int k = 0; k < 3; ++k)
        CHECK((turning.col(k) - attitude * Vector3d(u).cross(Vector3d::Unit(k))).norm() <= difference_bound);
      // moments that differ by δ: other by some δt
      const double delta = 1e-9;
      const FreeRotation near({1.1, 1.1 + delta, along}, omega);
      CHECK((near.omega(t) - rotation.omega(t)).norm() <= 1e-8);
      CHECK((near.attitude(t) - attitude).norm() <= 1e-8);
    }
  }
}

namespace {

/// Through all of its motion by differences, and the ends.
template <class Law>
void check_slide_and_spin(const Law& law, double radius, const SystemContact& contact, double i, double v,
                          double spin) {
  const SlidingDisc disc({.m = 1.3, .i = i, .g = gravity}, contact);
  const double a = mu * gravity;
  const SlideAndSpin slide(law, a, a * 1.3 * radius * radius / i, v, spin * radius);
  const auto motion = [&](double t) {
    const auto p = slide.at(t);
    return State{t, Eigen::VectorXd{{0.6 * p.slid, 0.8 * p.slid, 0, -p.turned / radius}},
                 Eigen::VectorXd{{0.6 * p.v, 0.8 * p.v, 0, -p.s / radius}}};
  };
  const double end = slide.stopping_time();
  const auto start = slide.at(0);
  CHECK(std::abs(start.v - v) <= 1e-14 * v);
  CHECK(std::abs(start.s - spin * radius) <= 1e-14);
  CHECK(slide.at(end).v == 0);
  CHECK(slide.at(end).s == 0);
  for (const double part : {0.3, 0.8}) {
    const double t = part * end;
    const State s = motion(t);
    const auto [xi, eta] = law.at(std::hypot(s.u[0], s.u[1]), std::abs(s.u[3]) * radius);
    const double limit = mu * 1.3 * gravity;
    check_obeys(disc, motion, t,
                Eigen::Vector4d(1.3 * gravity, -0.6 * limit * xi, -0.8 * limit * xi, limit * eta));
  }
}

}  // namespace

TEST_CASE("Known motions: a disc that slides and spins", "[motions]") {
  const double radius = 0.8;
  const double homogeneous = 1.3 * radius * radius / 2;  // κ = 2
  check_slide_and_spin(UniformLaw{}, radius, uniform_floor(mu, radius), homogeneous, 0.4, 1.7);
  check_slide_and_spin(UniformLaw{}, radius, uniform_floor(mu, radius), homogeneous, 1.6,
                       1.2);  // across u = 1
  check_slide_and_spin(UniformLaw{}, radius, uniform_floor(mu, radius), 1.7 * homogeneous, 0.9,
                       1.2);  // u* = 0
  check_slide_and_spin(HertzLaw{}, radius, hertz_floor(mu, radius), 0.7 * homogeneous, 0.9, 1.6);
}

TEST_CASE("Known motions: the ratio in which a homogeneous disc comes to rest", "[motions]") {
  // Z. Farkas, G. Bartels, T. Unger, D. E. Wolf, Phys. Rev. Lett. 90, 248302 (2003): 0.653 for uniform
  // pressure.
  const SlideAndSpin disc(UniformLaw{}, 1.0, 2.0, 0.4, 1.0);
  CHECK(std::abs(disc.final_ratio() - 0.653) <= 5e-4);
  // Started with this ratio it keeps it: straight lines in time.
  const double ratio = disc.final_ratio();
  const SlideAndSpin steady(UniformLaw{}, 1.0, 2.0, ratio * 1.4, 1.4);
  const double eta = UniformLaw{}.at(ratio, 1).eta;
  CHECK(std::abs(steady.stopping_time() - 1.4 / (2 * eta)) <= 1e-14);
  CHECK(std::abs(steady.at(0.3).s - (1.4 - 0.6 * eta)) <= 1e-14);
  CHECK(std::abs(steady.at(0.3).v - ratio * steady.at(0.3).s) <= 1e-14);
  // A ring's spin outlasts its sliding; a heavy hub's does not outlast it, and that is not in here.
  CHECK(SlideAndSpin(UniformLaw{}, 1.0, 1.0, 0.4, 1.0).final_ratio() == 0);
  CHECK_THROWS_WITH(SlideAndSpin(UniformLaw{}, 1.0, 4.5, 0.4, 1.0),
                    "slide and spin: the motion ends without spin");
}

TEST_CASE("Known motions: nearly pure spin and nearly pure sliding", "[motions]") {
  // what alone would need s/(bη(0)), or v/a, is disturbed by the other in proportion to it
  const double little = 1e-4;
  const SlideAndSpin spins(HertzLaw{}, 1.0, 0.7, little, 1.0);
  CHECK(std::abs(spins.stopping_time() - 1 / (0.7 * HertzLaw{}.extent().eta)) <= 10 * little);
  const SlideAndSpin slides(HertzLaw{}, 1.0, 3.0, 1.0, little);
  CHECK(std::abs(slides.stopping_time() - 1) <= 10 * little);
}
