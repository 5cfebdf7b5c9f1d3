#include "errors.hpp"

#include <cmath>

namespace accuracy {
namespace {

double error_of_not_finite(double value) {
  return std::isnan(value) ? std::numeric_limits<double>::quiet_NaN()
                           : std::numeric_limits<double>::infinity();
}

}  // namespace

double ulp_error(double value, const Quad& exact) {
  if (!std::isfinite(value)) return error_of_not_finite(value);
  const double nearest = std::abs(static_cast<double>(exact));
  const double ulp = std::nextafter(nearest, std::numeric_limits<double>::infinity()) - nearest;
  return static_cast<double>(abs(Quad(value) - exact) / Quad(ulp));
}

double relative_error(double value, const Quad& exact) {
  if (!std::isfinite(value)) return error_of_not_finite(value);
  if (exact == 0) return value == 0 ? 0 : std::numeric_limits<double>::infinity();
  return static_cast<double>(abs((Quad(value) - exact) / exact));
}

void ErrorSummary::add(double u, double error) {
  ++points_;
  if (std::isfinite(error)) {
    sum_ += error;
  } else {
    ++not_finite_;
  }
  // A NaN, once met, stays: "not > max" would let it pass.
  if (points_ == 1 || (!std::isnan(max_) && !(error <= max_))) {
    max_ = error;
    worst_u_ = u;
  }
}

double ErrorSummary::mean() const {
  const std::size_t numbers = points_ - not_finite_;
  return numbers > 0 ? sum_ / static_cast<double>(numbers) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace accuracy
