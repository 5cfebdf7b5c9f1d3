#include "contensou/scene/read_balls.hpp"

#include <cmath>
#include <limits>
#include <random>

#include "contensou/scene/read_body.hpp"

namespace contensou {
namespace {

using Eigen::Vector3d;

/// Of lengths: 0.03/2 - 0.01 is less than 0.005 by rounding.
constexpr double rounding = 1e-12;

/// The k-th, counted along x, then y, then z.
Vector3d lattice_point(const BallsScene& balls, int k) {
  const int layer = k / balls.across[0] / balls.across[1];
  const Vector3d steps(k % balls.across[0], k / balls.across[0] % balls.across[1], layer);
  return balls.lower + balls.spacing * steps;
}

void read_lattice(SceneReader& read, const std::string& table, double radius, BallsScene& balls) {
  balls.lower = read.vector(table + "lower");
  const std::string spacing = table + "spacing";
  balls.spacing = read.number(spacing, positive);
  if (balls.spacing < 2 * radius * (1 - rounding))
    read.refuse(spacing, "lets balls overlap", "at least 2 radius");

  constexpr Length two{.least = 2, .most = 2, .expected = "two whole numbers >= 1, along x and y"};
  constexpr Range each{.least = 1, .most = most_balls};
  const std::vector<double> across = read.numbers(table + "across", two, each);
  for (std::size_t i = 0; i < across.size(); ++i) {
    if (across[i] != std::floor(across[i])) read.refuse(table + "across", "is not whole", two.expected);
    balls.across[i] = static_cast<int>(across[i]);
  }
  if (balls.across[0] > most_balls / balls.across[1])
    read.refuse(table + "across", "makes a layer of more than 1e6 balls", "fewer");

  const std::string jitter = table + "jitter";
  const Range room{.least = 0,
                   .most = balls.spacing / 2 * (1 + rounding) - radius,
                   .expected = "a number >= 0, at most spacing/2 - radius"};
  const bool has_room = room.most >= 0;  // else radius or spacing is missing
  balls.jitter = read.optional_number(jitter, has_room ? room : not_negative).value_or(0);
  if (read.has(jitter)) {
    balls.seed = read.whole(table + "seed", 0, std::numeric_limits<int>::max());
  } else {
    read.unused(table + "seed", "balls without jitter");
  }
  if (read.has(spacing) && read.has(table + "lower") && !lattice_point(balls, balls.count - 1).allFinite())
    read.refuse(spacing, "makes a lattice larger than numbers are", "a smaller one");
}

}  // namespace

BallsScene read_balls(SceneReader& read, const std::string& name) {
  const std::string table = "balls." + name + '.';
  BallsScene balls;
  BodyData& ball = balls.ball;
  ball.name = name;
  const bool turns = read.choice(table + "rotation", {"free", "none"}) == "free";
  ball.rotation = turns ? Rotation::free : Rotation::none;
  balls.count = read.whole(table + "count", 1, most_balls);
  const double radius = read.number(table + "radius", positive);
  ball.spheres = {SphereData{.name = name, .centre = Vector3d::Zero(), .radius = radius}};
  ball.mass = read.number(table + "mass", positive);
  read_motion(read, table, ball);
  if (turns) {
    const double inertia = 0.4 * ball.mass * radius * radius;
    ball.inertia.setConstant(inertia);
    if (!std::isnan(inertia) && !(inertia > 0 && std::isfinite(inertia)))
      read.refuse(table + "radius", "makes a moment of inertia beyond numbers", "0.4 mass radius^2 > 0");
    ball.drag.angular = read.optional_number(table + "angular_drag", not_negative).value_or(0);
    ball.spin = read.optional_vector(table + "spin").value_or(Vector3d::Zero());
  } else {
    for (const char* key : {"angular_drag", "spin"}) read.unused(table + key, "rotation none");
  }
  read_lattice(read, table, radius, balls);
  return balls;
}

void append_balls(const BallsScene& balls, std::vector<BodyData>& bodies) {
  std::mt19937_64 random(static_cast<std::uint64_t>(balls.seed));
  const auto from_minus_1_to_1 = [&] {
    constexpr int dropped = 64 - std::numeric_limits<double>::digits;
    return std::ldexp(static_cast<double>(random() >> dropped), 1 - std::numeric_limits<double>::digits) - 1;
  };
  for (int k = 0; k < balls.count; ++k) {
    BodyData ball = balls.ball;
    ball.name += '.' + std::to_string(k + 1);
    ball.spheres.front().name = ball.name;
    ball.position = lattice_point(balls, k);
    if (balls.jitter > 0) {
      for (double& x : ball.position) x += balls.jitter * from_minus_1_to_1();
    }
    bodies.push_back(std::move(ball));
  }
}

}  // namespace contensou
