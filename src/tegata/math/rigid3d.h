// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace tegata {

/// A rotation followed by a translation. Variables are named b_from_a: they take coordinates in
/// frame a to coordinates in frame b.
struct Rigid3d {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  /// a_from_b of b_from_a.
  Rigid3d inverse() const {
    const Eigen::Quaterniond back = rotation.conjugate();
    return {back, -(back * translation)};
  }
};

/// c_from_b * b_from_a = c_from_a.
inline Rigid3d operator*(const Rigid3d& c_from_b, const Rigid3d& b_from_a) {
  return {(c_from_b.rotation * b_from_a.rotation).normalized(),
          c_from_b.rotation * b_from_a.translation + c_from_b.translation};
}

/// b_from_a * point_in_a = point_in_b.
inline Eigen::Vector3d operator*(const Rigid3d& b_from_a, const Eigen::Vector3d& point_in_a) {
  return b_from_a.rotation * point_in_a + b_from_a.translation;
}

/// The turn by |axis_angle| radians about a line through `center` along `axis_angle`.
Rigid3d rotation_about(const Eigen::Vector3d& center, const Eigen::Vector3d& axis_angle);

/// The rigid transform b_from_a that takes the columns of `points_in_a` (3 x n, n >= 3, not all on
/// one line) closest to those of `points_in_b` in the least-squares sense (Kabsch 1976; Umeyama
/// 1991 without scale). Never a reflection. Throws Error on fewer points or different counts.
Rigid3d align_points(const Eigen::Matrix3Xd& points_in_a, const Eigen::Matrix3Xd& points_in_b);

}  // namespace tegata
