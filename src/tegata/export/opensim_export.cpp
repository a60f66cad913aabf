// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/opensim_export.h"

#include <fmt/format.h>

#include "tegata/base/angle.h"
#include "tegata/export/exported_frames.h"

namespace tegata {
namespace {

constexpr double kMillimetres = 1000.0;
constexpr int kPoseColumns = 6;

/// A name that holds no tab or line break, which would end a cell.
std::string plain_name(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) < ' ') c = '_';
  }
  return name;
}

}  // namespace

std::string trc_text(const Result& result) {
  const std::string rate = decimal(1.0 / frame_interval(result), 6);
  const std::size_t count = result.frames.size();
  std::string file = fmt::format("PathFileType\t4\t(X/Y/Z)\t{}.trc\n", plain_name(result.take));
  file +=
      "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\tOrigDataStartFrame\t"
      "OrigNumFrames\n";
  file += fmt::format("{}\t{}\t{}\t{}\tmm\t{}\t1\t{}\n", rate, rate, count, kKeypointCount, rate,
                      count);
  std::string names = "Frame#\tTime", axes = "\t";
  for (std::size_t k = 0; k < kKeypointCount; ++k) {
    names += fmt::format("\t{}\t\t", keypoint_names()[k]);
    axes += fmt::format("\tX{0}\tY{0}\tZ{0}", k + 1);
  }
  file += names + "\n" + axes + "\n\n";
  for (std::size_t i = 0; i < count; ++i) {
    const ResultFrame& frame = result.frames[i];
    file += fmt::format("{}\t{}", i + 1, decimal(frame.time, 6));
    for (const Eigen::Vector3d& keypoint : frame.keypoints) {
      const Eigen::Vector3d place = kMillimetres * (y_up_from_world() * keypoint);
      for (int axis = 0; axis < 3; ++axis) {
        file += "\t";
        if (frame.pose) file += decimal(place[axis], 5);
      }
    }
    file += "\n";
  }
  return file;
}

std::string mot_text(const Result& result) {
  std::string file = plain_name(result.take) + "\nversion=1\n";
  file += fmt::format("nRows={}\nnColumns={}\ninDegrees=yes\nendheader\n", result.frames.size(),
                      1 + kPoseColumns + kAngleCount);
  file += "time\thand_tx\thand_ty\thand_tz\thand_rz\thand_ry\thand_rx";
  for (const std::string_view name : angle_names()) file += fmt::format("\t{}", name);
  file += "\n";
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  for (const ResultFrame& frame : result.frames) {
    file += decimal(frame.time, 6);
    if (!frame.pose) {
      for (int i = 0; i < kPoseColumns + kAngleCount; ++i) file += "\tNaN";
      file += "\n";
      continue;
    }
    const Rigid3d y_up_from_hand = y_up_from_world() * frame.pose->world_from_hand;
    turn = zyx_angles(y_up_from_hand.rotation, turn);
    for (int i = 0; i < 3; ++i)
      file += fmt::format("\t{}", decimal(y_up_from_hand.translation[i], 8));
    for (int i = 0; i < 3; ++i)
      file += fmt::format("\t{}", decimal(kDegreesPerRadian * turn[i], 6));
    for (int i = 0; i < kAngleCount; ++i) {
      file += fmt::format("\t{}", decimal(kDegreesPerRadian * frame.pose->angles[i], 6));
    }
    file += "\n";
  }
  return file;
}

}  // namespace tegata
