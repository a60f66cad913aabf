// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/hand_tracker.h"

#include <gtest/gtest.h>

#include "tegata/fit/test_scene.h"

namespace tegata {
namespace {

HandPose streamed_pose(int frame) { return test::grasping_pose(0.05 * frame); }

FitFrame streamed_frame(int frame) {
  return test::perfect_frame(test::coarse_hand(), streamed_pose(frame), test::orthogonal_rig(0.8));
}

// The cameras see a ball, where the hand was.
FitFrame frame_without_a_hand() {
  FitFrame frame = streamed_frame(0);
  const Eigen::Vector2d middle(160.0, 120.0);
  for (FitView& view : frame.views) {
    Silhouette silhouette(view.camera.width, view.camera.height, PixelLabel::background);
    for (int y = 0; y < silhouette.height(); ++y) {
      for (int x = 0; x < silhouette.width(); ++x) {
        if ((Eigen::Vector2d(x, y) - middle).norm() < 14.0) silhouette(x, y) = PixelLabel::hand;
      }
    }
    view = make_fit_view(view.camera, silhouette);
  }
  return frame;
}

TEST(HandTracker, FollowsAHandWithoutHullsOnceItIsFound) {
  const FitHand hand(test::coarse_hand());
  HandTracker tracker(hand, {});
  EXPECT_TRUE(tracker.is_lost());
  for (int f = 0; f < 6; ++f) {
    FitFrame frame = streamed_frame(f);
    if (f > 0) frame.hull.reset();
    const TrackedFrame tracked = tracker.next(frame);
    ASSERT_EQ(tracked.state, f == 0 ? TrackState::found : TrackState::followed) << f;
    EXPECT_LT(test::mean_keypoint_distance(test::coarse_hand(), tracked.pose, streamed_pose(f)),
              0.004)
        << f;
    EXPECT_GT(tracked.standard_deviations.minCoeff(), 0.0);
  }
}

TEST(HandTracker, AHandThatIsNotWhereItIsExpectedIsFollowedByAllStages) {
  const FitHand hand(test::coarse_hand());
  FitFrame frame = streamed_frame(13);  // nine steps at once
  frame.hull.reset();
  const auto off_after_a_jump = [&](const TrackOptions& options) {
    HandTracker tracker(hand, options);
    for (int f = 0; f < 5; ++f) tracker.next(streamed_frame(f));
    const TrackedFrame tracked = tracker.next(frame);
    return tracked.state != TrackState::followed
               ? 1.0
               : test::mean_keypoint_distance(test::coarse_hand(), tracked.pose, streamed_pose(13));
  };
  EXPECT_LT(off_after_a_jump({}), 0.004);
  TrackOptions last_stage;
  last_stage.follow.stages = {last_stage.follow.stages.back()};
  EXPECT_GT(off_after_a_jump(last_stage), 0.004) << "the jump is none";
}

TEST(HandTracker, WhatIsNoHandIsLostAndTheHandIsFoundAgain) {
  const FitHand hand(test::coarse_hand());
  HandTracker tracker(hand, {});
  for (int f = 0; f < 3; ++f) ASSERT_NE(tracker.next(streamed_frame(f)).state, TrackState::lost);
  EXPECT_EQ(tracker.next(frame_without_a_hand()).state, TrackState::lost);
  EXPECT_TRUE(tracker.is_lost());

  // Elsewhere than it was, and only with a hull.
  FitFrame frame = streamed_frame(20);
  const auto hull = std::exchange(frame.hull, std::nullopt);
  EXPECT_EQ(tracker.next(frame).state, TrackState::lost);
  frame.hull = hull;
  const TrackedFrame tracked = tracker.next(frame);
  EXPECT_EQ(tracked.state, TrackState::found);
  EXPECT_LT(test::mean_keypoint_distance(test::coarse_hand(), tracked.pose, streamed_pose(20)),
            0.006);
}

}  // namespace
}  // namespace tegata
