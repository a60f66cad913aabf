// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <tiny_gltf.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>

#include "tegata/base/error.h"
#include "tegata/gltf/gltf_file.h"
#include "tegata/gltf/hand_gltf.h"
#include "tegata/gltf/skinned_surface.h"
#include "tegata/hand/skeleton_from_keypoints.h"

namespace tegata {
namespace {

constexpr double kSamePlace = 0.001;  // [m]: to which the file's joints must agree with its notes

/// The numbers under a key of what write_hand_gltf notes of the skeleton; empty if they are not
/// `count` numbers.
std::vector<double> noted_numbers(const tinygltf::Value& notes, const char* key,
                                  std::size_t count) {
  std::vector<double> numbers;
  if (!notes.Has(key) || !notes.Get(key).IsArray()) return {};
  const tinygltf::Value& list = notes.Get(key);
  for (std::size_t i = 0; i < list.ArrayLen(); ++i) {
    numbers.push_back(list.Get(static_cast<int>(i)).GetNumberAsDouble());
  }
  return numbers.size() == count ? numbers : std::vector<double>();
}

/// The skeleton that write_hand_gltf has noted in the file, where its joints are still there.
std::optional<FoundSkeleton> noted_skeleton(
    const tinygltf::Model& model, const std::array<Eigen::Vector3d, kKeypointCount>& keypoints,
    Side side) {
  if (!model.asset.extras.IsObject() || !model.asset.extras.Has("tegata_hand")) return {};
  const tinygltf::Value& notes = model.asset.extras.Get("tegata_hand");
  if (!notes.IsObject() || !notes.Has("side") || !notes.Get("side").IsString()) return {};
  const auto points = noted_numbers(notes, "keypoints", 3 * kKeypointCount);
  const auto axes = noted_numbers(notes, "axes", 3 * kAngleCount);
  const auto angles = noted_numbers(notes, "rest_angles", kAngleCount);
  if (points.empty() || axes.empty() || angles.empty()) return {};
  if (notes.Get("side").Get<std::string>() != side_name(side)) {
    throw Error("it holds a ", notes.Get("side").Get<std::string>(), " hand, expected a ",
                side_name(side), " one");
  }
  FoundSkeleton found;
  found.skeleton.side = side;
  for (std::size_t k = 0; k < kKeypointCount; ++k) {
    found.skeleton.keypoints[k] = Eigen::Map<const Eigen::Vector3d>(&points[3 * k]);
  }
  for (std::size_t a = 0; a < kAngleCount; ++a) {
    found.skeleton.axes[a] = Eigen::Map<const Eigen::Vector3d>(&axes[3 * a]).normalized();
  }
  found.angles = Eigen::Map<const JointAngles>(angles.data());
  const auto expected = posed_keypoints(found.skeleton, {Rigid3d(), found.angles});
  found.source_from_hand =
      align_points(Eigen::Map<const Eigen::Matrix3Xd>(expected[0].data(), 3, kKeypointCount),
                   Eigen::Map<const Eigen::Matrix3Xd>(keypoints[0].data(), 3, kKeypointCount));
  for (std::size_t k = 0; k < kKeypointCount; ++k) {
    const double apart = (found.source_from_hand * expected[k] - keypoints[k]).norm();
    if (!(apart < kSamePlace)) return {};
  }
  return found;
}

HandModel hand_of(const tinygltf::Model& file, const NodeTree& tree, const HandJoints& joints,
                  Side side) {
  SkinnedSurface read = skinned_surface(file, tree, joints);
  std::array<Eigen::Vector3d, kKeypointCount> keypoints;
  for (std::size_t i = 0; i < kWebxrJointCount; ++i) {
    const int keypoint = webxr_joints()[i].keypoint;
    if (keypoint >= 0) keypoints[static_cast<std::size_t>(keypoint)] = read.joints[i];
  }
  std::optional<FoundSkeleton> found = noted_skeleton(file, keypoints, side);
  if (!found) found = skeleton_from_keypoints(keypoints, side);

  HandModel model;
  model.skeleton = found->skeleton;
  model.rest_angles = found->angles;
  model.rest_surface = std::move(read.surface);
  model.links = std::move(read.links);
  const Rigid3d hand_from_source = found->source_from_hand.inverse();
  for (Eigen::Vector3d& vertex : model.rest_surface.vertices) vertex = hand_from_source * vertex;
  model.rest_surface.normals = vertex_normals(model.rest_surface);
  return model;
}

/// The first hand of the file that can be the one of that side.
HandModel hand_of_side(const tinygltf::Model& file, Side side) {
  const NodeTree tree = node_tree(file);
  const std::vector<HandJoints> hands = hands_in(file, tree);
  for (std::size_t i = 0;; ++i) {
    try {
      return hand_of(file, tree, hands[i], side);
    } catch (const Error&) {
      if (i + 1 == hands.size()) throw;
    }
  }
}

HandModel hand_in(std::string_view bytes, Side side, const std::filesystem::path& file,
                  const std::optional<std::filesystem::path>& folder) {
  try {
    HandModel model = hand_of_side(load_gltf(bytes, folder), side);
    model.name = file.stem().string();
    check_hand(model);
    return model;
  } catch (const Error& problem) {
    throw Error(file.string(), ": ", problem.what());
  }
}

}  // namespace

HandModel read_hand_gltf(const std::filesystem::path& file, Side side) {
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) throw Error(file.string(), ": cannot be opened or read");
  return hand_in(bytes, side, file, file.parent_path());
}

HandModel parse_hand_gltf(std::string_view bytes, Side side, const std::string& name) {
  return hand_in(bytes, side, name, std::nullopt);
}

}  // namespace tegata
