#pragma once

#include <gsl/gsl_integration.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace verify {

/// An integral and GSL's estimate of its absolute error.
struct Estimate {
  double value = 0;
  double error = 0;
};

/// One level of a nested integration: a GSL workspace with the tolerance asked of every integral done in it.
///
/// Every integrand here is positive (see about_centre.hpp, about_pole.hpp) unless said otherwise, so a
/// relative error ε of the inner integrals is a relative error ε of the outer one, and tolerances add.
class Adaptive {
 public:
  /// `relative` >= 50 machine epsilons (GSL's own limit); `absolute` > 0 only for integrals that may vanish.
  explicit Adaptive(double relative, double absolute = 0);

  /// ∫_a^b f, smooth inside; algebraic or logarithmic singularities allowed at the ends and at `breaks`
  /// (ascending, those outside (a, b) are ignored). QAGS panel by panel between the breaks. (QAGP, which
  /// extrapolates over all panels together, was seen to report 1e-12 and be off by 1e-7 where breaks lie at
  /// very different scales.)
  template <class F>
  Estimate integrate(F&& f, double a, double b, const std::vector<double>& breaks = {}) {
    gsl_function g = as_gsl(f);
    return adaptive(g, a, b, breaks);
  }

  /// ∫_0^b f(x) dx for an f that is analytic but for branch points near x = ±i `width` and singularities at
  /// `breaks`. With x = width sinh z the branch points move to z = ±iπ/2 whatever the width (Johnston &
  /// Elliott, Int. J. Numer. Meth. Engng 62 (2005) 564). A width of zero or more than b is integrated as it
  /// stands. Gauss-Kronrod with 31 points (QAG) where there is no break, else QAGS between them.
  template <class F>
  Estimate integrate_near_pole(F&& f, double b, double width, const std::vector<double>& breaks = {}) {
    if (!(width > 0 && width < b)) {
      gsl_function plain = as_gsl(f);
      return breaks.empty() ? smooth(plain, 0, b) : adaptive(plain, 0, b, breaks);
    }
    auto stretched = [&f, width](double z) { return f(width * std::sinh(z)) * width * std::cosh(z); };
    gsl_function g = as_gsl(stretched);
    const double end = std::asinh(b / width);
    if (breaks.empty()) return smooth(g, 0, end);
    std::vector<double> stretched_breaks;
    for (const double x : breaks) stretched_breaks.push_back(std::asinh(x / width));
    return adaptive(g, 0, end, stretched_breaks);
  }

  /// The largest ratio of estimated error to what was asked for, over all integrals so far; above 1: a miss.
  double worst() const { return worst_; }
  double relative() const { return relative_; }

 private:
  template <class F>
  static gsl_function as_gsl(F& f) {
    using Callable = std::remove_reference_t<F>;
    return {[](double x, void* p) { return (*static_cast<Callable*>(p))(x); },
            const_cast<std::remove_const_t<Callable>*>(std::addressof(f))};
  }
  Estimate adaptive(gsl_function& f, double a, double b, const std::vector<double>& breaks);
  Estimate smooth(gsl_function& f, double a, double b);
  Estimate judged(Estimate e);

  struct Free {
    void operator()(gsl_integration_workspace* w) const { gsl_integration_workspace_free(w); }
  };
  static constexpr std::size_t most_panels = 1000;
  std::unique_ptr<gsl_integration_workspace, Free> workspace_;
  double relative_;
  double absolute_;
  double worst_ = 0;
};

}  // namespace verify
