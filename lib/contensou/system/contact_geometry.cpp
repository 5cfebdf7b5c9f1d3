#include "contensou/system/contact_geometry.hpp"

#include <Eigen/Geometry>

namespace contensou {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Where e_z gives way to −e_z.
constexpr double seam = -0.9;

double side(const Vector3d& normal) { return normal[2] < seam ? -1 : 1; }

}  // namespace

Matrix3d contact_axes(const Vector3d& normal) {
  const double s = side(normal);
  const Vector3d middle = normal + s * Vector3d::UnitZ();
  const double scale = 1 / (1 + s * normal[2]);
  Matrix3d axes;
  axes.col(0) = normal;
  axes.col(1) = Vector3d::UnitX() - normal[0] * scale * middle;
  axes.col(2) = s * (Vector3d::UnitY() - normal[1] * scale * middle);
  return axes;
}

Matrix3d contact_axes_rate(const Vector3d& normal, const Vector3d& rate) {
  const double s = side(normal);
  const Vector3d middle = normal + s * Vector3d::UnitZ();
  const double scale = 1 / (1 + s * normal[2]);
  const double scale_rate = -s * rate[2] * scale * scale;
  const auto tangent = [&](int k) -> Vector3d {
    return -(rate[k] * scale + normal[k] * scale_rate) * middle - normal[k] * scale * rate;
  };
  Matrix3d rates;
  rates.col(0) = rate;
  rates.col(1) = tangent(0);
  rates.col(2) = s * tangent(1);
  return rates;
}

double sphere_gap(const Vector3d& centre, double radius, const Vector3d& other, double other_radius) {
  return (centre - other).norm() - (radius + other_radius);
}

SphereContact sphere_contact(const MovingSphere& sphere, const MovingSphere& other, bool friction) {
  const Vector3d between = sphere.centre - other.centre;
  const double distance = between.norm();
  const Vector3d normal = between / distance;
  const Vector3d approach = sphere.velocity - other.velocity;
  const Vector3d normal_rate = (approach - normal.dot(approach) * normal) / distance;
  const Vector3d bend = sphere.acceleration - other.acceleration;

  SphereContact contact;
  contact.lever = sphere.arm - sphere.radius * normal;
  contact.other = other.arm + other.radius * normal;
  if (friction) {
    const Vector3d rolling = sphere.radius * sphere.spin + other.radius * other.spin;
    const Vector3d slip = approach - rolling.cross(normal);
    const Vector3d slip_rate = bend - rolling.cross(normal_rate);
    contact.axes = contact_axes(normal);
    contact.drift = contact_axes_rate(normal, normal_rate).transpose() * slip;
    contact.drift += contact.axes.transpose() * slip_rate;
    contact.spin_drift = normal_rate.dot(sphere.spin - other.spin);
  } else {
    contact.axes.col(0) = normal;
  }
  // In γ_N both parts have one that cancels.
  contact.drift[0] = normal_rate.dot(approach) + normal.dot(bend);
  return contact;
}

}  // namespace contensou
