// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/csv_export.h"

#include <fmt/format.h>

#include <set>

#include "tegata/export/exported_frames.h"

namespace tegata {
namespace {

std::set<std::string> cameras_of(const Result& result) {
  std::set<std::string> cameras;
  for (const ResultFrame& frame : result.frames) {
    for (const auto& [camera, overlap] : frame.silhouette_iou) cameras.insert(camera);
  }
  return cameras;
}

std::string header(const std::set<std::string>& cameras) {
  std::string line =
      "frame,time_s,status,hand_x_m,hand_y_m,hand_z_m,hand_qw,hand_qx,hand_qy,hand_qz";
  for (const std::string_view name : angle_names()) line += fmt::format(",{}_rad", name);
  for (const std::string_view name : keypoint_names()) {
    line += fmt::format(",{0}_x_m,{0}_y_m,{0}_z_m", name);
  }
  for (const std::string_view name : bone_names()) line += fmt::format(",{}_support", name);
  for (const std::string& camera : cameras) line += fmt::format(",{}", csv_cell(camera + "_iou"));
  return line + "\n";
}

std::string pose_cells(const ResultFrame& frame, const std::set<std::string>& cameras) {
  std::string cells;
  const auto add = [&cells](double number) { cells += fmt::format(",{}", decimal(number, 8)); };
  const Rigid3d& place = frame.pose->world_from_hand;
  const double sign = place.rotation.w() < 0.0 ? -1.0 : 1.0;  // as result.json has it
  for (int i = 0; i < 3; ++i) add(place.translation[i]);
  add(sign * place.rotation.w());
  for (int i = 0; i < 3; ++i) add(sign * place.rotation.vec()[i]);
  for (int i = 0; i < kAngleCount; ++i) add(frame.pose->angles[i]);
  for (const Eigen::Vector3d& keypoint : frame.keypoints) {
    for (int i = 0; i < 3; ++i) add(keypoint[i]);
  }
  for (const double support : frame.support) add(support);
  for (const std::string& camera : cameras) {
    const auto overlap = frame.silhouette_iou.find(camera);
    if (overlap == frame.silhouette_iou.end()) {
      cells += ",";
    } else {
      add(overlap->second);
    }
  }
  return cells;
}

}  // namespace

std::string csv_text(const Result& result) {
  const std::set<std::string> cameras = cameras_of(result);
  std::string table = header(cameras);
  // Camera names may hold commas of their own.
  const std::size_t columns = 7 + kAngleCount + 3 * kKeypointCount + kBoneCount + cameras.size();
  const std::string no_pose(columns, ',');
  for (const ResultFrame& frame : result.frames) {
    table += csv_cell(frame.name) + "," + decimal(frame.time, 6) + "," + csv_cell(frame.status);
    table += (frame.pose ? pose_cells(frame, cameras) : no_pose) + "\n";
  }
  return table;
}

}  // namespace tegata
