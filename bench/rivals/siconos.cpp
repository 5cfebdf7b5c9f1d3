#include "siconos.hpp"

#include <FrictionContactProblem.h>
#include <Friction_cst.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <NumericsVerbose.h>
#include <SolverOptions.h>
#include <SparseBlockMatrix.h>
#include <fc3d_compute_error.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <utility>

namespace rivals {
namespace {

using Storage = SiconosProblem::Storage;

struct Identifier {
  const char* name;
  int solver;
  int local;  ///< of Gauss–Seidel: the solver of one contact; 0 otherwise
  Storage storage;
};

// The quartic as local solver frees W where that is dense.
constexpr Identifier identifiers[] = {
    {"nsgs_quartic", SICONOS_FRICTION_3D_NSGS, SICONOS_FRICTION_3D_ONECONTACT_QUARTIC, Storage::blocks},
    {"nsgs_quartic_nu", SICONOS_FRICTION_3D_NSGS, SICONOS_FRICTION_3D_ONECONTACT_QUARTIC_NU, Storage::blocks},
    {"nsgs_nsn", SICONOS_FRICTION_3D_NSGS, SICONOS_FRICTION_3D_ONECONTACT_NSN, Storage::dense},
    {"nsgs_nsn_gp", SICONOS_FRICTION_3D_NSGS, SICONOS_FRICTION_3D_ONECONTACT_NSN_GP, Storage::dense},
    {"nsgs_nsn_gp_hybrid", SICONOS_FRICTION_3D_NSGS, SICONOS_FRICTION_3D_ONECONTACT_NSN_GP_HYBRID,
     Storage::dense},
    {"nsgs_projection", SICONOS_FRICTION_3D_NSGS,
     SICONOS_FRICTION_3D_ONECONTACT_ProjectionOnConeWithLocalIteration, Storage::dense},
    {"prox", SICONOS_FRICTION_3D_PROX, 0, Storage::dense},
    {"tfp", SICONOS_FRICTION_3D_TFP, 0, Storage::dense},
    {"aclmfp", SICONOS_FRICTION_3D_ACLMFP, 0, Storage::dense},
    {"nsn_ac", SICONOS_FRICTION_3D_NSN_AC, 0, Storage::dense},
    {"nsn_ac_test", SICONOS_FRICTION_3D_NSN_AC_TEST, 0, Storage::dense},
    {"dsfp", SICONOS_FRICTION_3D_DSFP, 0, Storage::dense},
    {"fpp", SICONOS_FRICTION_3D_FPP, 0, Storage::dense},
    {"eg", SICONOS_FRICTION_3D_EG, 0, Storage::dense},
    {"vi_fpp", SICONOS_FRICTION_3D_VI_FPP, 0, Storage::dense},
    {"vi_eg", SICONOS_FRICTION_3D_VI_EG, 0, Storage::dense},
    {"admm", SICONOS_FRICTION_3D_ADMM, 0, Storage::dense},
    {"onecontact_quartic", SICONOS_FRICTION_3D_ONECONTACT_QUARTIC, 0, Storage::dense},
    {"onecontact_quartic_nu", SICONOS_FRICTION_3D_ONECONTACT_QUARTIC_NU, 0, Storage::dense},
    {"onecontact_nsn", SICONOS_FRICTION_3D_ONECONTACT_NSN, 0, Storage::dense},
    {"onecontact_nsn_gp", SICONOS_FRICTION_3D_ONECONTACT_NSN_GP, 0, Storage::dense},
    {"onecontact_nsn_gp_hybrid", SICONOS_FRICTION_3D_ONECONTACT_NSN_GP_HYBRID, 0, Storage::dense},
};

}  // namespace

struct SiconosProblem::Data {
  FrictionContactProblem* problem;
};

namespace {

/// Siconos frees what it is given with free().
template <class T>
T* allocate(std::size_t count) {
  auto* memory = static_cast<T*>(std::malloc(count * sizeof(T)));
  if (!memory) throw std::bad_alloc();
  return memory;
}

double* copy(const double* from, std::size_t count) {
  auto* to = allocate<double>(count);
  std::copy_n(from, count, to);
  return to;
}

/// W as 3 × 3 blocks, row by row; those that are zero are left out, but on the diagonal.
SparseBlockStructuredMatrix* block_matrix(const Eigen::MatrixXd& w) {
  const Eigen::Index n = w.rows() / 3;
  const auto count = static_cast<std::size_t>(n);
  SparseBlockStructuredMatrix* m = SBM_new();
  m->blocknumber0 = m->blocknumber1 = static_cast<unsigned>(n);
  m->blocksize0 = allocate<unsigned>(count);
  m->blocksize1 = allocate<unsigned>(count);
  m->index1_data = allocate<std::size_t>(count + 1);
  m->index2_data = allocate<std::size_t>(count * count);
  m->block = allocate<double*>(count * count);
  std::size_t blocks = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    m->blocksize0[i] = m->blocksize1[i] = static_cast<unsigned>(3 * (i + 1));
    m->index1_data[i] = blocks;
    for (Eigen::Index j = 0; j < n; ++j) {
      const Eigen::Matrix3d block = w.block<3, 3>(3 * i, 3 * j);
      if (i != j && block.isZero(0)) continue;
      m->block[blocks] = copy(block.data(), 9);
      m->index2_data[blocks++] = static_cast<std::size_t>(j);
    }
  }
  m->index1_data[n] = blocks;
  m->nbblocks = static_cast<unsigned>(blocks);
  m->filled1 = count + 1;
  m->filled2 = blocks;
  return m;
}

}  // namespace

