// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/evaluate/keypoint_error.h"

#include <Eigen/Geometry>
#include <cmath>

namespace tegata {
namespace {

using Points = Eigen::Matrix<double, 3, kKeypointCount>;

Points columns(const Keypoints& keypoints) {
  Points points;
  for (int i = 0; i < kKeypointCount; ++i) points.col(i) = keypoints[static_cast<std::size_t>(i)];
  return points;
}

double mean_distance(const Points& a, const Points& b) { return (a - b).colwise().norm().mean(); }

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

double keypoint_error(const Keypoints& fitted, const Keypoints& truth) {
  return mean_distance(columns(fitted), columns(truth));
}

double root_relative_keypoint_error(const Keypoints& fitted, const Keypoints& truth) {
  return mean_distance(columns(fitted).colwise() - fitted[0], columns(truth).colwise() - truth[0]);
}

double procrustes_keypoint_error(const Keypoints& fitted, const Keypoints& truth) {
  const Points from = columns(fitted), to = columns(truth);
  const Eigen::Matrix4d truth_from_fitted = Eigen::umeyama(from, to, true);
  return mean_distance((truth_from_fitted * from.colwise().homogeneous()).topRows<3>(), to);
}

std::array<double, 15> bone_angles(const Keypoints& keypoints) {
  std::array<double, 15> angles;
  std::size_t next = 0;
  for (std::size_t digit = 0; digit < kDigitCount; ++digit) {
    Eigen::Vector3d start = keypoints[0], before = Eigen::Vector3d::Zero();
    for (std::size_t joint = 0; joint < 4; ++joint) {
      const Eigen::Vector3d& end = keypoints[1 + 4 * digit + joint];
      const Eigen::Vector3d bone = end - start;
      if (joint > 0) angles[next++] = angle_between(before, bone);
      before = bone;
      start = end;
    }
  }
  return angles;
}

double flexion_error(const Keypoints& fitted, const Keypoints& truth) {
  const auto a = bone_angles(fitted), b = bone_angles(truth);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
  return sum / static_cast<double>(a.size());
}

}  // namespace tegata
