// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/camera/lens.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tegata {
namespace {

constexpr double kTolerance = 1e-12;

Eigen::Vector2d distort_perspective(const Distortion& d, const Eigen::Vector2d& ideal) {
  const double x = ideal.x(), y = ideal.y();
  const double r2 = x * x + y * y, r4 = r2 * r2, r6 = r4 * r2;
  const double radial =
      (1.0 + d[0] * r2 + d[1] * r4 + d[4] * r6) / (1.0 + d[5] * r2 + d[6] * r4 + d[7] * r6);
  return {x * radial + 2.0 * d[2] * x * y + d[3] * (r2 + 2.0 * x * x) + d[8] * r2 + d[9] * r4,
          y * radial + d[2] * (r2 + 2.0 * y * y) + 2.0 * d[3] * x * y + d[10] * r2 + d[11] * r4};
}

Eigen::Vector2d undistort_perspective(const Distortion& d, const Eigen::Vector2d& distorted) {
  constexpr int kMostIterations = 100;
  Eigen::Vector2d ideal = distorted;
  for (int i = 0; i < kMostIterations; ++i) {
    const Eigen::Vector2d error = distort_perspective(d, ideal) - distorted;
    ideal -= error;
    if (error.norm() < kTolerance) break;
  }
  return ideal;
}

// The radius of a ray at an angle off the axis (Kannala and Brandt 2006, the odd powers to 9).
double fisheye_radius(const Distortion& d, double angle) {
  const double a2 = angle * angle;
  return angle * (1.0 + a2 * (d[0] + a2 * (d[1] + a2 * (d[2] + a2 * d[3]))));
}

double fisheye_slope(const Distortion& d, double angle) {
  const double a2 = angle * angle;
  return 1.0 + a2 * (3.0 * d[0] + a2 * (5.0 * d[1] + a2 * (7.0 * d[2] + a2 * 9.0 * d[3])));
}

// Newton steps that a bisection keeps within [0, largest].
double fisheye_angle(const Distortion& d, double radius) {
  constexpr int kMostIterations = 60;
  constexpr double kLargest = 89.0 / 180.0 * std::numbers::pi;
  double low = 0.0, high = kLargest;
  double angle = std::min(radius, kLargest);
  for (int i = 0; i < kMostIterations; ++i) {
    const double error = fisheye_radius(d, angle) - radius;
    if (std::abs(error) < kTolerance) break;
    (error > 0.0 ? high : low) = angle;
    const double next = angle - error / fisheye_slope(d, angle);
    angle = next > low && next < high ? next : 0.5 * (low + high);
  }
  return angle;
}

// A direction of the plane, lengthened or shortened to a radius.
Eigen::Vector2d with_radius(const Eigen::Vector2d& point, double radius) {
  const double length = point.norm();
  return length > 0.0 ? Eigen::Vector2d(point * (radius / length)) : point;
}

}  // namespace

std::string_view lens_model_name(LensModel model) {
  return model == LensModel::fisheye ? "fisheye" : "perspective";
}

bool Lens::is_ideal() const {
  return model == LensModel::perspective &&
         std::all_of(coefficients.begin(), coefficients.end(), [](double c) { return c == 0.0; });
}

Eigen::Vector2d Lens::distort(const Eigen::Vector2d& ideal) const {
  if (model == LensModel::perspective) return distort_perspective(coefficients, ideal);
  return with_radius(ideal, distorted_radius(ideal.norm()));
}

Eigen::Vector2d Lens::undistort(const Eigen::Vector2d& distorted) const {
  if (model == LensModel::perspective) return undistort_perspective(coefficients, distorted);
  return with_radius(distorted, std::tan(fisheye_angle(coefficients, distorted.norm())));
}

double Lens::distorted_radius(double ideal) const {
  if (model == LensModel::fisheye) return fisheye_radius(coefficients, std::atan(ideal));
  const Distortion& d = coefficients;
  const double r2 = ideal * ideal;
  return ideal * (1.0 + r2 * (d[0] + r2 * (d[1] + r2 * d[4]))) /
         (1.0 + r2 * (d[5] + r2 * (d[6] + r2 * d[7])));
}

}  // namespace tegata
