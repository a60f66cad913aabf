// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/sim/hand_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tegata/base/angle.h"

namespace tegata {
namespace {

const Eigen::Vector3d kCenter(0.0, 0.08, -0.02);

TEST(HandMotion, EveryStepTurnsByTheAngleAskedFor) {
  const auto motion = hand_motion(kCenter, {.frame_count = 12, .turn_deg = 15.0, .seed = 4});
  ASSERT_EQ(motion.size(), 12u);
  for (std::size_t k = 1; k < motion.size(); ++k) {
    const double turn = motion[k].rotation.angularDistance(motion[k - 1].rotation);
    EXPECT_NEAR(turn * kDegreesPerRadian, 15.0, 1e-6);
  }
}

TEST(HandMotion, CentreStaysNearTheMiddleButMoves) {
  const auto motion = hand_motion(kCenter, {.frame_count = 30, .seed = 6});
  double farthest_step = 0.0;
  for (std::size_t k = 0; k < motion.size(); ++k) {
    EXPECT_LT((motion[k] * kCenter).norm(), 0.02);
    if (k > 0) {
      farthest_step =
          std::max(farthest_step, (motion[k] * kCenter - motion[k - 1] * kCenter).norm());
    }
  }
  EXPECT_GT(farthest_step, 0.001);
  EXPECT_LT(farthest_step, 0.012);
}

TEST(HandMotion, ForearmDoesNotStartTowardsACamera) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto motion = hand_motion(kCenter, {.frame_count = 1, .seed = seed});
    const Eigen::Vector3d fingers = motion[0].rotation * Eigen::Vector3d::UnitY();
    EXPECT_LT(fingers.cwiseAbs().maxCoeff(), 0.85);
    EXPECT_GT(fingers.z(), 0.0);
  }
}

}  // namespace
}  // namespace tegata
