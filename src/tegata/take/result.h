// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tegata/hand/hand_model.h"
#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// What the fit says of one frame; docs/formats.md says what each means. `pose`, keypoints,
/// support, views and overlaps mean something only where the status is "ok" or a doubt about a pose
/// that was found; `pose` is empty where none was found.
struct ResultFrame {
  std::string name;
  double time = 0.0;          ///< [s]
  std::string status = "ok";  ///< "ok", or why there is no (reliable) pose
  std::optional<HandPose> pose;
  std::array<Eigen::Vector3d, kKeypointCount> keypoints;  ///< world [m]
  std::array<double, kBoneCount> support = {};            ///< 0 .. 1 a bone
  std::vector<std::string> views;                         ///< cameras used
  std::map<std::string, double> silhouette_iou;           ///< by camera
  std::map<std::string, double> uncovered;                ///< by camera, where it can be said [m]
  std::map<std::string, std::string> left_out;            ///< why, by camera that was not used
};

/// Where a fit began without being told where the hand is.
struct ResultStart {
  std::string frame;
  /// The energy of the next best pose elsewhere over that of the one chosen: near 1 nothing is
  /// proven. Infinite where all that was tried has come to the same place.
  double lead = std::numeric_limits<double>::infinity();
};

/// result.json in memory; see docs/formats.md.
struct Result {
  std::string take;
  Side side = Side::right;
  std::string model_name;
  std::map<std::string, double> model_shape;
  double model_scale = 1.0;                                     ///< of the hand that was asked for
  std::optional<double> model_scale_standard_deviation;         ///< where it was estimated
  JointAngles grasp_angles = JointAngles::Zero();               ///< [rad]
  JointAngles grasp_standard_deviations = JointAngles::Zero();  ///< [rad]
  std::vector<ResultFrame> frames;
  /// What hides the hand without being seen, in the hand's frame [m], and how sure each vertex is;
  /// empty where nothing was found. Not part of result.json.
  TriangleMesh object;
  std::vector<float> object_confidence;
  std::optional<ResultStart> start;
  int iterations = 0;
  std::string termination;
  std::map<std::string, double> seconds;  ///< by stage
};

/// Writes result.json. The same Result gives the same bytes.
void write_result_json(const Result& result, const std::filesystem::path& file);

/// Reads result.json. Throws Error naming file and key for anything missing or of another shape or
/// version.
Result read_result_json(const std::filesystem::path& file);

/// Writes angles.csv: one row a frame, 20 columns in degrees; empty cells where there is no pose.
void write_angles_csv(const Result& result, const std::filesystem::path& file);

}  // namespace tegata
