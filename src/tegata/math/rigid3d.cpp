// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/math/rigid3d.h"

#include <Eigen/SVD>

#include "tegata/base/error.h"
#include "tegata/math/so3.h"

namespace tegata {

Rigid3d rotation_about(const Eigen::Vector3d& center, const Eigen::Vector3d& axis_angle) {
  const Eigen::Quaterniond rotation = so3_exp(axis_angle);
  return {rotation, center - rotation * center};
}

Rigid3d align_points(const Eigen::Matrix3Xd& points_in_a, const Eigen::Matrix3Xd& points_in_b) {
  if (points_in_a.cols() != points_in_b.cols() || points_in_a.cols() < 3) {
    throw Error("aligning points: got ", points_in_a.cols(), " and ", points_in_b.cols(),
                ", expected equally many, at least 3");
  }
  const Eigen::Vector3d mean_a = points_in_a.rowwise().mean();
  const Eigen::Vector3d mean_b = points_in_b.rowwise().mean();
  const Eigen::Matrix3d covariance =
      (points_in_b.colwise() - mean_b) * (points_in_a.colwise() - mean_a).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs(1.0, 1.0, 1.0);
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0) signs.z() = -1.0;
  const Eigen::Matrix3d rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  return {Eigen::Quaterniond(rotation), mean_b - rotation * mean_a};
}

}  // namespace tegata
