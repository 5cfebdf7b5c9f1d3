#include "contensou/contact/one_contact.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "contensou/law/force.hpp"

using namespace contensou;
using Eigen::Vector3d;
using Eigen::Vector4d;

namespace {

const FrictionDisk disk;
const FrictionBall<SmoothPlate<UniformLaw>> uniform{SmoothPlate(UniformLaw{})};
const FrictionBall<SmoothPlate<HertzLaw>> hertz{SmoothPlate(HertzLaw{})};

double uniform_number(std::mt19937_64& g) { return static_cast<double>(g() >> 11) * 0x1p-52 - 1; }

template <int n>
Eigen::Matrix<double, n, 1> random_vector(std::mt19937_64& g) {
  return Eigen::Matrix<double, n, 1>::NullaryExpr([&] { return uniform_number(g); });
}

/// Positive definite: eigenvalues 0.3 to about n.
template <int n>
Eigen::Matrix<double, n, n> random_compliance(std::mt19937_64& g) {
  const Eigen::Matrix<double, n, n> j =
      Eigen::Matrix<double, n, n>::NullaryExpr([&] { return uniform_number(g); });
  return j * j.transpose() + 0.3 * Eigen::Matrix<double, n, n>::Identity();
}

/// Friction by the law, LG03 (2.11), which shares no code with the search for slip.
template <class Law>
Vector3d law_friction(const FrictionBall<SmoothPlate<Law>>& ball, double mu, double normal,
                      const Vector3d& gamma) {
  return std::get<FrictionForce>(friction_force(ball.plate().law(), {mu, normal}, gamma));
}
Eigen::Vector2d law_friction(const FrictionDisk&, double mu, double normal, const Eigen::Vector2d& gamma) {
  return -mu * normal * gamma.normalized();
}

/// Chooses Λ_N and γ_F, lets the law say Λ_F and makes b fit: is Λ found again? W is positive definite and μ
/// so small that Λ is unique: μ‖W_NF‖ stays below the smallest eigenvalue of W.
template <class Domain>
void finds_slip_again(const Domain& domain, double spin) {
  constexpr int n = 1 + Domain::dimension;
  std::mt19937_64 g(7);
  for (int k = 0; k < 2000; ++k) {
    const auto w = random_compliance<n>(g);
    const double mu = 0.3 / w.norm() * std::abs(uniform_number(g));
    const double normal = 0.1 + std::abs(uniform_number(g));
    Eigen::Matrix<double, n - 1, 1> gamma_f = random_vector<n - 1>(g);
    if constexpr (n == 4) gamma_f[2] *= spin;
    ContactVector<Domain> lambda;
    lambda << normal, law_friction(domain, mu, normal, gamma_f);
    ContactVector<Domain> gamma;
    gamma << 0, gamma_f;
    const ContactVector<Domain> b = gamma - w * lambda;
    if (b[0] >= 0) continue;
    const auto found =
        solve_one_contact(domain, mu, w, b, ContactVector<Domain>(ContactVector<Domain>::Zero()));
    REQUIRE(found.state == ContactState::slip);
    // The condition of the problem, about 10 for its eigenvalues, times the tolerance of the search.
    REQUIRE((found.impulse - lambda).norm() < 1e-12);
    REQUIRE(found.residual < 1e-13);
  }
}

template <class Domain>
void finds_stick_again(const Domain& domain) {
  constexpr int n = 1 + Domain::dimension;
  std::mt19937_64 g(11);
  for (int k = 0; k < 1000; ++k) {
    const auto w = random_compliance<n>(g);
    const double mu = std::abs(uniform_number(g));
    ContactVector<Domain> lambda = random_vector<n>(g);
    lambda[0] = 0.1 + std::abs(lambda[0]);
    auto friction = lambda.template tail<n - 1>();
    friction *= 0.99 * mu * lambda[0] / (domain.gauge(friction) + 1e-300);  // just inside
    const ContactVector<Domain> b = -w * lambda;
    if (b[0] >= 0) continue;
    const auto found =
        solve_one_contact(domain, mu, w, b, ContactVector<Domain>(ContactVector<Domain>::Zero()));
    REQUIRE(found.state == ContactState::stick);
    REQUIRE((found.impulse - lambda).norm() < 1e-12);
  }
}

}  // namespace

