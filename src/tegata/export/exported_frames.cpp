// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/exported_frames.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "tegata/base/error.h"

namespace tegata {
namespace {

/// The same direction as an angle, within half a turn of another angle.
double next_to(double angle, double other) {
  return other + std::remainder(angle - other, 2.0 * std::numbers::pi);
}

/// Angles z, y, x of a rotation whose z is given.
Eigen::Vector3d angles_after_z(const Eigen::Matrix3d& rotation, double z,
                               const Eigen::Vector3d& before) {
  using Turn = Eigen::AngleAxisd;
  const Eigen::Matrix3d yx = Turn(-z, Eigen::Vector3d::UnitZ()) * rotation;
  const double y = std::atan2(-yx(2, 0), yx(0, 0));
  const Eigen::Matrix3d x = Turn(-y, Eigen::Vector3d::UnitY()) * yx;
  return {next_to(z, before[0]), next_to(y, before[1]),
          next_to(std::atan2(x(2, 1), x(1, 1)), before[2])};
}

}  // namespace

Rigid3d y_up_from_world() {
  return {Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0), Eigen::Vector3d::Zero()};
}

double frame_interval(const Result& result) {
  constexpr double kInterval = 1.0 / 30.0;
  if (result.frames.size() < 2) return kInterval;
  const double interval = (result.frames.back().time - result.frames.front().time) /
                          static_cast<double>(result.frames.size() - 1);
  return interval > 0.0 ? interval : kInterval;
}

std::vector<const HandPose*> held_poses(const Result& result) {
  std::vector<const HandPose*> poses(result.frames.size(), nullptr);
  const HandPose* held = nullptr;
  for (const ResultFrame& frame : result.frames) {
    if (held == nullptr && frame.pose) held = &*frame.pose;
  }
  if (held == nullptr) throw Error("result of '", result.take, "': no frame has a pose");
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (result.frames[i].pose) held = &*result.frames[i].pose;
    poses[i] = held;
  }
  return poses;
}

void check_fitted_hand(const Result& result, const HandModel& hand) {
  constexpr double kTolerance = 1e-4;  // [m]
  if (hand.skeleton.side != result.side) {
    throw Error("hand '", hand.name, "': got a ", side_name(hand.skeleton.side),
                " one, expected the ", side_name(result.side), " one that was fitted");
  }
  for (const ResultFrame& frame : result.frames) {
    if (!frame.pose) continue;
    const auto keypoints = posed_keypoints(hand.skeleton, *frame.pose);
    for (std::size_t k = 0; k < keypoints.size(); ++k) {
      const double off = (keypoints[k] - frame.keypoints[k]).norm();
      if (off <= kTolerance) continue;
      throw Error("hand '", hand.name, "': its ", keypoint_names()[k], " is ",
                  decimal(1e3 * off, 2), " mm from the result's in frame ", frame.name,
                  ", expected the hand '", result.model_name, "' that was fitted");
    }
  }
}

Eigen::Vector3d zyx_angles(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& before) {
  constexpr double kParallel = 1e-9;
  const Eigen::Matrix3d matrix = rotation.toRotationMatrix();
  // With y a quarter turn, z and x turn about the same line: z stays what it was.
  if (std::hypot(matrix(0, 0), matrix(1, 0)) < kParallel) {
    return angles_after_z(matrix, before[0], before);
  }
  const double z = std::atan2(matrix(1, 0), matrix(0, 0));
  const Eigen::Vector3d one = angles_after_z(matrix, z, before);
  const Eigen::Vector3d other = angles_after_z(matrix, z + std::numbers::pi, before);
  return (one - before).squaredNorm() <= (other - before).squaredNorm() ? one : other;
}

std::string decimal(double number, int decimals) {
  std::string written = fmt::format("{:.{}f}", number, decimals);
  if (written.front() == '-' && written.find_first_not_of("-0.") == std::string::npos) {
    written.erase(0, 1);
  }
  return written;
}

std::string csv_cell(const std::string& content) {
  if (content.find_first_of(",\"\r\n") == std::string::npos) return content;
  std::string quoted = "\"";
  for (const char c : content) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace tegata
