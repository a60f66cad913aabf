// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/start.h"

#include <cmath>
#include <numbers>

#include "tegata/base/error.h"

namespace tegata {
namespace {

constexpr int kWrist = 0, kIndexMcp = 5, kMiddleMcp = 9, kLittleMcp = 17;

// Thumb: CMC abduction, CMC flexion, MCP, IP; fingers: MCP abduction, MCP, PIP, DIP flexion [deg].
JointAngles angles_of(const std::array<double, 4>& thumb, const std::array<double, 3>& flexion) {
  JointAngles angles = JointAngles::Zero();
  for (int k = 0; k < 4; ++k) angles[k] = thumb[static_cast<std::size_t>(k)];
  for (int digit = 1; digit < kDigitCount; ++digit) {
    for (int k = 0; k < 3; ++k) angles[4 * digit + 1 + k] = flexion[static_cast<std::size_t>(k)];
  }
  return angles * (std::numbers::pi / 180.0);
}

}  // namespace

std::vector<JointAngles> typical_angles() {
  return {relaxed_angles(), angles_of({15.0, 5.0, 10.0, 10.0}, {5.0, 10.0, 5.0}),
          angles_of({40.0, 20.0, 20.0, 20.0}, {45.0, 45.0, 25.0})};
}

Rigid3d pose_from_landmarks(const Skeleton& skeleton, const StartLandmarks& landmarks) {
  Eigen::Matrix3Xd in_hand(3, 3), in_world(3, 3);
  in_hand << skeleton.keypoints[kWrist], skeleton.keypoints[kIndexMcp],
      skeleton.keypoints[kLittleMcp];
  in_world << landmarks.wrist, landmarks.index_mcp, landmarks.little_mcp;
  return align_points(in_hand, in_world);
}

std::vector<Rigid3d> poses_around(const Skeleton& skeleton, const TriangleMesh& hull, int count) {
  if (hull.vertices.empty()) throw Error("start: got a hull without vertices, expected a surface");
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& vertex : hull.vertices) center += vertex;
  center /= static_cast<double>(hull.vertices.size());

  // The two irrational steps of the spiral: the square root of two and the positive root of
  // x^4 = x + 4.
  const double phi = std::numbers::sqrt2, psi = 1.533751168755204288118041;
  std::vector<Rigid3d> poses;
  poses.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double s = i + 0.5, t = s / count, d = 2.0 * std::numbers::pi * s;
    const double r = std::sqrt(t), big_r = std::sqrt(1.0 - t);
    const double alpha = d / phi, beta = d / psi;
    const Eigen::Quaterniond rotation(big_r * std::cos(beta), r * std::sin(alpha),
                                      r * std::cos(alpha), big_r * std::sin(beta));
    poses.push_back({rotation, center - rotation * skeleton.keypoints[kMiddleMcp]});
  }
  return poses;
}

}  // namespace tegata
