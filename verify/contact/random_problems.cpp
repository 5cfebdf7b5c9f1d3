#include "contact/random_problems.hpp"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "contensou/law/power.hpp"

namespace random_contact {
namespace {

using contensou::AnyFriction;

/// The kinds of friction; the first is frictionless, the second Coulomb's, the others have four rows.
const std::vector<AnyFriction>& frictions() {
  using namespace contensou;
  static const std::vector<AnyFriction> all{
      NoFriction{},
      FrictionDisk{},
      FrictionBall(SmoothPlate(UniformLaw{})),
      FrictionBall(SmoothPlate(HertzLaw{})),
      FrictionBall(SmoothPlate(static_cast<CompiledLaw>(PowerLaw(2)))),
      FrictionBall(SmoothPlate(EllipsoidLaw({.xi = 1, .eta = 2.0 / 3}))),
  };
  return all;
}

/// The same numbers on every standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  double logarithmic(double low, double high) { return low * std::pow(high / low, uniform()); }
  int below(int count) { return std::min(static_cast<int>(uniform() * count), count - 1); }
  bool chance(double probability) { return uniform() < probability; }
  Eigen::Vector3d direction() {
    const double z = uniform(-1, 1);
    const double angle = uniform(0, 2 * std::numbers::pi);
    const double radius = std::sqrt(1 - z * z);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
  }

