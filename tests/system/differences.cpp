#include "differences.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace contensou;

namespace system_test {
namespace {

constexpr double rounding = 1e-13;
/// What columns hold that no contact writes.
constexpr double untouched = 12345;

ContactRows rows_at(const MechanicalSystem& system, std::size_t contact, const State& s) {
  ContactRows rows(system.velocities());
  rows.directions.setConstant(untouched);
  rows.response.setConstant(untouched);
  rows.velocity.setConstant(untouched);
  rows.drift.setConstant(untouched);
  system.contact_rows(contact, s.t, s.q, s.u, rows);
  return rows;
}

double energy(const MechanicalSystem& system, const State& s) {
  return system.kinetic_energy(s.q, s.u) + system.potential_energy(s.q);
}

void check_contact(const MechanicalSystem& system, std::size_t contact, const State& s,
                   const Eigen::MatrixXd& mass) {
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(s.u.size());
  const ContactRows all = rows_at(system, contact, s);
  const int count = rows(system.contacts()[contact].friction);
  const auto w = all.directions.leftCols(count);
  CHECK((mass * all.response.leftCols(count) - w).norm() <= rounding * w.norm());
  const Eigen::VectorXd velocity = all.velocity;
  const Eigen::VectorXd drift = all.drift;
  const Eigen::VectorXd given = rows_at(system, contact, {s.t, s.q, still}).velocity.head(count);
  CHECK((system.driven() || given.norm() == 0));
  CHECK((w.transpose() * s.u + given - velocity.head(count)).norm() <=
        rounding * ((1 + s.u.norm()) * w.norm() + given.norm()));
  for (int k = 0; k < count; ++k)
    CHECK(std::abs(all.given(k, s.u) - given[k]) <= rounding * (1 + given.norm()));

  const double approach =
      rate([&](double t) { return system.gap(contact, s.t + t, moved(system, s, still, t).q); });
  CHECK(std::abs(approach - velocity[0]) <= difference_bound);
  const Eigen::VectorXd change = rate([&](double t) -> Eigen::VectorXd {
    return rows_at(system, contact, moved(system, s, still, t)).velocity;
  });
  CHECK((change - drift).head(count).norm() <= difference_bound * (1 + drift.head(count).norm()));

  CHECK((all.directions.rightCols(4 - count).array() == untouched).all());
  CHECK((all.response.rightCols(4 - count).array() == untouched).all());
  CHECK((velocity.tail(4 - count).array() == untouched).all());
  CHECK((drift.tail(4 - count).array() == untouched).all());
}

void check_power(const MechanicalSystem& system, const State& s, Eigen::VectorXd acceleration) {
  double power = 0;
  for (std::size_t i = 0; i < system.contacts().size(); ++i) {
    const ContactRows all = rows_at(system, i, s);
    const int count = rows(system.contacts()[i].friction);
    const Eigen::VectorXd force = generic(count, 0.3 + static_cast<double>(i));
    acceleration += all.response.leftCols(count) * force;
    const Eigen::VectorXd push = all.directions.leftCols(count) * force;
    power += push.dot(s.u);
  }
  Eigen::VectorXd works(static_cast<Eigen::Index>(system.works().size()));
  system.powers(s.t, s.q, s.u, works);
  power += works.sum();
  const double gain = rate([&](double t) { return energy(system, moved(system, s, acceleration, t)); });
  CHECK(std::abs(gain - power) <= difference_bound * (1 + std::abs(energy(system, s))));
}

}  // namespace

Eigen::VectorXd generic(Eigen::Index n, double phase) {
  Eigen::VectorXd x(n);
  for (Eigen::Index i = 0; i < n; ++i) x[i] = std::sin(phase + 2.4 * static_cast<double>(i) + 0.7);
  return x;
}

State moved(const MechanicalSystem& system, const State& state, const Eigen::VectorXd& acceleration,
            double t) {
  const auto slope = [&](const Eigen::VectorXd& q, double time) {
    Eigen::VectorXd rates(q.size());
    system.coordinate_rates(q, state.u + time * acceleration, rates);
    return rates;
  };
  const Eigen::VectorXd k1 = slope(state.q, 0);
  const Eigen::VectorXd k2 = slope(state.q + t / 2 * k1, t / 2);
  const Eigen::VectorXd k3 = slope(state.q + t / 2 * k2, t / 2);
  const Eigen::VectorXd k4 = slope(state.q + t * k3, t);
  return {state.t + t, state.q + t / 6 * (k1 + 2 * k2 + 2 * k3 + k4), state.u + t * acceleration};
}

void check_terms(const MechanicalSystem& system, const State& s) {
  const Eigen::Index f = system.velocities();
  REQUIRE(s.q.size() == system.coordinates());
  REQUIRE(s.u.size() == f);
  Eigen::MatrixXd mass(f, f);
  system.mass_matrix(s.q, mass);
  CHECK((mass - mass.transpose()).norm() == 0);
  const double kinetic = s.u.dot(mass * s.u) / 2;
  CHECK(std::abs(system.kinetic_energy(s.q, s.u) - kinetic) <= rounding * (1 + kinetic));

  Eigen::VectorXd force(f);
  Eigen::VectorXd acceleration(f);
  system.force(s.t, s.q, s.u, force);
  system.free_acceleration(s.t, s.q, s.u, acceleration);
  CHECK((mass * acceleration - force).norm() <= rounding * (1 + mass.norm() * acceleration.norm()));

  for (std::size_t i = 0; i < system.contacts().size(); ++i) check_contact(system, i, s, mass);
  check_power(system, s, acceleration);

  Eigen::VectorXd q = s.q;
  system.restore(q);
  CHECK((q - s.q).norm() <= 1e-15);
  Eigen::VectorXd scales(q.size());
  system.coordinate_scales(scales);
  CHECK(scales.minCoeff() > 0);
  CHECK(system.length_scale() > 0);
}

}  // namespace system_test
