#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace accuracy {

/// What one way of computing a law gives at one u.
struct Values {
  double phi;
  double xi;
  double eta;
  double second;  ///< f″(u); NaN where the way has none (has_second)
};

/// One way of computing one law.
struct Contender {
  std::string pressure;  ///< "uniform" | "hertz"
  std::string method;
  bool ours;  ///< held to a bound; the others are measured only
  bool has_second;
  std::function<std::vector<Values>(std::span<const double> u)> evaluate;
};

/// The library's laws, scalar and in batches, and their rivals.
std::vector<Contender> contenders();

}  // namespace accuracy
