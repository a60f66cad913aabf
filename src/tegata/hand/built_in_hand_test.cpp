// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/built_in_hand.h"

#include <gtest/gtest.h>

#include <set>

#include "tegata/base/angle.h"
#include "tegata/base/error.h"
#include "tegata/hand/hand_solid.h"
#include "tegata/hand/test_hand.h"
#include "tegata/hand/winding_volume_for_tests.h"
#include "tegata/mesh/closest_point.h"

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

/// Fine enough for the cut between finger and palm to be nearly the same line in all poses.
const HandModel& fine_hand() {
  static const HandModel model =
      built_in_hand(HandShape(), Side::right, {.cell_size = 0.002, .triangle_count = 12000});
  return model;
}

test::WindingVolume digit_volume(int digit, const JointAngles& angles) {
  const TriangleMesh surface = PosedHand(fine_hand(), HandPose{{}, angles}).surface();
  return test::winding_volume(test::digit_surface(fine_hand(), surface, digit), 0.0006);
}

// Linear blending thins what it bends. The surface is made half bent so that no joint goes further
// than about 65 degrees from there.
TEST(BuiltInHand, FingersKeepTheirVolumeAtTheirLimits) {
  const auto& [lower, upper] = angle_limits();
  for (int digit = 0; digit < kDigitCount; ++digit) {
    const int first = 4 * digit + (digit == 0 ? 2 : 1), last = 4 * digit + 3;
    const double flat_volume = digit_volume(digit, JointAngles::Zero()).solid;
    std::vector<JointAngles> poses(2, JointAngles::Zero());
    for (int angle = first; angle <= last; ++angle) {
      poses[0][angle] = lower[angle];
      poses[1][angle] = upper[angle];
      poses.push_back(JointAngles::Zero());
      poses.back()[angle] = upper[angle];
    }
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const test::WindingVolume volume = digit_volume(digit, poses[i]);
      EXPECT_NEAR(volume.solid / flat_volume, 1.0, 0.1) << "digit " << digit << ", pose " << i;
      EXPECT_LT(volume.overlap, 0.02 * flat_volume) << "digit " << digit << ", pose " << i;
      EXPECT_LT(volume.inverted, 0.002 * flat_volume) << "digit " << digit << ", pose " << i;
    }
  }
}

// Flexed without being abducted it would go through the palm.
TEST(BuiltInHand, ThumbKeepsItsVolumeWhenItOpposes) {
  JointAngles angles = JointAngles::Zero();
  const double flat_volume = digit_volume(0, angles).solid;
  angles[0] = 45.0 * kDegree;
  angles[1] = angle_limits().upper[1];
  EXPECT_NEAR(digit_volume(0, angles).solid / flat_volume, 1.0, 0.1);
}

TEST(BuiltInHand, FingerBentBeyondItsLimitDoesNotCollapse) {
  constexpr double kBend = 110.0 * kDegree;
  for (int digit = 1; digit < kDigitCount; ++digit) {
    JointAngles angles = JointAngles::Zero();
    const double flat_volume = digit_volume(digit, angles).solid;
    angles[4 * digit + 2] = kBend;
    EXPECT_NEAR(digit_volume(digit, angles).solid / flat_volume, 1.0, 0.06) << digit;
    // From the joint to the knuckle's skin it is as thick as when it is straight, but for a fifth.
    const auto thickness = [&](double bend) {
      JointAngles bent = JointAngles::Zero();
      bent[4 * digit + 2] = bend;
      const PosedHand hand(fine_hand(), HandPose{{}, bent});
      return NearestSurface(hand.surface())
          .nearest(hand.keypoints()[static_cast<std::size_t>(4 * digit + 2)])
          .distance;
    };
    EXPECT_GT(thickness(kBend), 0.75 * thickness(0.0)) << digit;
  }
}

TEST(BuiltInHand, WholeHandKeepsItsVolumeInGrasps) {
  const double flat_volume = enclosed_volume(PosedHand(mean_hand(), flat()).surface());
  HandPose pose;
  for (int digit = 1; digit < kDigitCount; ++digit) {
    pose.angles.segment<4>(4 * digit) << 0.0, 1.4, 1.5, 0.8;
  }
  EXPECT_NEAR(enclosed_volume(PosedHand(mean_hand(), pose).surface()) / flat_volume, 1.0, 0.08);
  pose.angles = relaxed_angles();
  EXPECT_NEAR(enclosed_volume(PosedHand(mean_hand(), pose).surface()) / flat_volume, 1.0, 0.03);
}

// In a fist neighbouring fingers press against each other, most at their roots, which stand closer
// than they are broad. Nothing else may be crossed: no finger
// itself, and the palm by no fingertip.
TEST(BuiltInHand, FistCrossesItselfOnlyWhereFingersPressAgainstEachOther) {
  JointAngles angles;
  angles << 40.0, 0.0, 10.0, 10.0,  // thumb, out of the way
      0.0, 76.0, 96.0, 52.0,        // index
      0.0, 76.0, 96.0, 52.0,        // middle
      0.0, 76.0, 96.0, 52.0,        // ring
      3.0, 76.0, 96.0, 52.0;        // little
  angles *= kDegree;
  const TriangleMesh surface = PosedHand(fine_hand(), HandPose{{}, angles}).surface();
  const test::WindingVolume whole = test::winding_volume(surface, 0.0006);
  double pressed = 0.0;
  TriangleMesh before = test::digit_surface(fine_hand(), surface, 1);
  for (int digit = 2; digit < kDigitCount; ++digit) {
    const TriangleMesh next = test::digit_surface(fine_hand(), surface, digit);
    const double between = test::winding_volume(test::side_by_side(before, next), 0.0006).overlap;
    EXPECT_LT(between, 0.15 * test::winding_volume(next, 0.0006).solid) << digit;
    pressed += between;
    before = next;
  }
  EXPECT_LT(whole.overlap - pressed, 0.002 * whole.solid);
  EXPECT_LT(whole.inverted, 0.0005 * whole.solid);
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
