#include "ode.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <memory>
#include <stdexcept>

namespace verify::answers {

void solve(const OdeRight& right, double from, double to, std::vector<double>& y) {
  if (!(to > from)) return;
  const auto call = [](double t, const double* at, double* rate, void* f) {
    (*static_cast<const OdeRight*>(f))(t, at, rate);
    return static_cast<int>(GSL_SUCCESS);
  };
  gsl_odeiv2_system system{call, nullptr, y.size(), const_cast<OdeRight*>(&right)};
  const double first = 1e-3 * (to - from);
  const std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)> driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, first, accuracy, accuracy),
      gsl_odeiv2_driver_free);
  double t = from;
  if (gsl_odeiv2_driver_apply(driver.get(), &t, to, y.data()) != GSL_SUCCESS)
    throw std::runtime_error("ordinary differential equation: no step is small enough");
}

}  // namespace verify::answers