 private:
  std::mt19937_64 engine_;
};

struct Body {
  double length;
  Eigen::Matrix<double, 6, 1> mobility_root;  ///< 1/√ of masses and moments of inertia; 0 where constrained
};

struct Contact {
  int kind;  ///< of friction
  double mu;
  double radius;
  int lower;  ///< body, −1 for the ground
  int upper;
  Eigen::Vector3d lower_arm, upper_arm, normal;
};

Body random_body(Random& random, double mass_ratio, bool constrained) {
  Body body{random.logarithmic(0.1, 10), {}};
  const double mass = random.logarithmic(1, mass_ratio);
  body.mobility_root.head<3>().setConstant(1 / std::sqrt(mass));
  for (int i = 3; i < 6; ++i) {
    body.mobility_root[i] = 1 / (body.length * std::sqrt(mass * random.uniform(0.1, 0.5)));
  }
  if (constrained) {
    for (int i = 0; i < 6; ++i) {
      if (random.chance(0.3)) body.mobility_root[i] = 0;
    }
  }
  return body;
}

int random_kind(Random& random, Rows rows) {
  const int last = static_cast<int>(frictions().size()) - 1;
  switch (rows) {
    case Rows::frictionless:
      return 0;
    case Rows::coulomb:
      return 1;
    case Rows::contensou:
      return 2 + random.below(last - 1);
    case Rows::mixed:
      break;
  }
  return random.below(last + 1);
}

double largest_mu(Roughness roughness) {
  switch (roughness) {
    case Roughness::zero:
      return 0;
    case Roughness::small:
      return 0.1;
    case Roughness::medium:
      return 1;
    case Roughness::large:
      break;
  }
  return 10;
}

Contact random_contact(Random& random, const RandomProblem& wanted, const std::vector<Body>& bodies,
                       int upper) {
  Contact c{};
  c.kind = random_kind(random, wanted.rows);
  const double most = largest_mu(wanted.roughness);
  c.mu = most == 0 || random.chance(0.05) ? 0 : random.logarithmic(most / 100, most);
  c.upper = upper;
  c.lower = random.below(upper + 1) - 1;
  c.normal = Eigen::Vector3d::UnitZ();
  const Body& body = bodies[static_cast<std::size_t>(upper)];
  c.upper_arm = body.length * random.uniform(0.3, 1) * random.direction();
  if (wanted.structure != Structure::support) {
    c.normal = (random.direction() - 0.5 * c.upper_arm / body.length).normalized();
  }
  if (c.lower >= 0) {
    c.lower_arm =
        bodies[static_cast<std::size_t>(c.lower)].length * random.uniform(0.3, 1) * random.direction();
  }
  c.radius = random.chance(0.05) ? 0 : body.length * random.logarithmic(1e-9, 1e2);
  return c;
}

/// √M⁻¹ H: a column for each row of the contact problem.
Eigen::MatrixXd mobile_directions(const std::vector<Body>& bodies, const std::vector<Contact>& contacts) {
  std::vector<Eigen::VectorXd> columns;
  for (const Contact& c : contacts) {
    const auto add = [&](const Eigen::Vector3d& force, double torque) {
      Eigen::VectorXd column = Eigen::VectorXd::Zero(6 * static_cast<Eigen::Index>(bodies.size()));
      const auto act = [&](int body, const Eigen::Vector3d& arm, double sign) {
        if (body < 0) return;
        Eigen::Matrix<double, 6, 1> wrench;
        wrench << force, arm.cross(force) + torque * c.normal;
        column.segment<6>(6 * body) =
            sign * wrench.cwiseProduct(bodies[static_cast<std::size_t>(body)].mobility_root);
      };
      act(c.upper, c.upper_arm, 1);
      act(c.lower, c.lower_arm, -1);
      columns.push_back(column);
    };
    const int rows = contensou::rows(frictions()[static_cast<std::size_t>(c.kind)]);
    const Eigen::Vector3d t1 = c.normal.unitOrthogonal();
    add(c.normal, 0);
    if (rows >= 3) add(t1, 0);
    if (rows >= 3) add(c.normal.cross(t1), 0);
    if (rows >= 4) add(Eigen::Vector3d::Zero(), c.radius);
  }
  Eigen::MatrixXd result(6 * static_cast<Eigen::Index>(bodies.size()),
                         static_cast<Eigen::Index>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j) result.col(static_cast<Eigen::Index>(j)) = columns[j];
  return result;
}

/// The velocities the contacts should have, as far as the bodies can move so.
Eigen::VectorXd wanted_velocity(Random& random, Motion motion, const std::vector<Contact>& contacts) {
  std::vector<double> wanted;
  const double slow = random.logarithmic(1e-6, 1e-2);
  for (const Contact& c : contacts) {
    const int rows = contensou::rows(frictions()[static_cast<std::size_t>(c.kind)]);
    double normal = -random.uniform(0.1, 1);
    if (motion == Motion::sliding) normal *= slow;
    if (motion == Motion::opening && random.chance(0.7)) normal = -normal;
    if (motion == Motion::grazing && random.chance(0.7)) normal = 0;
    wanted.push_back(normal);
    const double speed = motion == Motion::sliding ? 1 : random.logarithmic(0.01, 10);
    const Eigen::Vector3d friction = speed * random.direction();
    if (rows >= 3) wanted.insert(wanted.end(), {friction.x(), friction.y()});
    if (rows >= 4) wanted.push_back(friction.z() * std::min(1.0, c.radius * random.logarithmic(0.1, 1e3)));
  }
  return Eigen::Map<Eigen::VectorXd>(wanted.data(), static_cast<Eigen::Index>(wanted.size()));
}

/// Impulses a little inside or outside the border of friction: without them the contacts just stick or just
/// slip.
Eigen::VectorXd sticking_impulse(Random& random, const std::vector<Contact>& contacts) {
  std::vector<double> impulse;
  for (const Contact& c : contacts) {
    const AnyFriction& friction = frictions()[static_cast<std::size_t>(c.kind)];
    const double normal = random.logarithmic(0.01, 1);
    impulse.push_back(normal);
    const double margin = (random.chance(0.5) ? 1 : -1) * random.logarithmic(1e-12, 1e-1);
    const Eigen::Vector3d direction = random.direction();
    std::visit(
        [&]<class Domain>(const Domain& domain) {
          if constexpr (Domain::dimension > 0) {
            const Eigen::Matrix<double, Domain::dimension, 1> f =
                direction.template head<Domain::dimension>();
            const double scale = (1 + margin) * c.mu * normal / domain.gauge(f);
            for (int i = 0; i < Domain::dimension; ++i) impulse.push_back(scale * f[i]);
          }
        },
        friction);
  }
  return Eigen::Map<Eigen::VectorXd>(impulse.data(), static_cast<Eigen::Index>(impulse.size()));
}

Eigen::VectorXd free_velocity(Random& random, const RandomProblem& wanted, const std::vector<Body>& bodies,
                              const std::vector<Contact>& contacts, const Eigen::MatrixXd& directions) {
  Eigen::VectorXd u(directions.rows());  // √M times the bodies' velocities
  if (wanted.motion == Motion::sticking) {
    u = -directions * sticking_impulse(random, contacts);
  } else if (wanted.motion == Motion::resting) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const auto at = 6 * static_cast<Eigen::Index>(i);
      const double drift = random.logarithmic(1e-6, 1);
      u.segment<3>(at) = -Eigen::Vector3d::UnitZ() + drift * random.direction();
      u.segment<3>(at + 3) = drift / bodies[i].length * random.direction();
      for (int k = 0; k < 6; ++k) {
        const double root = bodies[i].mobility_root[k];
        u[at + k] = root > 0 ? u[at + k] / root : 0;
      }
    }
  } else {
    const Eigen::VectorXd target = wanted_velocity(random, wanted.motion, contacts);
    u = directions.transpose().completeOrthogonalDecomposition().solve(target);
  }
  Eigen::VectorXd b = directions.transpose() * u;
  const double largest = b.cwiseAbs().maxCoeff();
  const bool gaps = random.chance(0.5);
  const double restitution = random.chance(0.5) ? random.uniform() : 0;
  Eigen::Index row = 0;
  for (const Contact& c : contacts) {
    if (wanted.structure == Structure::support) {
      if (b[row] < 0) b[row] *= 1 + restitution;
    } else if (gaps && random.chance(0.5)) {
      b[row] += largest * random.logarithmic(1e-6, 1);
    }
    row += contensou::rows(frictions()[static_cast<std::size_t>(c.kind)]);
  }
  return b;
}

