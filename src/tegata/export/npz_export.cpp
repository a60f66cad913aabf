// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/npz_export.h"

#include <limits>
#include <memory>

#include "tegata/export/npz_file.h"
#include "tegata/hand/skin_rows.h"

namespace tegata {
namespace {

template <typename Names>
std::vector<std::string> strings(const Names& names) {
  return {names.begin(), names.end()};
}

/// An array with a row a frame; rows of frames without a pose are NaN.
template <typename Number>
class FrameRows {
 public:
  FrameRows(std::size_t frame_count, std::size_t width)
      : width_(width), numbers_(frame_count * width, std::numeric_limits<Number>::quiet_NaN()) {}

  /// Puts the next numbers of a frame's row.
  template <typename Numbers>
  void put(std::size_t frame, const Numbers& numbers) {
    if (frame != frame_) filled_ = 0;
    frame_ = frame;
    for (const double number : numbers) {
      numbers_[frame * width_ + filled_++] = static_cast<Number>(number);
    }
  }
  const std::vector<Number>& numbers() const { return numbers_; }

 private:
  std::size_t width_, frame_ = 0, filled_ = 0;
  std::vector<Number> numbers_;
};

void add_frames(const Result& result, NpzFile& file) {
  const std::size_t count = result.frames.size();
  std::vector<std::string> names, statuses;
  std::vector<double> times;
  std::vector<bool> has_pose;
  FrameRows<double> rotations(count, 4), translations(count, 3), angles(count, kAngleCount),
      keypoints(count, 3 * kKeypointCount), supports(count, kBoneCount);
  for (std::size_t i = 0; i < count; ++i) {
    const ResultFrame& frame = result.frames[i];
    names.push_back(frame.name);
    statuses.push_back(frame.status);
    times.push_back(frame.time);
    has_pose.push_back(frame.pose.has_value());
    if (!frame.pose) continue;
    const Eigen::Quaterniond& turn = frame.pose->world_from_hand.rotation;
    const double sign = turn.w() < 0.0 ? -1.0 : 1.0;  // as result.json has it
    rotations.put(i,
                  Eigen::Vector4d(sign * Eigen::Vector4d(turn.w(), turn.x(), turn.y(), turn.z())));
    translations.put(i, frame.pose->world_from_hand.translation);
    angles.put(i, frame.pose->angles);
    for (const Eigen::Vector3d& keypoint : frame.keypoints) keypoints.put(i, keypoint);
    supports.put(i, frame.support);
  }
  file.add("frame", names);
  file.add("time", {count}, times);
  file.add("status", statuses);
  file.add("has_pose", {count}, has_pose);
  file.add("rotation", {count, 4}, rotations.numbers());
  file.add("translation", {count, 3}, translations.numbers());
  file.add("angles", {count, kAngleCount}, angles.numbers());
  file.add("keypoints", {count, kKeypointCount, 3}, keypoints.numbers());
  file.add("support", {count, kBoneCount}, supports.numbers());
}

void add_surface(const Result& result, const HandModel& hand, NpzFile& file) {
  const std::size_t count = result.frames.size();
  const TriangleMesh& surface = hand.rest_surface;
  const auto rows = std::make_shared<const SkinRows>(hand);
  FrameRows<float> vertices(count, 3 * surface.vertices.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (!result.frames[i].pose) continue;
    const PosedHand posed(hand, *result.frames[i].pose, rows);
    for (const Eigen::Vector3d& vertex : posed.vertices()) vertices.put(i, vertex);
  }
  std::vector<std::int32_t> corners;
  for (const Triangle& triangle : surface.triangles) {
    for (const std::uint32_t corner : triangle) {
      corners.push_back(static_cast<std::int32_t>(corner));
    }
  }
  file.add("vertices", {count, surface.vertices.size(), 3}, vertices.numbers());
  file.add("triangles", {surface.triangles.size(), 3}, corners);
}

}  // namespace

std::string npz_bytes(const Result& result, const HandModel& hand) {
  NpzFile file;
  file.add("joint_names", strings(angle_names()));
  file.add("keypoint_names", strings(keypoint_names()));
  file.add("bone_names", strings(bone_names()));
  const JointAngles& angles = result.grasp_angles;
  const JointAngles& deviations = result.grasp_standard_deviations;
  file.add("grasp_angles", {kAngleCount}, std::vector<double>(angles.begin(), angles.end()));
  file.add("grasp_standard_deviations", {kAngleCount},
           std::vector<double>(deviations.begin(), deviations.end()));
  add_frames(result, file);
  add_surface(result, hand, file);
  return file.bytes();
}

}  // namespace tegata
