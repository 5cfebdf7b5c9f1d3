#pragma once

#include <array>
#include <cstdint>
#include <random>

#include "contensou/ball/friction_ball.hpp"

namespace verify::ball {

using contensou::FrictionForce;

/// A force, the size of the ball it is held against, and another force beside it.
struct Question {
  FrictionForce force;
  FrictionForce other;
  double size;
};

/// Points that are hard on purpose, one kind after the other.
class Sample {
 public:
  explicit Sample(std::uint64_t seed) : engine_(seed) {}

  template <class Ball>
  Question next(const Ball& ball) {
    constexpr std::uint64_t kinds = 10;
    const double size = log_uniform(1e-12, 1e12);
    switch (count_++ % kinds) {
      case 0:
        return near_other(size * log_uniform(0.1, 30) * direction(), size);
      case 1:
        return near_other(size * log_uniform(1, 1e12) * direction(), size);
      case 2:
        return near_other(size * log_uniform(1e-12, 1) * direction(), size);
      case 3:
        return near_border(ball, size);
      case 4:
        return near_other(FrictionForce(0, 0, signed_one() * size * log_uniform(1e-3, 1e3)), size);
      case 5: {
        FrictionForce p = direction();
        p[2] = 0;
        return near_other(size * log_uniform(1e-3, 1e3) * p, size);
      }
      case 6:
        return near_other(near_pole(size * log_uniform(1e-1, 1e3)), size);
      case 7:
        return near_other(near_equator(size * log_uniform(1e-1, 1e3)), size);
      case 8:
        return near_seam(ball, size);
      default:
        return extreme();
    }
  }

 private:
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double log_uniform(double a, double b) { return a * std::exp(uniform() * std::log(b / a)); }
  double signed_one() { return engine_() % 2 == 0 ? 1 : -1; }
  /// Uniform on the sphere.
  FrictionForce direction() {
    const double z = 2 * uniform() - 1;
    const double angle = 6.283185307179586 * uniform();
    const double t = std::sqrt((1 - z) * (1 + z));
    return {t * std::cos(angle), t * std::sin(angle), z};
  }
  FrictionForce near_pole(double length) {
    const FrictionForce d = direction();
    const double t = log_uniform(1e-17, 1e-3);
    return length * FrictionForce(t * d[0], t * d[1], signed_one());
  }
  FrictionForce near_equator(double length) {
    FrictionForce d = direction();
    d[2] = signed_one() * log_uniform(1e-17, 1e-3);
    return length * d;
  }
  /// Another force: half of them anywhere about as large, half of them
  /// next to it, from a millionth of an ulp on.
  Question near_other(const FrictionForce& force, double size) {
    if (engine_() % 2 == 0) return {force, size * log_uniform(0.1, 10) * direction(), size};
    const double scale = std::max(force.lpNorm<Eigen::Infinity>(), size);
    return {force, force + scale * log_uniform(1e-17, 1) * direction(), size};
  }
  template <class Ball>
  Question near_border(const Ball& ball, double size) {
    const auto q = ball.project(size * log_uniform(1, 10) * direction(), size);
    return near_other(q.point + size * signed_one() * log_uniform(1e-17, 1e-3) * q.normal, size);
  }
  /// Along the normal of the seam u = 1, up to 1000 ulp beside it.
  template <class Ball>
  Question near_seam(const Ball& ball, double size) {
    const FrictionForce d = direction();
    const double t = std::hypot(d[0], d[1]);
    const FrictionForce normal(d[0] / t, d[1] / t, signed_one());
    FrictionForce p = ball.boundary_point(size, normal) + size * log_uniform(1e-6, 1e3) * normal;
    p[2] *= 1 + std::floor(2001 * uniform() - 1000) * 0x1p-52;
    return near_other(p, size);
  }
  /// Forces and sizes at the ends of the range of doubles, and no size at all.
  Question extreme() {
    static constexpr std::array<double, 9> values{5e-324, 1e-310, 1e-300, 1e-160, 1, 1e154, 1e300, 1e308, 0};
    const double size = values[engine_() % 9];
    const double length = values[engine_() % 8];
    FrictionForce d = direction();
    if (engine_() % 2 == 0) d[2] = signed_one() * log_uniform(1e-300, 1);
    if (engine_() % 4 == 0) d.head<2>() *= log_uniform(1e-300, 1);
    return {length * d, length * direction(), size};
  }

  std::mt19937_64 engine_;
  std::uint64_t count_ = 0;
};

}  // namespace verify::ball
