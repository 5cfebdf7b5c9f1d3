#pragma once

#include <string>

#include "contensou/contact/contact_solver.hpp"
#include "iteration.hpp"

/// How the iteration of LG03 4.1 fares on one contact problem, for a given r and for the chosen one.
namespace verify::augmented {

/// A case, its solution and what is known of it.
struct Solved {
  Case name;
  Step step;
  contensou::SolverReport report;  ///< of the automatic r, to 1e-10
  Eigen::VectorXd impulse;         ///< Λ*, to 1e-12 where rounding allows
  double velocity;                 ///< largest |b| [m/s]
  double limit;                    ///< 2/λ_max(W) [kg]
  std::string state;               ///< open, stick or slip, contact by contact
};
Solved solve(const TippeTop& top, const Case& c);

/// One r.
struct Trial {
  double r;
  contensou::SolverStatus status;
  int to_1e6;            ///< iterations to a natural-map residual of 1e-6, if that was reached
  int to_1e10;           ///< and of 1e-10
  double predicted;      ///< rate of convergence: spectral radius of the iteration at Λ*
  double measured;       ///< from residual 1e-7 to 1e-10; NaN if that took fewer than 20 iterations
  int printed;           ///< passes until ‖ΔΛ_N‖ + ‖ΔΛ_F‖ <= 1e-6 ‖Λ*‖
  double printed_error;  ///< ‖Λ − Λ*‖/‖Λ*‖ then
};
/// At most `limit` iterations, of either kind.
Trial attempt(const Solved& solved, double r, int limit);

const char* name(contensou::SolverStatus status);

}  // namespace verify::augmented
