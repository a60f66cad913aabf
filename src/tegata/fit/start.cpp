// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/start.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "tegata/base/angle.h"
#include "tegata/base/error.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

// Thumb: CMC abduction, CMC flexion, MCP, IP; fingers: MCP abduction, MCP, PIP, DIP flexion [deg].
JointAngles angles_of(const std::array<double, 4>& thumb, const std::array<double, 3>& flexion) {
  JointAngles angles = JointAngles::Zero();
  for (int k = 0; k < 4; ++k) angles[k] = thumb[static_cast<std::size_t>(k)];
  for (int digit = 1; digit < kDigitCount; ++digit) {
    for (int k = 0; k < 3; ++k) angles[4 * digit + 1 + k] = flexion[static_cast<std::size_t>(k)];
  }
  return angles * kDegree;
}

constexpr double kHandLength = 0.18;  // of a hand of scale 1, wrist to the middle fingertip [m]
constexpr double kEdgePx = 4.0;       // a hull point that projects so near to it touches the edge

Eigen::Vector3d mean_of(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

bool is_cut_off(const Eigen::Vector3d& point, const std::vector<FitView>& views) {
  return std::any_of(views.begin(), views.end(), [&](const FitView& view) {
    const auto pixel = project(view.camera, point);
    return pixel && (pixel->x() < kEdgePx || pixel->y() < kEdgePx ||
                     pixel->x() > view.camera.width - 1 - kEdgePx ||
                     pixel->y() > view.camera.height - 1 - kEdgePx);
  });
}

HullEnd end_away_from(const Eigen::Vector3d& root, const std::vector<Eigen::Vector3d>& points,
                      double scale) {
  HullEnd end;
  end.tip = *std::max_element(points.begin(), points.end(),
                              [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
                                return (a - root).squaredNorm() < (b - root).squaredNorm();
                              });
  const auto within = [&](double distance) {
    std::vector<Eigen::Vector3d> near;
    std::copy_if(points.begin(), points.end(), std::back_inserter(near),
                 [&](const Eigen::Vector3d& p) { return (p - end.tip).norm() < distance * scale; });
    return mean_of(near);
  };
  end.center = within(kHandLength);
  // The forearm, where it is seen, gives the direction; the hand itself otherwise.
  end.direction = (end.center - within(2.0 * kHandLength)).normalized();
  if (!end.direction.allFinite() || end.direction.norm() < 0.5) {
    end.direction = (end.tip - root).normalized();
  }
  return end;
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

std::vector<HullEnd> hand_ends(const FitHand& hand, const FitFrame& frame) {
  if (!frame.hull) throw Error("start: got a frame without a hull, expected one");
  const std::vector<Eigen::Vector3d>& points = frame.hull->nearest.points();
  std::vector<Eigen::Vector3d> cut;
  for (const std::vector<Eigen::Vector3d>* some : {&points, &frame.hull->unproven}) {
    std::copy_if(some->begin(), some->end(), std::back_inserter(cut),
                 [&](const Eigen::Vector3d& point) { return is_cut_off(point, frame.views); });
  }
  if (!cut.empty()) return {end_away_from(mean_of(cut), points, hand.scale)};

  const Eigen::Vector3d mean = mean_of(points);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& point : points) {
    covariance += (point - mean) * (point - mean).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance);
  const Eigen::Vector3d half_length = 2.0 * hand.scale * kHandLength * axes.eigenvectors().col(2);
  return {end_away_from(mean - half_length, points, hand.scale),
          end_away_from(mean + half_length, points, hand.scale)};
}

std::vector<Rigid3d> poses_at_ends(const FitHand& hand, const std::vector<HullEnd>& ends) {
  // Half way along the hand, which the knuckle of the middle finger is near.
  const Eigen::Vector3d center_in_hand = hand.model->skeleton.keypoints[kMiddleMcp];
  constexpr int kRolls = 12;
  constexpr double kTilt = 0.6;  // [rad]
  std::vector<Rigid3d> poses;
  for (const HullEnd& end : ends) {
    const auto along = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitY(), end.direction);
    for (int roll = 0; roll < kRolls; ++roll) {
      const double angle = 2.0 * std::numbers::pi * roll / kRolls;
      const Eigen::Quaterniond rolled = along * so3_exp({0.0, angle, 0.0});
      for (const Eigen::Vector3d& tilt :
           {Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(kTilt, 0.0, 0.0),
            Eigen::Vector3d(-kTilt, 0.0, 0.0)}) {
        const Eigen::Quaterniond rotation = rolled * so3_exp(tilt);
        poses.push_back({rotation, end.center - rotation * center_in_hand});
      }
    }
  }
  return poses;
}

std::vector<HandPose> starts_from_nothing(const FitHand& hand, const FitFrame& frame,
                                          const std::vector<JointAngles>& angles) {
  const std::vector<Rigid3d> poses =
      frame.landmarks
          ? std::vector<Rigid3d>{pose_from_landmarks(hand.model->skeleton, *frame.landmarks)}
          : poses_at_ends(hand, hand_ends(hand, frame));
  std::vector<HandPose> starts;
  for (const Rigid3d& pose : poses) {
    for (const JointAngles& bent : angles) starts.push_back({pose, bent});
  }
  return starts;
}

}  // namespace tegata
