// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// A hand for the room's own tests, made by hand so that they do not lean on the built-in one.
#pragma once

#include <algorithm>

#include "tegata/base/random.h"
#include "tegata/hand/hand_model.h"
#include "tegata/math/so3.h"

namespace tegata {

/// A right hand: straight fingers a little fanned, the thumb at 45 degrees.
inline Skeleton test_skeleton() {
  Skeleton skeleton;
  skeleton.keypoints[0].setZero();
  for (int digit = 0; digit < kDigitCount; ++digit) {
    const auto first = static_cast<std::size_t>(1 + 4 * digit);
    const auto axis = static_cast<std::size_t>(4 * digit);
    const double fan = digit == 0 ? -0.8 : 0.08 * (digit - 2);
    const Eigen::Vector3d along(std::sin(fan), std::cos(fan), 0.0), back(0.0, 0.0, 1.0);
    skeleton.keypoints[first] = digit == 0 ? Eigen::Vector3d(-0.02, 0.02, -0.005)
                                           : Eigen::Vector3d(0.022 * (digit - 2), 0.09, 0.002);
    for (std::size_t i = 1; i < 4; ++i) {
      skeleton.keypoints[first + i] =
          skeleton.keypoints[first + i - 1] + along * (0.05 - 0.009 * static_cast<double>(i));
    }
    const Eigen::Vector3d across = back.cross(along);  // turns along towards the palm
    for (std::size_t i = 1; i < 4; ++i) skeleton.axes[axis + i] = across;
    skeleton.axes[axis] = digit == 0 ? across : digit <= 2 ? back : Eigen::Vector3d(-back);
    if (digit == 0) {
      for (std::size_t i = 1; i < 4; ++i) skeleton.axes[i] = (across * 0.4 - back).normalized();
    }
  }
  return skeleton;
}

/// Uniform within the limits.
inline JointAngles random_angles(std::uint64_t seed) {
  Random random(seed);
  JointAngles angles;
  for (int angle = 0; angle < kAngleCount; ++angle) {
    angles[angle] = random.uniform(angle_limits().lower[angle], angle_limits().upper[angle]);
  }
  return angles;
}

/// test_skeleton() with an octahedron around each bone's middle and joints' mixtures on it.
inline HandModel test_hand() {
  HandModel model;
  model.name = "test";
  model.skeleton = test_skeleton();
  model.rest_angles = 0.3 * relaxed_angles();
  for (int bone = 0; bone < kBoneCount; ++bone) {
    const auto near = static_cast<std::size_t>(proximal_keypoint(bone));
    const Eigen::Vector3d center =
        0.5 * (model.skeleton.keypoints[near] + model.skeleton.keypoints[bone == 0 ? 9 : near + 1]);
    const auto first = static_cast<std::uint32_t>(model.rest_surface.vertices.size());
    for (int i = 0; i < 6; ++i) {
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      normal[i / 2] = i % 2 == 0 ? 1.0 : -1.0;
      model.rest_surface.normals.push_back(normal);
      model.rest_surface.vertices.push_back(center + 0.01 * normal);
      SkinLinks links;
      links.bones = {bone, std::max(parent_bone(bone), 0), 0, 0};
      links.weights = {1.0 - 0.1 * i, 0.1 * i, 0.0, 0.0};
      model.links.push_back(links);
    }
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      const std::uint32_t x = octant & 1U, y = octant >> 1U & 1U, z = octant >> 2U;
      Triangle triangle = {first + x, first + 2 + y, first + 4 + z};
      if ((x + y + z) % 2 == 1) std::swap(triangle[1], triangle[2]);
      model.rest_surface.triangles.push_back(triangle);
    }
  }
  return model;
}

/// test_hand() with some vertices that several digits pull at, as in hands of others' making.
inline HandModel tangled_hand() {
  HandModel model = test_hand();
  model.name = "tangled";
  for (std::size_t vertex = 0; vertex < model.links.size(); vertex += 7) {
    const int bone = model.links[vertex].bones[0];
    model.links[vertex].bones = {bone, 0, (bone + 4) % kBoneCount, (bone + 9) % kBoneCount};
    model.links[vertex].weights = {0.4, 0.1, 0.3, 0.2};
  }
  return model;
}

/// Both hands, and all kinds of links.
inline std::vector<HandModel> hands_to_check() {
  std::vector<HandModel> hands = {test_hand(), tangled_hand()};
  hands.push_back(mirrored(hands[1]));
  return hands;
}

inline HandPose random_pose(std::uint64_t seed) {
  Random random(seed + 100);
  HandPose pose;
  pose.world_from_hand.rotation =
      so3_exp({random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)});
  pose.world_from_hand.translation = {random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 0.8};
  pose.angles = random_angles(seed);
  return pose;
}

/// Poses at rest, almost at rest and anywhere.
inline std::vector<HandPose> poses_to_check(const HandModel& model) {
  std::vector<HandPose> poses(2);
  poses[0].angles = model.rest_angles;
  poses[1].angles = (model.rest_angles.array() + 1e-5).matrix();
  poses[1].world_from_hand.rotation = so3_exp({1e-6, -1e-7, 0.0});
  for (std::uint64_t seed = 0; seed < 3; ++seed) poses.push_back(random_pose(seed));
  return poses;
}

}  // namespace tegata
