#pragma once

#include <string>

#include "record.hpp"
#include "reduced_integrals.hpp"

namespace verify {

/// One comparison over many u: what a claim is made of.
class Comparison {
 public:
  /// Adds one value against the oracle's, with the bound on
  /// their relative difference; a bound may depend on u.
  void add(double u, double oracle, double value, double bound);

  double max_error() const { return max_error_; }
  double max_error_at() const { return max_error_at_; }
  int count() const { return count_; }

  /// The claim is judged where the error comes closest to its bound (or exceeds it by most), `sentence` is
  /// completed by the largest error and where it is.
  Claim claim(std::string id, std::string where, const std::string& sentence, bool should_hold = true) const;

 private:
  struct Point {
    double u = 0;
    double oracle = 0;
    double value = 0;
    double error = 0;
    double bound = 0;
  };
  Point tightest_;
  double tightest_ratio_ = -1;
  double max_error_ = 0;
  double max_error_at_ = 0;
  int count_ = 0;
};

/// A number with a few significant digits, for sentences.
std::string brief(double x);
/// The same for a slip ratio: near 1 its distance from 1 is what tells.
std::string brief_ratio(double u);

}  // namespace verify
