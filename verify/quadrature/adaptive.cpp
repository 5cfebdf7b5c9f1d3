#include "adaptive.hpp"

#include <gsl/gsl_errno.h>

namespace verify {

Adaptive::Adaptive(double relative, double absolute)
    : workspace_(gsl_integration_workspace_alloc(most_panels)), relative_(relative), absolute_(absolute) {
  // GSL aborts on a missed tolerance by default; here the estimate itself is the report (`worst`).
  gsl_set_error_handler_off();
}

Estimate Adaptive::adaptive(gsl_function& f, double a, double b, const std::vector<double>& breaks) {
  std::vector<double> ends{a};
  for (const double x : breaks) {
    if (x > ends.back() && x < b) ends.push_back(x);
  }
  ends.push_back(b);
  if (ends.size() == 2) {
    Estimate e;
    gsl_integration_qags(&f, a, b, absolute_, relative_, most_panels, workspace_.get(), &e.value, &e.error);
    return judged(e);
  }
  // A first look (Gauss-Kronrod, 21 points a panel) says what the whole is, so that a panel that matters
  // little is not pressed for digits that do not count.
  double size = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    Estimate e;
    double of_modulus = 0;
    double of_deviation = 0;
    gsl_integration_qk21(&f, ends[i], ends[i + 1], &e.value, &e.error, &of_modulus, &of_deviation);
    size += e.value;
  }
  // Half of the tolerance goes to the panels in equal shares, half in proportion to what they hold.
  const double share =
      std::max(absolute_, relative_ * std::abs(size)) / 2 / static_cast<double>(ends.size() - 1);
  Estimate sum;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    Estimate e;
    gsl_integration_qags(&f, ends[i], ends[i + 1], share, relative_ / 2, most_panels, workspace_.get(),
                         &e.value, &e.error);
    sum.value += e.value;
    sum.error += e.error;
  }
  return judged(sum);
}

Estimate Adaptive::smooth(gsl_function& f, double a, double b) {
  Estimate e;
  gsl_integration_qag(&f, a, b, absolute_, relative_, most_panels, GSL_INTEG_GAUSS31, workspace_.get(),
                      &e.value, &e.error);
  return judged(e);
}

Estimate Adaptive::judged(Estimate e) {
  const double asked = std::max(absolute_, relative_ * std::abs(e.value));
  // A NaN must not hide behind the comparison.
  if (e.error > 0 || std::isnan(e.error) || std::isnan(e.value)) {
    const double ratio = e.error / asked;
    worst_ = std::isnan(ratio) ? HUGE_VAL : std::max(worst_, ratio);
  }
  return e;
}

}  // namespace verify
