#include "motions/bounces.hpp"

#include <algorithm>

namespace known_motions {

Bounces::Bounces(double z, double velocity, double g, double restitution)
    : z_(z),
      velocity_(velocity),
      g_(g),
      restitution_(restitution),
      impact_speed_(std::sqrt(velocity * velocity + 2 * g * z)) {}

double Bounces::impact_time(int k) const {
  // flights after the first: 2v_0/g times ε + ε² + ... + ε^k
  const double sum = restitution_ * (1 - std::pow(restitution_, k)) / (1 - restitution_);
  return (velocity_ + impact_speed_ + 2 * impact_speed_ * sum) / g_;
}

double Bounces::accumulation_time() const {
  return (velocity_ + impact_speed_ + 2 * impact_speed_ * restitution_ / (1 - restitution_)) / g_;
}

Bounces::Point Bounces::at(double t) const {
  if (t <= impact_time(0)) return {z_ + velocity_ * t - g_ * t * t / 2, velocity_ - g_ * t};
  if (t >= accumulation_time()) return {0, 0};
  int k = 0;
  while (impact_time(k + 1) < t && std::pow(restitution_, k + 1) > 0) ++k;
  const double speed = impact_speed_ * std::pow(restitution_, k + 1);
  const double flight = t - impact_time(k);
  return {std::max(0.0, speed * flight - g_ * flight * flight / 2), speed - g_ * flight};
}

}  // namespace known_motions
