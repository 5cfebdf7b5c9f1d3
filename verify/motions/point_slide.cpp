#include "motions/point_slide.hpp"

#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>

namespace known_motions {

PointSlide::PointSlide(const Eigen::Vector2d& velocity, double pull, double friction)
    : start_(velocity), pull_(pull), friction_(friction) {
  if (pull == 0 || velocity.y() == 0) {
    straight_ = friction - (velocity.x() > 0 ? pull : -pull);
    return;
  }
  kappa_ = friction / pull;
  p_ = std::tan(std::atan2(std::abs(velocity.y()), velocity.x()) / 2);
  c_ = 2 * velocity.norm() * std::pow(p_, 1 - kappa_) / (1 + p_ * p_);
}

double PointSlide::time(double p) const {
  const auto primitive = [this](double x) {
    return std::pow(x, kappa_ - 1) / (kappa_ - 1) + std::pow(x, kappa_ + 1) / (kappa_ + 1);
  };
  return c_ / (2 * pull_) * (primitive(p_) - primitive(p));
}

PointSlide::Point PointSlide::at_turn(double p) const {
  const auto along = [this](double x) {
    return std::pow(x, 2 * kappa_ - 2) / (2 * kappa_ - 2) - std::pow(x, 2 * kappa_ + 2) / (2 * kappa_ + 2);
  };
  const auto across = [this](double x) {
    return std::pow(x, 2 * kappa_ - 1) / (2 * kappa_ - 1) + std::pow(x, 2 * kappa_ + 1) / (2 * kappa_ + 1);
  };
  const double side = start_.y() > 0 ? 1 : -1;
  const double scale = c_ * c_ / (2 * pull_);
  return {{c_ * std::pow(p, kappa_ - 1) * (1 - p * p) / 2, side * c_ * std::pow(p, kappa_)},
          {scale / 2 * (along(p_) - along(p)), side * scale * (across(p_) - across(p))}};
}

double PointSlide::stopping_time() const { return straight_ > 0 ? start_.norm() / straight_ : time(0); }

PointSlide::Point PointSlide::at(double t) const {
  const double end = stopping_time();
  if (straight_ > 0) {
    const double left = std::max(0.0, 1 - t / end);
    return {left * start_, end / 2 * (1 - left * left) * start_};
  }
  if (t >= end) return at_turn(0);
  if (t <= 0) return {start_, Eigen::Vector2d::Zero()};
  // In x = p^(κ−1) the time is nearly linear up to its end.
  const auto late = [&](double x) { return time(std::pow(x, 1 / (kappa_ - 1))) - t; };
  std::uintmax_t iterations = 200;
  const auto [low, high] = boost::math::tools::toms748_solve(
      late, 0.0, std::pow(p_, kappa_ - 1), boost::math::tools::eps_tolerance<double>(52), iterations);
  return at_turn(std::pow((low + high) / 2, 1 / (kappa_ - 1)));
}

}  // namespace known_motions
