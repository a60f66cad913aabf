// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/scaled_hand.h"

#include <gtest/gtest.h>

#include <limits>

#include "tegata/base/error.h"
#include "tegata/hand/built_in_hand.h"

namespace tegata {
namespace {

TEST(ScaledHand, EveryPointOfTheBentHandGoesWithTheScale) {
  const HandModel hand = built_in_hand({}, Side::left, {.cell_size = 0.005});
  HandPose pose;
  pose.angles = relaxed_angles();
  const HandModel large = scaled(hand, 1.25);
  check_hand(large);
  const PosedHand before(hand, pose), after(large, pose);
  for (std::size_t i = 0; i < before.vertices().size(); ++i) {
    ASSERT_LT((1.25 * before.vertices()[i] - after.vertices()[i]).norm(), 1e-12);
  }
  for (std::size_t k = 0; k < kKeypointCount; ++k) {
    ASSERT_LT((1.25 * before.keypoints()[k] - after.keypoints()[k]).norm(), 1e-12);
  }
}

TEST(ScaledHand, RefusesWhatIsNoScale) {
  const HandModel hand = built_in_hand({}, Side::right, {.cell_size = 0.005});
  for (const double factor : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(scaled(hand, factor), Error);
  }
}

}  // namespace
}  // namespace tegata
