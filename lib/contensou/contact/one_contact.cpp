#include "contensou/contact/one_contact.hpp"

#include <cmath>
#include <limits>

#include "contensou/contact/cylinder_contact.hpp"
#include "contensou/contact/one_contact_states.hpp"

namespace contensou {
namespace {

using detail::OneContact;
using detail::rounding;

/// The proximal point method: a compliance δ is added that makes the problem easy, and its effect taken away
/// by the friction of the last iterate.
template <class Domain>
void approach(const Domain& domain, double mu, const ContactMatrix<Domain>& w, const ContactVector<Domain>& b,
              OneContactSolution<Domain>& best) {
  using Vector = ContactVector<Domain>;
  constexpr int most_iterations = 30;
  constexpr double compliance = 0x1p-18;
  Vector delta = compliance * w.diagonal();
  delta[0] = 0;
  const ContactMatrix<Domain> stiff = w + ContactMatrix<Domain>(delta.asDiagonal());
  const double speed = b.cwiseAbs().maxCoeff();
  Vector z = best.state == ContactState::unsolved ? Vector(Vector::Zero()) : best.impulse;
  for (int i = 0; i < most_iterations; ++i) {
    const Vector shift = delta.cwiseProduct(z);
    const Vector shifted = b - shift;
    auto next = OneContact<Domain>(domain, mu, stiff, shifted).solve(z);
    if (next.state == ContactState::unsolved) return;
    const double residual = next.residual + (delta.cwiseProduct(next.impulse) - shift).norm() / speed;
    z = next.impulse;
    const int iterations = best.iterations + next.iterations;
    if (residual < best.residual) {
      best = next;
      best.residual = residual;
    }
    best.iterations = iterations;
    if (best.residual <= rounding) return;
  }
}

}  // namespace

template <class Domain>
OneContactSolution<Domain> solve_one_contact(const Domain& domain, double mu, const ContactMatrix<Domain>& w,
                                             const ContactVector<Domain>& b,
                                             const ContactVector<Domain>& guess) {
  const ContactVector<Domain> zero = ContactVector<Domain>::Zero();
  if (b[0] >= 0) return {zero, ContactState::open, 0, 0};
  if (!(w(0, 0) > 0)) return {zero, ContactState::unsolved, 0, std::numeric_limits<double>::infinity()};
  const OneContact<Domain> contact(domain, mu, w, b);
  auto best = contact.solve(guess);
  if (best.residual <= rounding) return best;
  approach(domain, mu, w, b, best);
  return best.residual <= rounding ? best : contact.polished(best);
}

template <>
OneContactSolution<NoFriction> solve_one_contact(const NoFriction&, double,
                                                 const ContactMatrix<NoFriction>& w,
                                                 const ContactVector<NoFriction>& b,
                                                 const ContactVector<NoFriction>&) {
  if (b[0] >= 0) return {ContactVector<NoFriction>::Zero(), ContactState::open, 0, 0};
  const ContactVector<NoFriction> impulse(-b[0] / w(0, 0));
  if (impulse[0] > 0 && std::isfinite(impulse[0])) return {impulse, ContactState::stick, 0, 0};
  return {ContactVector<NoFriction>::Zero(), ContactState::unsolved, 0,
          std::numeric_limits<double>::infinity()};
}

#define CONTENSOU_ONE_CONTACT(DOMAIN)                                                                        \
  template OneContactSolution<DOMAIN> solve_one_contact(const DOMAIN&, double, const ContactMatrix<DOMAIN>&, \
                                                        const ContactVector<DOMAIN>&,                        \
                                                        const ContactVector<DOMAIN>&);
CONTENSOU_ONE_CONTACT(FrictionDisk)
CONTENSOU_ONE_CONTACT(FrictionBall<SmoothPlate<UniformLaw>>)
CONTENSOU_ONE_CONTACT(FrictionBall<SmoothPlate<HertzLaw>>)
CONTENSOU_ONE_CONTACT(FrictionBall<SmoothPlate<CompiledLaw>>)
CONTENSOU_ONE_CONTACT(FrictionBall<SmoothPlate<EllipsoidLaw>>)
CONTENSOU_ONE_CONTACT(FrictionCylinder)
#undef CONTENSOU_ONE_CONTACT

}  // namespace contensou
