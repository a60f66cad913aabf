// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/sim/grasps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/sim/sim_test_hand.h"

namespace tegata {
namespace {

constexpr std::array<SimulatedGrasp, 4> kAllGrasps = {SimulatedGrasp::cylinder,
                                                      SimulatedGrasp::sphere, SimulatedGrasp::pinch,
                                                      SimulatedGrasp::lateral};

// How many digits hold the object, from the thumb on.
int holding_digits(SimulatedGrasp kind) {
  if (kind == SimulatedGrasp::lateral) return 2;
  return kind == SimulatedGrasp::pinch ? 3 : 5;
}

// Made once for all of a test: they are what takes the time.
const Grasp& right_grasp(SimulatedGrasp kind, std::uint64_t seed) {
  static std::map<std::pair<SimulatedGrasp, std::uint64_t>, Grasp> made;
  const auto [place, is_new] = made.try_emplace({kind, seed});
  if (is_new) place->second = make_grasp(sim_test_hand(), kind, seed);
  return place->second;
}

// The least distance of all vertices that a digit's bones move most; of all the hand's for -1.
double least_distance(const HandModel& hand, const Grasp& grasp, int digit) {
  const PosedHand posed(hand, HandPose{{}, grasp.angles});
  double least = 1.0;
  for (std::size_t i = 0; i < hand.links.size(); ++i) {
    const int bone = main_bone(hand.links[i]);
    if (digit >= 0 && (bone == 0 || (bone - 1) / 3 != digit)) continue;
    least = std::min(least, grasp.held.distance(posed.vertices()[i]));
  }
  return least;
}

TEST(Grasps, DigitsThatHoldTouchTheObjectAndNoPartOfTheHandIsInsideIt) {
  for (const SimulatedGrasp kind : kAllGrasps) {
    const int holding = holding_digits(kind);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Grasp& grasp = right_grasp(kind, seed);
      EXPECT_GT(least_distance(sim_test_hand(), grasp, -1), -0.003)
          << simulated_grasp_name(kind) << " " << seed;
      for (int digit = 0; digit < holding; ++digit) {
        EXPECT_LT(least_distance(sim_test_hand(), grasp, digit), 0.0015)
            << simulated_grasp_name(kind) << " " << seed << " digit " << digit;
      }
    }
  }
}

TEST(Grasps, PlateLiesBetweenTheThumbAndTheSideOfTheIndexFinger) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const Grasp& grasp = right_grasp(SimulatedGrasp::lateral, seed);
    const auto keypoints = posed_keypoints(sim_test_hand().skeleton, HandPose{{}, grasp.angles});
    const auto height = [&](std::size_t keypoint) {
      return (grasp.held.object_from_hand() * keypoints[keypoint]).z();
    };
    EXPECT_GT(height(4), grasp.held.object.half_size.z()) << seed;   // thumb tip
    EXPECT_LT(height(6), -grasp.held.object.half_size.z()) << seed;  // index PIP
    EXPECT_LT(height(7), -grasp.held.object.half_size.z()) << seed;  // index DIP
  }
}

TEST(Grasps, ThumbStandsAgainstTheFingers) {
  for (const SimulatedGrasp kind :
       {SimulatedGrasp::cylinder, SimulatedGrasp::sphere, SimulatedGrasp::pinch}) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      const Grasp& grasp = right_grasp(kind, seed);
      const auto keypoints = posed_keypoints(sim_test_hand().skeleton, HandPose{{}, grasp.angles});
      Eigen::Vector3d thumb = grasp.held.object_from_hand() * keypoints[4];
      // Around an object the fingertips come back to the thumb: its middle bones face the thumb.
      const std::size_t joint = kind == SimulatedGrasp::pinch ? 4 : 2;
      Eigen::Vector3d fingers =
          grasp.held.object_from_hand() * (0.5 * (keypoints[4 + joint] + keypoints[8 + joint]));
      if (kind == SimulatedGrasp::cylinder) thumb.z() = fingers.z() = 0.0;
      if (kind == SimulatedGrasp::pinch) thumb.head<2>() = fingers.head<2>().setZero();
      // A ball may lie between palm, fingers and the side of the thumb.
      const double most = kind == SimulatedGrasp::sphere ? 0.6 : 0.3;
      EXPECT_LT(thumb.normalized().dot(fingers.normalized()), most)
          << simulated_grasp_name(kind) << " " << seed;
    }
  }
}

TEST(Grasps, AnglesKeepToTheLimitsAndVaryWithTheSeed) {
  for (const SimulatedGrasp kind : kAllGrasps) {
    const Grasp &a = right_grasp(kind, 1), &b = right_grasp(kind, 2);
    for (const Grasp& grasp : {a, b}) {
      EXPECT_TRUE((grasp.angles.array() <= angle_limits().upper.array() + 1e-12).all());
      EXPECT_TRUE((grasp.angles.array() >= angle_limits().lower.array() - 1e-12).all());
    }
    EXPECT_GT((a.angles - b.angles).norm(), 0.01);
    EXPECT_NE(a.held.object.half_size, b.held.object.half_size);
  }
}

TEST(Grasps, LeftHandIsTheMirrorImageWithTheSameAngles) {
  for (const SimulatedGrasp kind : kAllGrasps) {
    const Grasp& right = right_grasp(kind, 3);
    const Grasp left = make_grasp(sim_test_hand(Side::left), kind, 3);
    EXPECT_LT((right.angles - left.angles).norm(), 1e-9);
    const Eigen::Vector3d point(0.01, 0.05, -0.03), its_image(-0.01, 0.05, -0.03);
    EXPECT_NEAR(right.held.distance(point), left.held.distance(its_image), 1e-9);
  }
}

TEST(Grasps, NamesGoBothWaysAndOthersAreErrors) {
  for (const SimulatedGrasp kind : kAllGrasps) {
    EXPECT_EQ(simulated_grasp_from_name(simulated_grasp_name(kind)), kind);
  }
  EXPECT_THROW(simulated_grasp_from_name("fist"), Error);
}

}  // namespace
}  // namespace tegata
