#include "coulomb_problems.hpp"

#include <cmath>
#include <random>
#include <utility>

#include "common/natural_units.hpp"
#include "contact/random_problems.hpp"

namespace verify::siconos {
namespace {

const contensou::AnyFriction& disk() {
  static const contensou::AnyFriction friction = contensou::FrictionDisk{};
  return friction;
}

CoulombProblem coulomb(const Eigen::MatrixXd& w, const Eigen::VectorXd& b, std::vector<double> mu,
                       bool easy) {
  return {bench::in_natural_units({{{&disk(), mu}}, w, b}), std::move(mu), easy};
}

}  // namespace

std::vector<CoulombProblem> hard_problems(int count) {
  std::vector<CoulombProblem> problems;
  for (std::uint64_t seed = 0; std::ssize(problems) < count; ++seed) {
    const random_contact::RandomProblem random = random_contact::random_problem(seed);
    if (random.rows != random_contact::Rows::coulomb || random.problem.free_velocity.isZero(0)) continue;
    std::vector<double> mu;
    for (const contensou::ContactGroup& group : random.problem.groups) {
      mu.insert(mu.end(), group.mu.begin(), group.mu.end());
    }
    problems.push_back(coulomb(random.problem.delassus, random.problem.free_velocity, mu, false));
  }
  return problems;
}

std::vector<CoulombProblem> easy_problems(int count, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  std::vector<CoulombProblem> problems;
  for (int k = 0; k < count; ++k) {
    const Eigen::Index contacts = 1 + k % 8;
    Eigen::MatrixXd a(3 * contacts, 3 * contacts);
    for (double& entry : a.reshaped()) entry = 2 * uniform() - 1;
    const Eigen::MatrixXd w = Eigen::MatrixXd::Identity(a.rows(), a.rows()) +
                              a * a.transpose() / (2 * static_cast<double>(contacts));
    Eigen::VectorXd b(a.rows());
    for (double& entry : b) entry = 2 * uniform() - 1;
    b[0] = -std::abs(b[0]);
    std::vector<double> mu(static_cast<std::size_t>(contacts));
    for (double& m : mu) m = 0.1 * uniform();
    problems.push_back(coulomb(w, b, std::move(mu), true));
  }
  return problems;
}

}  // namespace verify::siconos
