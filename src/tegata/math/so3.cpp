// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/math/so3.h"

#include <cmath>

namespace tegata {

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& a) {
  Eigen::Matrix3d matrix;
  matrix << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return matrix;
}

Eigen::Quaterniond so3_exp(const Eigen::Vector3d& axis_angle) {
  const double angle = axis_angle.norm();
  // sin(angle / 2) / angle by its series where the quotient would lose digits.
  const double scale = angle < 1e-4 ? 0.5 - angle * angle / 48.0 : std::sin(0.5 * angle) / angle;
  const Eigen::Vector3d imaginary = scale * axis_angle;
  return {std::cos(0.5 * angle), imaginary.x(), imaginary.y(), imaginary.z()};
}

Eigen::Vector3d so3_log(const Eigen::Quaterniond& rotation) {
  // q and -q are the same rotation; the one with a positive real part turns by at most pi.
  const double sign = rotation.w() < 0.0 ? -1.0 : 1.0;
  const Eigen::Vector3d imaginary = sign * rotation.vec();
  const double sine = imaginary.norm();
  const double angle = 2.0 * std::atan2(sine, sign * rotation.w());
  return sine < 1e-9 ? Eigen::Vector3d(2.0 * imaginary)
                     : Eigen::Vector3d(imaginary * (angle / sine));
}

}  // namespace tegata
