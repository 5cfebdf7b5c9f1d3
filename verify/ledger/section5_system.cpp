// LG03 Sections 5.1 to 5.3: attitude, equations of motion and contacts of the tippe-top, (5.1) to (5.21). The
// oracles are turns about axes, a body of six mass points, differences of positions and of Lagrange's
// function, and the lowest point of a sphere.

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "oracle.hpp"
#include "top_oracle.hpp"

namespace verify::ledger {
namespace {

using namespace top;
using Scalar = Eigen::Matrix<double, 1, 1>;

/// Closed forms of numbers of order one to ten against each other.
constexpr double rounding = 1e-13;
/// Second differences of exact quadratics and five-point rates of five-point rates: 1e-13/h twice.
constexpr double twice_differenced = 1e-6;

constexpr double pi_double = std::numbers::pi;

/// generic() and states with the axis downward, at other angles and speeds of either sign.
std::vector<State> states() {
  std::vector<State> all{generic()};
  State s;
  s.q << -0.4, 0.1, 2.0, 2.6, -2.3, 0.8;
  s.u << -0.3, 0.6, -0.7, -0.8, 1.7, -1.2;
  all.push_back(s);
  s.q << 0.2, 0.9, 1.1, 1.5, 3.9, 5.2;
  s.u << 1.1, 0.2, 0.4, 0.6, 1.2, 1.9;
  all.push_back(s);
  return all;
}

/// The worst of a check over the states.
template <class Check>
Trial over_states(Check check) {
  std::vector<Trial> trials;
  for (const State& s : states()) trials.push_back(check(s));
  return worst(trials);
}

Trial same(const Eigen::Ref<const Eigen::MatrixXd>& expected,
           const Eigen::Ref<const Eigen::MatrixXd>& obtained) {
  return absolute(0, (obtained - expected).norm() / expected.norm());
}

Matrix3d about(double angle, const Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

// 5.1

Finding cosine_matrices() {
  const Trial t = over_states([](const State& s) {
    // The frame's axes as columns, turned about axes of its own.
    Matrix3d frame = Matrix3d::Identity();
    frame = about(s.q[4], frame.col(2)) * frame;
    frame = about(s.q[3], frame.col(0)) * frame;
    frame = about(s.q[5], frame.col(2)) * frame;
    const Matrix3d printed = turn(s.q[5], 0, 1) * turn(s.q[3], 1, 2) * turn(s.q[4], 0, 1);
    return same(frame.transpose(), printed);
  });
  return {
      t,
      {},
      rounding,
      "A frame turned by φ about its e_3, by θ about its e_1, by ψ about its e_3 (Rodrigues): its axes are "
      "the rows of A⁴¹ to " +
          text(t.error, 2)};
}

Vector3d euler_rates(const State& s, bool in_body) {
  const Matrix3d a21 = turn(s.q[4], 0, 1);
  const Matrix3d a32 = turn(s.q[3], 1, 2);
  const Matrix3d a43 = turn(s.q[5], 0, 1);
  const Vector3d phi(0, 0, s.u[4]);
  const Vector3d theta(s.u[3], 0, 0);
  const Vector3d psi(0, 0, s.u[5]);
  if (in_body) return a43 * a32 * a21 * phi + a43 * a32 * theta + a43 * psi;
  return phi + a21.transpose() * theta + (a32 * a21).transpose() * psi;
}

Finding poisson_vector() {
  const Trial t = over_states([](const State& s) {
    const Vector3d omega = spin(s);
    return worst(
        {same(omega, euler_rates(s, false)), same(attitude(s.q).transpose() * omega, euler_rates(s, true))});
  });
  return {
      t,
      {},
      differences,
      "Ȧ¹⁴A⁴¹ by differences against the second and the third line: relative difference " + text(t.error, 2)};
}

/// (5.3), left and right.
Vector3d omega_floor(const State& s) {
  const double theta = s.q[3];
  const double phi = s.q[4];
  return {s.u[3] * std::cos(phi) + s.u[5] * std::sin(phi) * std::sin(theta),
          s.u[3] * std::sin(phi) - s.u[5] * std::cos(phi) * std::sin(theta),
          s.u[4] + s.u[5] * std::cos(theta)};
}
Vector3d omega_body(const State& s) {
  const double theta = s.q[3];
  const double psi = s.q[5];
  return {s.u[4] * std::sin(theta) * std::sin(psi) + s.u[3] * std::cos(psi),
          s.u[4] * std::sin(theta) * std::cos(psi) - s.u[3] * std::sin(psi),
          s.u[5] + s.u[4] * std::cos(theta)};
}

Finding omega_components() {
  const Trial t = over_states([](const State& s) {
    const Vector3d omega = spin(s);
    return worst({same(omega, omega_floor(s)), same(attitude(s.q).transpose() * omega, omega_body(s))});
  });
  return {t,
          {},
          differences,
          "Both columns against Ȧ¹⁴A⁴¹ by differences: relative difference " + text(t.error, 2)};
}

// 5.2

Finding coordinates() {
  const Trial t = over_states([](const State& s) {
    Matrix3d map;
    for (int k = 0; k < 3; ++k) map.col(k) = spin({s.q, Vector6::Unit(3 + k)});
    return relative(std::sin(s.q[3]), std::abs(map.determinant()));
  });
  return {t,
          {},
          differences,
          "ω as a linear map of (θ̇, φ̇, ψ̇) has the determinant sin θ, to " + text(t.error, 2) +
              ": six coordinates but for θ = 0 and θ = π, as 5.5 says"};
}

/// A body of six mass points with the mass and the moments of inertia of the top.
struct Points {
  double distance = std::sqrt((2 * i1 + i3) / (2 * m));
  double aside = i3 / (4 * distance * distance);
  double axial = (2 * i1 - i3) / (4 * distance * distance);

  template <class Sum>
  double sum(Sum term) const {
    double total = 0;
    for (int k = 0; k < 3; ++k) {
      for (const double sign : {-1.0, 1.0})
        total += term(k == 2 ? axial : aside, Vector3d(sign * distance * Vector3d::Unit(k)));
    }
    return total;
  }
};

double kinetic_by_points(const State& s) {
  const Matrix3d turning = rate([](const State& x) { return attitude(x.q); }, s, Vector6::Zero());
  return Points().sum(
      [&](double mass, const Vector3d& p) { return mass / 2 * (s.u.head<3>() + turning * p).squaredNorm(); });
}
double potential_by_points(const Vector6& q) {
  const Matrix3d body = attitude(q);
  return Points().sum([&](double mass, const Vector3d& p) { return mass * g * (q[2] + (body * p)[2]); });
}

/// The second line of (5.5).
double kinetic(const State& s) {
  const double turning = s.u[4] * std::sin(s.q[3]);
  const double along = s.u[5] + s.u[4] * std::cos(s.q[3]);
  return m / 2 * s.u.head<3>().squaredNorm() + i1 / 2 * (turning * turning + s.u[3] * s.u[3]) +
         i3 / 2 * along * along;
}

Finding kinetic_energy() {
  const Trial t = over_states([](const State& s) {
    const double points = kinetic_by_points(s);
    const double first = m / 2 * s.u.head<3>().squaredNorm() +
                         omega_body(s).dot(Vector3d(i1, i1, i3).cwiseProduct(omega_body(s))) / 2;
    return worst({relative(points, first), relative(points, kinetic(s))});
  });
  return {t,
          {},
          differences,
          "Both lines against Σm_k|ṙ_k|²/2 of six mass points with the top's mass and inertia, velocities by "
          "differences: relative difference " +
              text(t.error, 2)};
}

Finding potential_energy() {
  const Trial t =
      over_states([](const State& s) { return relative(potential_by_points(s.q), m * g * s.q[2]); });
  return {t, {}, rounding, "Against Σm_kgz_k of the six mass points: " + text(t.error, 2)};
}

/// An acceleration in which nothing is zero.
const Vector6 some_acceleration{{0.7, -0.3, 0.9, -1.4, 0.6, 1.1}};

/// d/dt T,q̇ − T,q + V,q by differences of the energies of the six points.
Vector6 lagrange(const State& s, const Vector6& acceleration) {
  const auto momenta = [](const State& x) {
    Vector6 p;
    for (int k = 0; k < 6; ++k) {
      State up = x;
      State down = x;
      up.u[k] += 1;  // T is quadratic in q̇: exact
      down.u[k] -= 1;
      p[k] = (kinetic_by_points(up) - kinetic_by_points(down)) / 2;
    }
    return p;
  };
  Vector6 forces;
  for (int k = 0; k < 6; ++k) {
    // Along q_k; the velocity stays what it is.
    const auto function = [&](const State& x) {
      return Scalar(kinetic_by_points({x.q, s.u}) - potential_by_points(x.q));
    };
    forces[k] = rate(function, {s.q, Vector6::Unit(k)}, Vector6::Zero())[0];
  }
  return rate(momenta, s, acceleration) - forces;
}

/// Newton's and Euler's laws for that acceleration, as generalised forces: what (5.7) must equal.
Vector6 newton_euler(const State& s, const Vector6& acceleration) {
  const auto momentum = [](const State& x) {
    const Matrix3d body = attitude(x.q);
    return (body * Vector3d(i1, i1, i3).asDiagonal() * body.transpose() * spin(x)).eval();
  };
  const Vector3d torque = rate(momentum, s, acceleration);
  Vector6 result;
  result.head<3>() = m * (acceleration.head<3>() + Vector3d(0, 0, g));
  for (int k = 0; k < 3; ++k) result[3 + k] = torque.dot(spin({s.q, Vector6::Unit(3 + k)}));
  return result;
}

Finding lagranges_equations() {
  const Trial t = over_states([](const State& s) {
    return same(newton_euler(s, some_acceleration), lagrange(s, some_acceleration));
  });
  return {t,
          {},
          twice_differenced,
          "Differences of T and V of the six mass points against Newton's and Euler's laws projected on the "
          "coordinates, at an arbitrary acceleration: relative difference " +
              text(t.error, 2)};
}

/// The left-hand sides of (5.8).
Vector6 equations(const State& s, const Vector6& a) {
  const double sin = std::sin(s.q[3]);
  const double cos = std::cos(s.q[3]);
  const double theta = s.u[3];
  const double phi = s.u[4];
  const double psi = s.u[5];
  return Vector6{{m * a[0], m * a[1], m * a[2] + m * g,
                  i1 * a[3] - (i1 - i3) * phi * phi * sin * cos + i3 * psi * phi * sin,
                  (i1 * sin * sin + i3 * cos * cos) * a[4] + i3 * a[5] * cos +
                      2 * (i1 - i3) * phi * theta * sin * cos - i3 * psi * theta * sin,
                  i3 * (a[5] + a[4] * cos - phi * theta * sin)}};
}

Finding equations_of_motion() {
  const Trial t = over_states([](const State& s) {
    const Vector6 reference = lagrange(s, some_acceleration);
    std::vector<Trial> trials;
    for (int k = 0; k < 6; ++k) {
      trials.push_back(
          absolute(0, (equations(s, some_acceleration) - reference)[k] / reference.tail<3>().norm()));
    }
    return worst(trials);
  });
  return {
      t,
      {},
      twice_differenced,
      "Each of the six against (5.7) by differences of T and V at an arbitrary acceleration: difference " +
          text(t.error, 2) + " of the angular ones' size"};
}

Finding mass_and_forces() {
  const Trial t = over_states([](const State& s) {
    // M is the second derivative of T, which is quadratic in q̇: exact.
    Matrix6 second;
    for (int k = 0; k < 6; ++k) {
      for (int l = 0; l < 6; ++l) {
        const auto at = [&](double x, double y) {
          State moved = s;
          moved.u += x * Vector6::Unit(k) + y * Vector6::Unit(l);
          return kinetic_by_points(moved);
        };
        second(k, l) = (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / 4;
      }
    }
    const Vector6 forces = second * some_acceleration - lagrange(s, some_acceleration);
    return worst({same(second, mass(s.q[3])), same(forces.tail<3>(), smooth(s).tail<3>()),
                  same(forces.head<3>(), smooth(s).head<3>())});
  });
  return {t,
          {},
          twice_differenced,
          "M against ∂²T/∂q̇², h against what (5.7) then leaves, all of the six mass points: relative "
          "difference " +
              text(t.error, 2)};
}

// 5.3

/// A unit vector with spherical coordinates around the downward axis.
Vector3d downward(double x, double y) { return Vector3d(x, y, -1).normalized(); }

/// The centre of the sphere.
Vector3d centre(int i, const Vector6& q) { return q.head<3>() + attitude(q).col(2) * a[i]; }

/// The point of the sphere nearest to M′, the centre's projection on the floor, by a search on the sphere.
Vector3d nearest(int i, const Vector6& q) {
  const Vector3d middle = centre(i, q);
  const Vector3d below(middle[0], middle[1], 0);
  const auto distance = [&](double x, double y) { return (middle + r[i] * downward(x, y) - below).norm(); };
  double x = 0.37;
  double y = -0.29;
  for (double step = 0.1; step > 1e-9; step /= 2) {
    for (bool moved = true; moved;) {
      moved = false;
      for (const auto& [dx, dy] : {std::pair{step, 0.0}, {-step, 0.0}, {0.0, step}, {0.0, -step}}) {
        if (distance(x + dx, y + dy) < distance(x, y)) {
          x += dx;
          y += dy;
          moved = true;
        }
      }
    }
  }
  return middle + r[i] * downward(x, y);
}
/// Of a minimum found by comparing values with 16 digits: its place to half of them.
constexpr double searched = 1e-6;

/// A state with both spheres above the floor.
std::vector<Vector6> above_floor() {
  std::vector<Vector6> all;
  for (State s : states()) {
    s.q[2] = 4;
    all.push_back(s.q);
  }
  return all;
}

/// (5.12) with the quantities of contact i.
Vector3d r_c(int i, const Vector6& q) {
  const double s = std::sin(q[3]);
  return {q[0] + a[i] * std::sin(q[4]) * s, q[1] - a[i] * std::cos(q[4]) * s,
          q[2] + a[i] * std::cos(q[3]) - r[i]};
}

Finding place_of_contact() {
  std::vector<Trial> trials;
  for (const Vector6& q : above_floor()) {
    const Vector3d sum = q.head<3>() + (centre(0, q) - q.head<3>()) + Vector3d(0, 0, -r[0]);
    trials.push_back(absolute(0, (nearest(0, q) - sum).norm()));
  }
  const Trial t = worst(trials);
  return {
      t,
      {},
      searched,
      "The point of the body's sphere nearest to M′, found by search, against r_S + r_SM + r_MC: distance " +
          text(t.error, 2) + " cm"};
}

Finding members() {
  const Trial t = over_states([](const State& s) {
    // e_3⁴ by turning the upright axis: S to M; and M lies r_1 above C.
    const Vector3d node = about(s.q[4], Vector3d::UnitZ()) * Vector3d::UnitX();
    const Vector3d axis = about(s.q[3], node) * Vector3d::UnitZ();
    const Vector3d sum = s.q.head<3>() + a[0] * axis - r[0] * Vector3d::UnitZ();
    const Matrix3d a41 = turn(s.q[5], 0, 1) * turn(s.q[3], 1, 2) * turn(s.q[4], 0, 1);
    return same(sum, s.q.head<3>() + a41.transpose() * Vector3d(0, 0, a[0]) + Vector3d(0, 0, -r[0]));
  });
  return {t,
          {},
          rounding,
          "The axis turned about the line of nodes by Rodrigues' formula against A¹⁴: " + text(t.error, 2)};
}

Finding place_in_angles() {
  std::vector<Trial> trials;
  for (const Vector6& q : above_floor()) {
    trials.push_back(absolute(0, (nearest(0, q) - r_c(0, q)).norm()));
    trials.push_back(absolute(0, (q.head<3>() + arm(0, q) - r_c(0, q)).norm()));
  }
  const Trial t = worst(trials);
  return {t, {}, searched, "Against the nearest point found by search: distance " + text(t.error, 2) + " cm"};
}

/// The height of the sphere's lowest point, over a net of its points refined round the lowest.
double lowest(int i, const Vector6& q) {
  const Vector3d middle = centre(i, q);
  const Matrix3d body = attitude(q);
  const auto height = [&](double polar, double azimuth) {
    const Vector3d normal(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                          std::cos(polar));
    return (middle + r[i] * (body * normal))[2];
  };
  double polar = pi_double / 2;
  double azimuth = 0;
  for (double range = pi_double; range > 1e-9; range /= 4) {
    double best = height(polar, azimuth);
    const double p0 = polar;
    const double a0 = azimuth;
    for (int j = -12; j <= 12; ++j) {
      for (int k = -12; k <= 12; ++k) {
        const double z = height(p0 + range * j / 12, a0 + range * k / 12);
        if (z < best) {
          best = z;
          polar = p0 + range * j / 12;
          azimuth = a0 + range * k / 12;
        }
      }
    }
  }
  return height(polar, azimuth);
}

Finding gap(int i) {
  const Trial t = over_states(
      [i](const State& s) { return absolute(lowest(i, s.q), s.q[2] + a[i] * std::cos(s.q[3]) - r[i]); });
  return {t,
          {},
          rounding,
          "The height of the lowest point of the turned sphere, by search over its points: difference " +
              text(t.error, 2) + " cm"};
}

Finding gap_rate() {
  const Trial t = over_states([](const State& s) {
    std::vector<Trial> trials;
    for (const int i : {0, 1}) {
      const auto height = [i](const State& x) { return Scalar(lowest(i, x.q)); };
      trials.push_back(
          absolute(rate(height, s, Vector6::Zero())[0], s.u[2] - a[i] * s.u[3] * std::sin(s.q[3])));
    }
    return worst(trials);
  });
  return {t,
          {},
          differences,
          "Differences of the lowest point's height along the motion, body and tip: " + text(t.error, 2) +
              " cm/s. \"Almost everywhere\" is the velocity's: it jumps in impacts"};
}

Finding normal_direction() {
  const Trial t = over_states([](const State& s) {
    std::vector<Trial> trials;
    for (const int i : {0, 1}) {
      Vector6 gradient;
      for (int k = 0; k < 6; ++k) {
        const auto height = [i](const State& x) { return Scalar(lowest(i, x.q)); };
        gradient[k] = rate(height, {s.q, Vector6::Unit(k)}, Vector6::Zero())[0];
      }
      trials.push_back(same(gradient, directions(i, s.q).col(0)));
    }
    return worst(trials);
  });
  return {t,
          {},
          differences,
          "Differences of the lowest point's height in each coordinate, body and tip: relative " +
              text(t.error, 2)};
}

/// The velocity of the point of the body that is at C, by differences of its position.
Vector3d material_velocity(int i, const State& s) {
  const Vector3d in_body = attitude(s.q).transpose() * (r_c(i, s.q) - s.q.head<3>());
  return rate([&](const State& x) { return (x.q.head<3>() + attitude(x.q) * in_body).eval(); }, s,
              Vector6::Zero());
}

Finding velocity_of_c() {
  const Trial t = over_states([](const State& s) {
    return same(material_velocity(0, s), s.u.head<3>() + omega_floor(s).cross(r_c(0, s.q) - s.q.head<3>()));
  });
  return {
      t,
      {},
      differences,
      "The path of the body's point that is at C, differentiated: relative difference " + text(t.error, 2)};
}

Finding velocity_of_which_point() {
  const State s = generic();
  const Vector3d printed = s.u.head<3>() + omega_floor(s).cross(r_c(0, s.q) - s.q.head<3>());
  const Vector3d place = rate([](const State& x) { return r_c(0, x.q); }, s, Vector6::Zero());
  return {same(place, printed), same(material_velocity(0, s), printed), differences,
          "In a generic state the point C of (5.12) moves at " + text((place - printed).norm(), 4) +
              " cm/s relative to v_C, along the floor (vertically both have ġ_N1, to " +
              text(std::abs(place[2] - printed[2]), 2) + ")"};
}

/// (5.18) with the quantities of contact i.
Vector3d v_c(int i, const State& s) {
  const double sin = std::sin(s.q[3]);
  const double cos = std::cos(s.q[3]);
  const double sf = std::sin(s.q[4]);
  const double cf = std::cos(s.q[4]);
  const double rolled = (a[i] * s.u[4] + r[i] * s.u[5]) * sin;
  const double tilted = s.u[3] * (a[i] * cos - r[i]);
  return {s.u[0] + rolled * cf + tilted * sf, s.u[1] + rolled * sf - tilted * cf,
          s.u[2] - a[i] * s.u[3] * sin};
}

Finding velocity_in_angles() {
  const Trial t = over_states([](const State& s) { return same(material_velocity(0, s), v_c(0, s)); });
  return {t,
          {},
          differences,
          "The path of the body's point that is at C, differentiated: relative difference " +
              text(t.error, 2) + "; its third component is (5.15)"};
}

Finding tangential_velocity() {
  const Trial t = over_states(
      [](const State& s) { return same(material_velocity(0, s).head<2>(), v_c(0, s).head<2>()); });
  return {t, {}, differences, "Its components along the floor: relative difference " + text(t.error, 2)};
}

Finding tangential_directions() {
  const Trial t = over_states([](const State& s) {
    std::vector<Trial> trials;
    for (const int i : {0, 1}) {
      Eigen::Matrix<double, 6, 2> by_differences;
      for (int k = 0; k < 6; ++k)
        by_differences.row(k) = material_velocity(i, {s.q, Vector6::Unit(k)}).head<2>().transpose();
      trials.push_back(same(by_differences, directions(i, s.q).middleCols<2>(1)));
    }
    return worst(trials);
  });
  return {t,
          {},
          differences,
          "Each coordinate moved alone, the path of the body's point at C differentiated, body and tip: "
          "relative difference " +
              text(t.error, 2)};
}

Finding spin_direction() {
  const Trial t = over_states([](const State& s) {
    Vector6 by_differences;
    for (int k = 0; k < 6; ++k) by_differences[k] = radius * spin({s.q, Vector6::Unit(k)})[2];
    return worst({same(by_differences, directions(0, s.q).col(3)),
                  relative(by_differences.dot(s.u), (s.u[4] + s.u[5] * std::cos(s.q[3])) * radius)});
  });
  return {t,
          {},
          differences,
          "R times the vertical component of ω from the attitude's differences, coordinate by coordinate: " +
              text(t.error, 2)};
}

}  // namespace

std::vector<Row> section5_system() {
  return {
      {"5.1", "(5.1)", "A⁴¹ = A⁴³(ψ)A³²(θ)A²¹(φ) and its three members", Flaw::none, "", "", cosine_matrices},
      {"5.2", "(5.2)", "ω = φ̇e_3¹ + θ̇e_1² + ψ̇e_3³, in the frames e¹ and e⁴", Flaw::none, "", "",
       poisson_vector},
      {"5.3", "(5.3)", "the components of ω in e¹ and e⁴", Flaw::none, "", "", omega_components},
      {"5.4", "(5.4)", "q = (x_S, y_S, z_S, θ, φ, ψ)", Flaw::none, "",
       "Near the upright positions u grows beyond bounds; the library has a second formulation without that.",
       coordinates},
      {"5.5", "(5.5)", "T in ω and in Euler angles", Flaw::none, "", "", kinetic_energy},
      {"5.6", "(5.6)", "V = mgz_S", Flaw::none, "", "", potential_energy},
      {"5.7", "(5.7)", "d/dt T,q̇ − T,q + V,q = 0", Flaw::none, "", "", lagranges_equations},
      {"5.8", "(5.8)", "the six equations of motion", Flaw::none, "", "", equations_of_motion},
      {"5.9", "(5.9)", "M and h", Flaw::none, "", "", mass_and_forces},
      {"5.10", "(5.10)", "r_C = r_S + r_SM + r_MC, C closest to the projection point M′", Flaw::none, "",
       "M′, the projection of M on the floor, is not defined in the text.", place_of_contact},
      {"5.11", "(5.11)", "r_S, r_SM = A¹⁴(0, 0, a_1), r_MC = (0, 0, −r_1)", Flaw::none, "", "", members},
      {"5.12", "(5.12)", "r_C in Euler angles", Flaw::none, "", "", place_in_angles},
      {"5.13", "(5.13)", "g_N1 = z_S + a_1 cos θ − r_1", Flaw::none, "", "", [] { return gap(0); }},
      {"5.14", "(5.14)", "g_N2 = z_S + a_2 cos θ − r_2", Flaw::none, "", "", [] { return gap(1); }},
      {"5.15", "(5.15)", "γ_Ni = ġ_Ni = ż_S − a_iθ̇ sin θ", Flaw::none, "", "", gap_rate},
      {"5.16", "(5.16)", "W_Ni = (0, 0, 1, −a_i sin θ, 0, 0)ᵀ, w̃_Ni = 0", Flaw::none, "", "",
       normal_direction},
      {"5.17", "(5.17)", "v_C = v_S + ω × r_SC", Flaw::none, "", "", velocity_of_c},
      {"5.17.point", "(5.17), of which point", "The velocity of point C, located by (5.10)", Flaw::imprecise,
       "of the point of the body that is at C",
       "C itself wanders over the sphere; friction sees the body's point.", velocity_of_which_point},
      {"5.18", "(5.18)", "v_C in Euler angles; its third component is zero when γ_N1 = 0", Flaw::none, "", "",
       velocity_in_angles},
      {"5.19", "(5.19)", "γ_T1", Flaw::none, "", "", tangential_velocity},
      {"5.20", "(5.20)", "W_Ti, w̃_Ti = 0", Flaw::none, "", "", tangential_directions},
      {"5.21", "(5.21)", "γ_τi = ω_3R_i, W_τi = (0, 0, 0, 0, 1, cos θ)ᵀR_i, w̃_τi = 0", Flaw::none, "", "",
       spin_direction},
  };
}

}  // namespace verify::ledger
