#include <map>

#include "methods.hpp"
#include "rivals/siconos.hpp"

namespace bench {
namespace {

using rivals::SiconosMethod;
using rivals::SiconosProblem;
using rivals::SiconosSolver;

/// Enough for all that converge, and an end to those that do not.
constexpr int most_iterations = 1000;

class SiconosRunner : public Runner {
 public:
  SiconosRunner(const SiconosMethod& method, double tolerance, const std::vector<Case>& cases)
      : cases_(cases) {
    for (const Case& c : cases) {
      std::vector<double> mu;
      for (const contensou::ContactGroup& group : c.problem.groups) {
        mu.insert(mu.end(), group.mu.begin(), group.mu.end());
      }
      problems_.emplace_back(c.problem.delassus, c.problem.free_velocity, mu, method.storage);
      solvers_.try_emplace(c.problem.rows(), method.name, tolerance, most_iterations);
      impulses_.push_back(c.guess);
      velocities_.push_back(c.problem.delassus * c.guess + c.problem.free_velocity);
    }
    start_ = velocities_;
  }

  void pass() override {
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      impulses_[i] = cases_[i].guess;
      velocities_[i] = start_[i];
      solvers_.at(impulses_[i].size()).solve(problems_[i], impulses_[i], velocities_[i]);
    }
  }

 private:
  const std::vector<Case>& cases_;
  std::vector<SiconosProblem> problems_;
  std::vector<Eigen::VectorXd> velocities_, start_;
  std::map<Eigen::Index, SiconosSolver> solvers_;  ///< by rows
};

}  // namespace

std::vector<SolverUnderTest> siconos_solvers() {
  std::vector<SolverUnderTest> all;
  for (const SiconosMethod& method : rivals::siconos_methods()) {
    for (const double tolerance : {1e-4, 1e-8, 1e-12, 1e-14}) {
      all.push_back({"siconos", method.name, tolerance, true, method.one_contact,
                     [method, tolerance](const std::vector<Case>& cases) -> std::unique_ptr<Runner> {
                       return std::make_unique<SiconosRunner>(method, tolerance, cases);
                     }});
    }
  }
  return all;
}

}  // namespace bench