SiconosProblem::SiconosProblem(const Eigen::MatrixXd& w, const Eigen::VectorXd& q,
                               const std::vector<double>& mu, Storage storage) {
  const auto n = static_cast<Eigen::Index>(3 * mu.size());
  if (mu.empty() || w.rows() != n || w.cols() != n || q.size() != n) {
    throw std::invalid_argument("SiconosProblem: W must be 3n x 3n, q 3n for n > 0 friction coefficients");
  }
  const int rows = static_cast<int>(n);
  const auto size = static_cast<std::size_t>(n);
  NumericsMatrix* matrix = storage == Storage::blocks
                               ? NM_new_SBM(rows, rows, block_matrix(w))
                               : NM_create_from_data(NM_DENSE, rows, rows, copy(w.data(), size * size));
  data_ = std::make_unique<Data>(Data{frictionContactProblem_new_with_data(
      3, rows / 3, matrix, copy(q.data(), size), copy(mu.data(), mu.size()))});
}

SiconosProblem::~SiconosProblem() {
  if (data_) frictionContactProblem_free(data_->problem);
}
SiconosProblem::SiconosProblem(SiconosProblem&&) noexcept = default;
SiconosProblem& SiconosProblem::operator=(SiconosProblem&& other) noexcept {
  std::swap(data_, other.data_);
  return *this;
}

void SiconosProblem::set_free_velocity(const Eigen::VectorXd& q) {
  if (q.size() != 3 * contacts()) throw std::invalid_argument("SiconosProblem: q of another size");
  std::copy_n(q.data(), q.size(), data_->problem->q);
}

int SiconosProblem::contacts() const { return data_->problem->numberOfContacts; }

double SiconosProblem::error(const Eigen::VectorXd& reaction) const {
  Eigen::VectorXd r = reaction;
  Eigen::VectorXd u(r.size());
  const Eigen::Map<const Eigen::VectorXd> q(data_->problem->q, r.size());
  double error = 0;
  fc3d_compute_error(data_->problem, r.data(), u.data(), 0, nullptr, q.norm(), &error);
  return error;
}

struct SiconosSolver::Options {
  struct Delete {
    void operator()(SolverOptions* options) const {
      solver_options_delete(options);  // its contents
      std::free(options);
    }
  };
  /// What the solvers adapt while they run and leave changed: tolerances, counters, flags.
  struct Parameters {
    std::vector<int> integers;
    std::vector<double> reals;

    explicit Parameters(const SolverOptions& o)
        : integers(o.iparam, o.iparam + o.iSize), reals(o.dparam, o.dparam + o.dSize) {}
    void restore(SolverOptions& o) const {
      std::copy(integers.begin(), integers.end(), o.iparam);
      std::copy(reals.begin(), reals.end(), o.dparam);
    }
  };

  std::unique_ptr<SolverOptions, Delete> handle;
  std::vector<Parameters> parameters;  ///< as set, of the solver and of its internal solvers
};

SiconosSolver::SiconosSolver(const std::string& name, double tolerance, int max_iterations) {
  const auto* found = std::find_if(std::begin(identifiers), std::end(identifiers),
                                   [&](const Identifier& i) { return name == i.name; });
  if (found == std::end(identifiers)) throw std::invalid_argument("Siconos has no solver " + name);
  numerics_set_verbose(0);
  SolverOptions* options = solver_options_create(found->solver);
  if (!options) throw std::runtime_error("Siconos does not offer its solver " + name);
  options_ = std::make_unique<Options>();
  options_->handle.reset(options);
  if (found->local != 0) solver_options_update_internal(options, 0, found->local);
  options->dparam[SICONOS_DPARAM_TOL] = tolerance;
  if (max_iterations > 0) options->iparam[SICONOS_IPARAM_MAX_ITER] = max_iterations;
  options_->parameters.emplace_back(*options);
  for (std::size_t i = 0; i < options->numberOfInternalSolvers; ++i) {
    options_->parameters.emplace_back(*options->internalSolvers[i]);
  }
}

SiconosSolver::~SiconosSolver() = default;
SiconosSolver::SiconosSolver(SiconosSolver&&) noexcept = default;
SiconosSolver& SiconosSolver::operator=(SiconosSolver&&) noexcept = default;

SiconosOutcome SiconosSolver::solve(SiconosProblem& problem, Eigen::VectorXd& reaction,
                                    Eigen::VectorXd& velocity) {
  SolverOptions& options = *options_->handle;
  options_->parameters[0].restore(options);
  for (std::size_t i = 1; i < options_->parameters.size(); ++i) {
    options_->parameters[i].restore(*options.internalSolvers[i - 1]);
  }
  const int info = fc3d_driver(problem.data_->problem, reaction.data(), velocity.data(), &options);
  return {info, options.iparam[SICONOS_IPARAM_ITER_DONE]};
}

const std::vector<SiconosMethod>& siconos_methods() {
  static const std::vector<SiconosMethod> methods = [] {
    std::vector<SiconosMethod> all;
    for (const Identifier& i : identifiers) {
      all.push_back({i.name, std::string(i.name).starts_with("onecontact"), i.storage});
    }
    return all;
  }();
  return methods;
}

Silence::Silence() {
  std::fflush(nullptr);
  output_ = dup(STDOUT_FILENO);
  error_ = dup(STDERR_FILENO);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  close(nowhere);
}

Silence::~Silence() {
  std::fflush(nullptr);
  dup2(output_, STDOUT_FILENO);
  dup2(error_, STDERR_FILENO);
  close(output_);
  close(error_);
}

}  // namespace rivals