TEST_CASE("One contact: impulses made from the law are found again", "[contact]") {
  finds_slip_again(disk, 1);
  for (const double spin : {1e-12, 1e-3, 1.0, 1e3}) {
    finds_slip_again(uniform, spin);
    finds_slip_again(hertz, spin);
  }
  finds_stick_again(disk);
  finds_stick_again(uniform);
  finds_stick_again(hertz);
}

TEST_CASE("One contact: it opens where nothing presses", "[contact]") {
  const auto found =
      solve_one_contact(disk, 1, Eigen::Matrix3d::Identity(), Vector3d(0, 1, 0), Vector3d(1, 1, 1));
  CHECK(found.state == ContactState::open);
  CHECK(found.impulse.isZero(0));
}

TEST_CASE("One contact without friction", "[contact]") {
  using One = Eigen::Matrix<double, 1, 1>;
  CHECK(solve_one_contact(NoFriction{}, 0, One(0.5), One(-3), One(0)).impulse[0] == 6);
  CHECK(solve_one_contact(NoFriction{}, 0, One(0.5), One(3), One(1)).impulse[0] == 0);
  // Nothing gives way, or the wrong way (Painlevé): no solution.
  CHECK(solve_one_contact(NoFriction{}, 0, One(0), One(-3), One(0)).state == ContactState::unsolved);
  CHECK(solve_one_contact(NoFriction{}, 0, One(-1), One(-3), One(0)).state == ContactState::unsolved);
}

TEST_CASE("One contact: a disc that spins on the spot feels 2/3 or 3π/16 of μΛ_N", "[contact]") {
  // Unit mass, I = R²: γ_τ falls by Λ_τ.
  const Eigen::Matrix4d w = Eigen::Matrix4d::Identity();
  const Vector4d b(-2, 0, 0, -5);
  const auto u = solve_one_contact(uniform, 0.4, w, b, Vector4d(Vector4d::Zero()));
  CHECK((u.impulse - Vector4d(2, 0, 0, 2.0 / 3 * 0.8)).norm() < 1e-15);
  const auto h = solve_one_contact(hertz, 0.4, w, b, Vector4d(Vector4d::Zero()));
  CHECK((h.impulse - Vector4d(2, 0, 0, 3 * M_PI / 16 * 0.8)).norm() < 1e-15);
}

TEST_CASE("One contact: without a radius Contensou's friction is Coulomb's", "[contact]") {
  // W_ττ = R²/I, b_τ = R ω.
  const Vector3d coulomb =
      solve_one_contact(disk, 0.3, Eigen::Matrix3d::Identity(), Vector3d(-1, 3, 4), Vector3d(0, 0, 0))
          .impulse;
  for (const double radius : {0.0, 1e-150, 1e-9}) {
    Eigen::Matrix4d w = Eigen::Matrix4d::Identity();
    w(3, 3) = radius * radius;
    const auto found =
        solve_one_contact(uniform, 0.3, w, Vector4d(-1, 3, 4, radius), Vector4d(Vector4d::Zero()));
    CHECK(found.state == ContactState::slip);
    // ξ = 1 − O(u⁻²), Λ_τ = O(1/u), u = 5/radius.
    CHECK((found.impulse.head<3>() - coulomb).norm() < 1e-15);
    CHECK(std::abs(found.impulse[3]) <= 0.3 * radius);
  }
}

TEST_CASE("One contact: units do not matter", "[contact]") {
  std::mt19937_64 g(3);
  for (int k = 0; k < 50; ++k) {
    const Eigen::Matrix4d w = random_compliance<4>(g);
    Vector4d b = random_vector<4>(g);
    b[0] = -std::abs(b[0]);
    const Vector4d none = Vector4d::Zero();
    const Vector4d lambda = solve_one_contact(hertz, 0.2, w, b, none).impulse;
    for (const double mass : {1e-150, 1e150}) {
      for (const double speed : {1e-100, 1e100}) {
        const Eigen::Matrix4d w_scaled = w / mass;
        const Vector4d b_scaled = b * speed;
        const Vector4d scaled = solve_one_contact(hertz, 0.2, w_scaled, b_scaled, none).impulse;
        REQUIRE((scaled / mass / speed - lambda).norm() < 1e-11 * lambda.norm());
      }
    }
  }
}

