// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/built_in_hand.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "tegata/base/error.h"
#include "tegata/hand/hand_solid.h"
#include "tegata/hand/test_hand.h"

namespace tegata {
namespace {

const HandModel& mean_hand() {
  static const HandModel model = built_in_hand(HandShape(), Side::right);
  return model;
}

HandPose flat() { return {}; }

TEST(BuiltInHand, SurfaceIsClosedOnePieceWithoutHandles) {
  const MeshTopology topology = inspect_topology(mean_hand().rest_surface);
  EXPECT_TRUE(topology.closed);
  EXPECT_TRUE(topology.oriented);
  EXPECT_TRUE(topology.manifold);
  EXPECT_EQ(topology.component_count, 1);
  EXPECT_EQ(topology.euler_number, 2) << "fingers have grown together";
  EXPECT_GT(enclosed_volume(mean_hand().rest_surface), 0.0) << "inside out";
}

TEST(BuiltInHand, SizesAreThoseOfTheShape) {
  for (const auto& [length, breadth] : {std::pair(0.189, 0.084), std::pair(0.172, 0.075)}) {
    HandShape shape;
    shape.length = length;
    shape.palm_breadth = breadth;
    const HandModel model = built_in_hand(shape, Side::right);
    const PosedHand hand(model, flat());
    Eigen::AlignedBox3d knuckles, all, wrist;
    for (std::size_t i = 0; i < hand.vertices().size(); ++i) {
      const Eigen::Vector3d& vertex = hand.vertices()[i];
      all.extend(vertex);
      const double along = vertex.y() / length;
      const int bone = main_bone(model.links[i]);
      const bool is_thumb = bone >= 1 && bone <= 3;
      if (along > 0.34 && along < 0.47 && !is_thumb) knuckles.extend(vertex);
      if (std::abs(along) < 0.04) wrist.extend(vertex);
    }
    EXPECT_NEAR(all.max().y(), length, 0.0015);
    EXPECT_NEAR(all.min().y(), -shape.forearm_length, 0.002);
    EXPECT_NEAR(knuckles.sizes().x(), breadth, 0.05 * breadth);
    EXPECT_NEAR(wrist.sizes().x(), 0.058 * breadth / 0.084, 0.006);
  }
}

TEST(BuiltInHand, TriangleCountIsAboutWhatWasAskedFor) {
  EXPECT_NEAR(static_cast<double>(mean_hand().rest_surface.triangles.size()), 3000.0, 100.0);
  EXPECT_NEAR(static_cast<double>(mean_hand().rest_surface.vertices.size()), 1500.0, 60.0);
}

TEST(BuiltInHand, VerticesLieOnTheSolid) {
  const HandSolid solid(mean_hand().skeleton, mean_hand().rest_angles);
  double sum = 0.0;
  for (const Eigen::Vector3d& vertex : mean_hand().rest_surface.vertices) {
    const double distance = std::abs(solid.field(vertex));
    EXPECT_LT(distance, 0.0012);
    sum += distance;
  }
  EXPECT_LT(sum / static_cast<double>(mean_hand().rest_surface.vertices.size()), 0.00025);
}

TEST(BuiltInHand, NormalsPointOutwards) {
  const HandSolid solid(mean_hand().skeleton, mean_hand().rest_angles);
  const TriangleMesh& surface = mean_hand().rest_surface;
  for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
    EXPECT_LT(solid.field(surface.vertices[i] + 0.003 * surface.normals[i]),
              solid.field(surface.vertices[i] - 0.003 * surface.normals[i]));
  }
}

TEST(BuiltInHand, EveryBoneMovesSomeOfTheSurface) {
  std::array<int, kBoneCount> counts = {};
  for (const SkinLinks& links : mean_hand().links) {
    ++counts[static_cast<std::size_t>(main_bone(links))];
  }
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    EXPECT_GT(counts[bone], 20) << bone_names()[bone];
  }
}

TEST(BuiltInHand, NoFingerPullsAtAnother) {
  for (const SkinLinks& links : mean_hand().links) {
    std::set<int> digits;
    for (std::size_t i = 0; i < links.bones.size(); ++i) {
      if (links.weights[i] > 0.0 && links.bones[i] > 0) digits.insert((links.bones[i] - 1) / 3);
    }
    EXPECT_LE(digits.size(), 1U);
  }
}

TEST(BuiltInHand, BendingKeepsTheVolumeRoughly) {
  const double flat_volume = enclosed_volume(PosedHand(mean_hand(), flat()).surface());
  HandPose pose;
  for (int digit = 1; digit < kDigitCount; ++digit) {
    pose.angles.segment<4>(4 * digit) << 0.0, 1.4, 1.5, 0.8;
  }
  EXPECT_NEAR(enclosed_volume(PosedHand(mean_hand(), pose).surface()) / flat_volume, 1.0, 0.08);
}

TEST(BuiltInHand, LeftIsTheMirrorImage) {
  const HandModel left = built_in_hand(HandShape(), Side::left);
  EXPECT_EQ(left.skeleton.side, Side::left);
  EXPECT_EQ(left.rest_surface.vertices, mirrored(mean_hand()).rest_surface.vertices);
  EXPECT_GT(enclosed_volume(left.rest_surface), 0.0);
}

TEST(BuiltInHand, SameShapeGivesTheSameHandToTheBit) {
  const HandModel again = built_in_hand(HandShape(), Side::right);
  EXPECT_EQ(again.rest_surface.vertices, mean_hand().rest_surface.vertices);
  EXPECT_EQ(again.rest_surface.triangles, mean_hand().rest_surface.triangles);
}

TEST(BuiltInHand, RefusesCellsTooCoarseForAFinger) {
  EXPECT_THROW(built_in_hand(HandShape(), Side::right, {.cell_size = 0.02}), Error);
  EXPECT_THROW(built_in_hand(HandShape(), Side::right, {.cell_size = 0.0}), Error);
}

}  // namespace
}  // namespace tegata
