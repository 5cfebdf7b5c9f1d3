#include "closed_forms.hpp"

#include <acb_elliptic.h>

#include "integration.hpp"

namespace reference {

namespace {

using Elliptic = void (*)(acb_t, const acb_t, slong);

Ball complete(Elliptic integral, const Ball& m) {
  Box parameter;
  Box value;
  acb_set_arb(parameter.raw(), m.raw());
  integral(value.raw(), parameter.raw(), m.bits());
  Ball real(m.bits());
  acb_get_real(real.raw(), value.raw());
  return real;
}

}  // namespace

Scaled uniform_closed_form(const Argument& at) {
  const Ball& m = at.m;
  const Ball& mc = at.complement;
  const Ball k = complete(acb_elliptic_k, m);
  const Ball e = complete(acb_elliptic_e, m);
  const Ball d = (k - e) / m;
  const Ball b = k - d;
  const Ball c = (d - b) / m;
  const Ball third = 4.0 / (3.0 * pi(m.bits()));
  const Ball ninth = third / 3.0;
  if (at.inner) {
    return {third * (2.0 * b + mc * d), ninth * ((3.0 - m) * b + mc * (3.0 - 2.0 * m) * d),
            third * (b + 2.0 * mc * d)};
  }
  return {third * (2.0 * b + mc * d), ninth * (2.0 * b + mc * c), third * (d - c)};
}

Scaled hertz_closed_form(const Argument& at) {
  const Ball& u = at.u;
  const Ball square = u * u;
  const Ball fourth = square * square;
  if (at.inner) {
    const Ball amplitude = 3.0 * pi(u.bits()) / 32.0;
    return {amplitude * (4.0 - square), amplitude / 4.0 * (3.0 * fourth - 8.0 * square + 8.0),
            amplitude * (4.0 - 3.0 * square)};
  }
  const Ball angle = asin(1.0 / u);
  const Ball root = sqrt((u - 1.0) * (u + 1.0));
  const Ball force =
      Ball(3.0, u.bits()) / 16.0 / u * (square * (4.0 - square) * angle + (square + 2.0) * root);
  const Ball torque = Ball(3.0, u.bits()) / 64.0 *
                      ((3.0 * fourth - 8.0 * square + 8.0) * angle + (6.0 - 3.0 * square) * root);
  const Ball second =
      Ball(3.0, u.bits()) / 16.0 * ((4.0 - 3.0 * square) * angle + (3.0 - 2.0 / square) * root);
  return {force, u * torque, u * square * second};
}

}  // namespace reference
