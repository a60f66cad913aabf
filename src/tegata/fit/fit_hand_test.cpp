// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/fit_hand.h"

#include <gtest/gtest.h>

#include "tegata/fit/test_scene.h"
#include "tegata/hand/scaled_hand.h"

namespace tegata {
namespace {

TEST(FitHand, HasEveryEdgeOfAClosedSurfaceOnce) {
  const HandModel& hand = test::coarse_hand();
  EXPECT_EQ(2 * FitHand(hand).edges.size(), 3 * hand.rest_surface.triangles.size());
}

TEST(FitHand, LeavesOutTheForearmAndNothingElse) {
  const HandModel& hand = test::coarse_hand();
  const FitHand fit_hand(hand);
  for (std::size_t i = 0; i < fit_hand.beyond_wrist.size(); ++i) {
    EXPECT_EQ(fit_hand.beyond_wrist[i] != 0, hand.rest_surface.vertices[i].y() > 0.0);
  }
}

TEST(FitHand, ScaleFollowsTheSizeOfTheModel) {
  const HandModel& hand = test::coarse_hand();
  const HandModel large = scaled(hand, 10.0);
  EXPECT_NEAR(FitHand(large).scale / FitHand(hand).scale, 10.0, 1e-9);
}

}  // namespace
}  // namespace tegata