TEST_CASE("One contact: no friction, a lot of it, and hardly any normal impulse", "[contact]") {
  const Eigen::Matrix4d w =
      (Eigen::Matrix4d() << 2, 0.5, 0, 0.1, 0.5, 3, 0.2, 0, 0, 0.2, 3, 0, 0.1, 0, 0, 1).finished();
  const Vector4d none = Vector4d::Zero();
  const auto smooth = solve_one_contact(hertz, 0, w, Vector4d(-1, 1, 1, 1), none);
  CHECK((smooth.impulse - Vector4d(0.5, 0, 0, 0)).norm() < 1e-15);
  for (const double mu : {1e-300, 1e-100, 1e-10, 1.0, 10.0, 1e3}) {
    for (const double press : {1e-300, 1e-200, 1e-20, 1e-9, 1.0, 1e9}) {
      const Vector4d b(-press, 1, -2, 3);
      const auto found = solve_one_contact(hertz, mu, w, b, none);
      CAPTURE(mu, press);
      CHECK(found.impulse[0] > 0);
      CHECK(found.residual < 1e-13);
    }
  }
}

TEST_CASE("One contact: friction takes energy, at the rate Φ where it slips", "[contact]") {
  std::mt19937_64 g(5);
  for (int k = 0; k < 2000; ++k) {
    const Eigen::Matrix4d w = random_compliance<4>(g);
    Vector4d b = random_vector<4>(g);
    b[0] = -std::abs(b[0]);
    const double mu = 2 * std::abs(uniform_number(g));
    const auto found = solve_one_contact(uniform, mu, w, b, Vector4d(Vector4d::Zero()));
    REQUIRE(found.state != ContactState::unsolved);
    const Vector4d gamma = w * found.impulse + b;
    const double power = found.impulse.tail<3>().dot(gamma.tail<3>());
    const double rounding = 1e-12 * found.impulse.norm();
    REQUIRE(power <= rounding);
    const Vector3d gamma_f = gamma.tail<3>();
    if (found.state == ContactState::slip) {
      REQUIRE(std::abs(power + potential(UniformLaw{}, {mu, found.impulse[0]}, gamma_f)) <= rounding);
    }
  }
}

TEST_CASE("One contact: singular compliance, in the range of which b lies", "[contact]") {
  std::mt19937_64 g(13);
  int bad = 0;
  for (int k = 0; k < 2000; ++k) {
    const int rank = 1 + k % 3;
    const Eigen::Matrix4d all = Eigen::Matrix4d::NullaryExpr([&] { return uniform_number(g); });
    const Eigen::MatrixXd j = all.leftCols(rank);
    const Eigen::Matrix4d w = j * j.transpose();
    Vector4d b = j * random_vector<4>(g).head(rank);
    if (b[0] > 0) b = -b;
    if (!(solve_one_contact(hertz, 0.5, w, b, Vector4d(Vector4d::Zero())).residual < 1e-12)) ++bad;
  }
  CHECK(bad == 0);
}

TEST_CASE("One contact: finite numbers whose products overflow are no reason to throw", "[contact]") {
  Eigen::Matrix4d w = Eigen::Matrix4d::Identity();
  w(0, 0) = 1e-300;
  w(0, 1) = w(1, 0) = 1e20;
  const Vector4d b(-1, 0, 0, 0);
  const auto check = [&](const auto& domain, const auto& matrix, const auto& velocity) {
    const std::decay_t<decltype(velocity)> zero = velocity * 0;
    const auto found = solve_one_contact(domain, 0.3, matrix, velocity, zero);
    CHECK(found.state == ContactState::unsolved);
    CHECK(found.impulse.allFinite());
  };
  check(disk, Eigen::Matrix3d(w.topLeftCorner<3, 3>()), Vector3d(b.head<3>()));
  check(uniform, w, b);
  check(hertz, w, b);
}
