#include "about_pole.hpp"

#include <numbers>

namespace verify {
namespace {
using std::numbers::pi;
}

double AboutPole::along(Quantity quantity, const Chord& chord) {
  // q = middle ± half cos β: the complement 1 − ρ² is half² sin² β, without loss of digits at the edge.
  const auto pair = [&](double beta) {
    const double step = chord.half * std::cos(beta);
    const double depth = chord.half * std::sin(beta);
    const double sigma = pressure_.sigma(std::sqrt(chord.offset * chord.offset + step * step), depth * depth);
    double two_points = 0;
    switch (quantity) {
      case Quantity::potential:
        two_points = 2 * (chord.middle * chord.middle + step * step);
        break;
      case Quantity::force:
        two_points = 2 * chord.middle * chord.cosine;
        break;
      case Quantity::torque:
        two_points = 2 * step * step;
        break;
      case Quantity::curvature:
        two_points = 2 * chord.sine * chord.sine;
        break;
      case Quantity::load:
        two_points = 2 * std::max(chord.middle, step);
        break;  // ||q⁺| + |q⁻||, the pole inside or not
    }
    return sigma * two_points * depth;
  };
  std::vector<double> breaks;
  for (const double rho : pressure_.breaks) {
    if (rho > chord.offset) {
      const double step = std::sqrt((rho - chord.offset) * (rho + chord.offset));
      if (step < chord.half) breaks.push_back(std::acos(step / chord.half));
    }
  }
  if (pressure_.cone_at_centre && chord.offset > 0) {
    // The chord passes the tip at the distance `offset`: panels grow from there outwards, eightfold.
    for (double step = chord.offset; step < chord.half; step *= 8)
      breaks.push_back(std::acos(step / chord.half));
  }
  if (quantity == Quantity::load && chord.middle < chord.half)
    breaks.push_back(std::acos(chord.middle / chord.half));
  std::sort(breaks.begin(), breaks.end());
  return chords_.integrate(pair, 0, pi / 2, breaks).value;
}

Estimate AboutPole::operator()(Quantity quantity, double u) {
  Estimate e;
  // Lines that touch a circle where the pressure has a break: u sin θ = that radius.
  std::vector<double> breaks;
  if (u <= 1) {
    // δ = π/2 − θ. The half-length of the chord has its branch points near δ = ±i √(1 − u²)/u.
    const double gap = (1 - u) * (1 + u);
    const auto line = [&](double delta) {
      const double cosine = std::sin(delta);
      const double sine = std::cos(delta);
      const double middle = u * cosine;
      return 2 * along(quantity, {middle, u * sine, std::sqrt(gap + middle * middle), cosine, sine});
    };
    for (const double rho : pressure_.breaks) {
      if (rho < u) breaks.push_back(std::acos(rho / u));
    }
    std::sort(breaks.begin(), breaks.end());
    e = lines_.integrate_near_pole(line, pi / 2, std::sqrt(gap) / u, breaks);
  } else {
    // u sin θ = cos ε, so that the chord shrinks like sin ε towards θ*; cos θ dθ = −sin ε dε/u.
    const double gap = (u - 1) * (u + 1);
    const auto line = [&](double epsilon) {
      const double half = std::sin(epsilon);
      const double offset = std::cos(epsilon);
      const double middle = std::sqrt(gap + half * half);
      return 2 * along(quantity, {middle, offset, half, middle / u, offset / u}) * half / middle;
    };
    for (const double rho : pressure_.breaks) breaks.push_back(std::acos(rho));
    std::sort(breaks.begin(), breaks.end());
    e = lines_.integrate_near_pole(line, pi / 2, std::sqrt(gap), breaks);
  }
  e.error += inner_tolerance * std::abs(e.value);
  return e;
}

}  // namespace verify
