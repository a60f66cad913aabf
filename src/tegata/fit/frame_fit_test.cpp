// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/frame_fit.h"

#include <gtest/gtest.h>

#include <limits>

#include "tegata/base/error.h"
#include "tegata/fit/test_scene.h"

namespace tegata {
namespace {

TEST(FrameFit, TheBestOfSeveralStartsWins) {
  const HandModel& hand = test::coarse_hand();
  const HandPose truth = test::grasping_pose(0.3);
  const FitFrame frame = test::perfect_frame(hand, truth, test::orthogonal_rig(0.8));
  HandPose upside_down = truth;
  upside_down.world_from_hand.rotation =
      truth.world_from_hand.rotation * so3_exp({0.0, 0.0, std::numbers::pi});
  const FitHand fit_hand(hand);
  for (const auto& starts :
       {std::vector<HandPose>{upside_down, truth}, std::vector<HandPose>{truth, upside_down}}) {
    const FrameFit fit =
        fit_frame_from_best(fit_hand, frame, starts, 1, {hull_first_schedule()}, 2);
    EXPECT_LT(test::mean_keypoint_distance(hand, fit.pose, truth), 0.002);
  }
}

TEST(FrameFit, TheWinnerLeadsWhatIsElsewhereNotItsOwnVariants) {
  const HandModel& hand = test::coarse_hand();
  const HandPose truth = test::grasping_pose(0.3);
  const FitFrame frame = test::perfect_frame(hand, truth, test::orthogonal_rig(0.8));
  HandPose near = truth, upside_down = truth;
  near.world_from_hand.translation.x() += 0.004;
  upside_down.world_from_hand.rotation =
      truth.world_from_hand.rotation * so3_exp({0.0, std::numbers::pi, 0.0});
  const auto lead = [&](const HandPose& other) {
    return fit_frame_from_best(FitHand(hand), frame, {truth, other}, 2, search_schedules(), 2).lead;
  };
  EXPECT_EQ(lead(near), std::numeric_limits<double>::infinity());
  EXPECT_GT(lead(upside_down), 1.5);
  EXPECT_LT(lead(upside_down), std::numeric_limits<double>::infinity());
}

TEST(FrameFit, RefusesNoStartAndNoStage) {
  const FitHand hand(test::coarse_hand());
  EXPECT_THROW(fit_frame_from_best(hand, {}, {}, 1, {hull_first_schedule()}, 1), Error);
  EXPECT_THROW(fit_frame_from_best(hand, {}, {HandPose{}}, 1, {}, 1), Error);
}

}  // namespace
}  // namespace tegata
