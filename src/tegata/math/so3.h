// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace tegata {

/// The matrix of the cross product: cross_matrix(a) * b = a x b.
Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& a);

/// The rotation by |axis_angle| radians about axis_angle, exact near zero as well.
Eigen::Quaterniond so3_exp(const Eigen::Vector3d& axis_angle);

/// The rotation vector, of length at most pi, whose exponential is the rotation (of unit norm).
Eigen::Vector3d so3_log(const Eigen::Quaterniond& rotation);

}  // namespace tegata
