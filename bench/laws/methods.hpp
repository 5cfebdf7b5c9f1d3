#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "contensou/law/batch.hpp"
#include "contensou/law/friction_law.hpp"

namespace bench {

/// One way, at one setting, to get Φ, ξ and η of one law.
struct Method {
  std::string name;
  std::string setting;
  std::string pressure;  ///< "uniform" | "hertz"
  /// Evaluates at every u into out, one after the other.
  std::function<void(std::span<const double> u, contensou::ReducedBatch out)> evaluate;
  /// The same as a chain: each argument waits for the result before it. Empty for a batch.
  std::function<double(std::span<const double> u)> chain;
};

/// Every method of the comparison, for both pressures.
std::vector<Method> law_methods();

/// For a function Reduced(double u).
template <class F>
Method scalar_method(std::string name, std::string setting, std::string pressure, F at) {
  return {std::move(name), std::move(setting), std::move(pressure),
          [at](std::span<const double> u, contensou::ReducedBatch out) {
            for (std::size_t i = 0; i < u.size(); ++i) {
              const contensou::Reduced r = at(u[i]);
              out.phi[i] = r.phi;
              out.xi[i] = r.xi;
              out.eta[i] = r.eta;
            }
          },
          [at](std::span<const double> u) {
            double nothing = 0;  // 0 · phi: no change to u, but known only when phi is
            for (const double x : u) {
              const contensou::Reduced r = at(x + nothing);
              nothing = 0 * r.phi;
            }
            return nothing;
          }};
}

}  // namespace bench