std::vector<Contact> random_contacts(Random& random, const RandomProblem& wanted,
                                     const std::vector<Body>& bodies, int count) {
  std::vector<Contact> contacts;
  const int bodies_count = static_cast<int>(bodies.size());
  const int different = wanted.structure == Structure::redundant ? (count + 1) / 2 : count;
  for (int i = 0; i < different; ++i) {
    contacts.push_back(
        random_contact(random, wanted, bodies, i < bodies_count ? i : random.below(bodies_count)));
  }
  for (int i = different; i < count; ++i) {
    contacts.push_back(contacts[static_cast<std::size_t>(i - different)]);
  }
  // Groups share a kind of friction.
  std::stable_sort(contacts.begin(), contacts.end(),
                   [](const Contact& a, const Contact& b) { return a.kind < b.kind; });
  return contacts;
}

int random_body_count(Random& random, Structure structure, int contacts) {
  switch (structure) {
    case Structure::tree:
      return contacts;
    case Structure::loops:
      return 1 + random.below(std::max(1, contacts / 2));
    case Structure::support:
    case Structure::redundant:
    case Structure::constrained:
      break;
  }
  return 1 + random.below(contacts);
}

}  // namespace

RandomProblem random_problem(std::uint64_t seed) {
  Random random(seed * 0x9E3779B97F4A7C15ULL + 1);
  RandomProblem result{};
  result.structure = static_cast<Structure>(random.below(static_cast<int>(structures.size())));
  result.motion = static_cast<Motion>(random.below(static_cast<int>(motions.size())));
  const double kind = random.uniform();
  result.rows = kind < 0.1    ? Rows::frictionless
                : kind < 0.35 ? Rows::coulomb
                : kind < 0.7  ? Rows::contensou
                              : Rows::mixed;
  result.roughness = random.chance(0.1) ? Roughness::zero : static_cast<Roughness>(1 + random.below(3));

  const int count = 1 + random.below(8);
  const double mass_ratio = std::pow(10, 3 * random.below(3));
  std::vector<Body> bodies;
  for (int i = random_body_count(random, result.structure, count); i > 0; --i) {
    bodies.push_back(random_body(random, mass_ratio, result.structure == Structure::constrained));
  }
  const std::vector<Contact> contacts = random_contacts(random, result, bodies, count);
  const Eigen::MatrixXd directions = mobile_directions(bodies, contacts);
  contensou::ContactProblem& problem = result.problem;
  const Eigen::Index rows = directions.cols();
  problem.delassus = Eigen::MatrixXd::Zero(rows, rows);
  problem.delassus.selfadjointView<Eigen::Lower>().rankUpdate(directions.transpose());
  problem.delassus.triangularView<Eigen::StrictlyUpper>() = problem.delassus.transpose();
  problem.free_velocity = free_velocity(random, result, bodies, contacts, directions);
  int last = -1;
  for (const Contact& c : contacts) {
    if (c.kind != last) problem.groups.push_back({&frictions()[static_cast<std::size_t>(c.kind)], {}});
    last = c.kind;
    problem.groups.back().mu.push_back(c.mu);
  }
  return result;
}

}  // namespace random_contact
