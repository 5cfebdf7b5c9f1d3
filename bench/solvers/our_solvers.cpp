#include <utility>
#include <variant>

#include "contensou/contact/contact_solver.hpp"
#include "contensou/contact/one_contact.hpp"
#include "methods.hpp"

namespace bench {
namespace {

using contensou::ContactSolver;
using contensou::SolverMethod;

class SolverRunner : public Runner {
 public:
  SolverRunner(SolverMethod method, double tolerance, const std::vector<Case>& cases)
      : cases_(cases), solver_({.method = method, .tolerance = tolerance}) {
    for (const Case& c : cases) impulses_.push_back(c.guess);
  }

  void pass() override {
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      impulses_[i] = cases_[i].guess;
      status_ = solver_.solve(cases_[i].problem, impulses_[i]).status;
    }
  }

 private:
  const std::vector<Case>& cases_;
  ContactSolver solver_;
  contensou::SolverStatus status_;  // the residuals are judged outside
};

template <class Domain>
class DirectRunner : public Runner {
 public:
  DirectRunner(const Domain& domain, const std::vector<Case>& cases) : domain_(domain) {
    for (const Case& c : cases) {
      problems_.push_back({c.problem.groups[0].mu[0], c.problem.delassus, c.problem.free_velocity, c.guess});
      impulses_.push_back(c.guess);
    }
  }

  void pass() override {
    for (std::size_t i = 0; i < problems_.size(); ++i) {
      const Problem& p = problems_[i];
      impulses_[i] = contensou::solve_one_contact(domain_, p.mu, p.w, p.b, p.guess).impulse;
    }
  }

 private:
  struct Problem {
    double mu;
    contensou::ContactMatrix<Domain> w;
    contensou::ContactVector<Domain> b, guess;
  };
  const Domain& domain_;
  std::vector<Problem> problems_;
};

/// All of one kind of friction, that of the only contact.
std::unique_ptr<Runner> direct(const std::vector<Case>& cases) {
  return std::visit(
      [&]<class Domain>(const Domain& domain) -> std::unique_ptr<Runner> {
        return std::make_unique<DirectRunner<Domain>>(domain, cases);
      },
      *cases[0].problem.groups[0].friction);
}

}  // namespace

std::vector<SolverUnderTest> our_solvers() {
  std::vector<SolverUnderTest> all;
  all.push_back({"contensou", "one_contact", 0, false, true, direct});
  constexpr std::pair<const char*, SolverMethod> methods[] = {
      {"automatic", SolverMethod::automatic},
      {"semismooth_newton", SolverMethod::semismooth_newton},
      {"gauss_seidel", SolverMethod::gauss_seidel},
      {"modified_newton", SolverMethod::modified_newton}};
  for (const auto& [name, method] : methods) {
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
      all.push_back({"contensou", name, tolerance, false, false,
                     [method = method, tolerance](const std::vector<Case>& cases) -> std::unique_ptr<Runner> {
                       return std::make_unique<SolverRunner>(method, tolerance, cases);
                     }});
    }
  }
  return all;
}

}  // namespace bench
