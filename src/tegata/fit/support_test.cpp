// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/support.h"

#include <gtest/gtest.h>

#include "tegata/fit/test_scene.h"

namespace tegata {
namespace {

TEST(Support, AFullySeenHandIsFullyBackedAndOverlaps) {
  const HandModel& hand = test::coarse_hand();
  const HandPose pose = test::grasping_pose(0.2);
  const FitHand fit_hand(hand);
  const PosedHand posed(hand, pose);
  const FitFrame frame = test::perfect_frame(hand, pose, test::orthogonal_rig(0.8));
  for (const double support : bone_support(fit_hand, posed, frame.views)) EXPECT_GT(support, 0.95);
  for (const FitView& view : frame.views) {
    EXPECT_GT(silhouette_overlap(fit_hand, posed, view), 0.95);
  }
}

TEST(Support, ABoneWhosePixelsAreColdIsNotBacked) {
  const HandModel& hand = test::coarse_hand();
  const FitHand fit_hand(hand);
  const HandPose pose = test::grasping_pose(0.2);
  const PosedHand posed(hand, pose);
  const CameraRig rig = test::orthogonal_rig(0.8);
  FitFrame frame = test::perfect_frame(hand, pose, rig);
  Silhouette eaten = frame.views[0].silhouette;
  const Eigen::Vector2d tip = *project(rig[0], posed.keypoints()[8]);
  for (int y = 0; y < eaten.height(); ++y) {
    for (int x = 0; x < eaten.width(); ++x) {
      if ((Eigen::Vector2d(x, y) - tip).norm() < 25.0) eaten(x, y) = PixelLabel::background;
    }
  }
  frame.views[0] = make_fit_view(rig[0], std::move(eaten));
  constexpr int kIndexDistal = 6;
  EXPECT_LT(bone_support(fit_hand, posed, frame.views)[kIndexDistal], 0.3);
  EXPECT_GT(bone_support(fit_hand, posed, frame.views)[0], 0.9);
}

TEST(Support, TheForearmDoesNotCountInTheOverlap) {
  const HandModel& hand = test::coarse_hand();
  const HandPose pose = test::grasping_pose(0.2);
  const PosedHand posed(hand, pose);
  const Camera camera = test::orthogonal_rig(0.8)[0];
  Silhouette with_arm = render_silhouette(posed.surface(), camera);
  // An arm from the wrist out of the picture.
  const Eigen::Vector2d wrist = *project(camera, posed.keypoints()[0]);
  const Eigen::Vector2d outwards = (wrist - *project(camera, posed.keypoints()[9])).normalized();
  for (int y = 0; y < with_arm.height(); ++y) {
    for (int x = 0; x < with_arm.width(); ++x) {
      const Eigen::Vector2d off = Eigen::Vector2d(x, y) - wrist;
      const double along = outwards.dot(off);
      if (along > 5.0 && (off - along * outwards).norm() < 20.0) with_arm(x, y) = PixelLabel::hand;
    }
  }
  const FitView view = make_fit_view(camera, std::move(with_arm));
  EXPECT_GT(silhouette_overlap(FitHand(hand), posed, view), 0.93);
}

TEST(Support, WhatIsSeenBesideThePosedHandIsUncoveredAndWhatIsHiddenIsNot) {
  const HandModel& hand = test::coarse_hand();
  const FitHand fit_hand(hand);
  HandPose pose = test::grasping_pose(0.2);
  FitFrame frame = test::perfect_frame(hand, pose, test::orthogonal_rig(0.8));
  const auto uncovered = [&](const HandPose& at, std::size_t view) {
    return uncovered_distance(fit_hand, PosedHand(hand, at), frame.views[view]).value_or(-1.0);
  };
  EXPECT_LT(uncovered(pose, 0), 1e-5);
  Silhouette& seen = frame.views[0].silhouette;
  for (int y = 0; y < seen.height(); ++y) {
    for (int x = 0; x < seen.width() / 2; ++x) seen(x, y) = PixelLabel::background;
  }
  frame.views[0] = make_fit_view(frame.views[0].camera, frame.views[0].silhouette);
  EXPECT_LT(uncovered(pose, 0), 1e-5);
  pose.world_from_hand.translation.z() += 0.01;
  EXPECT_GT(uncovered(pose, 1), 1e-3);
  EXPECT_LT(uncovered(pose, 1), 0.01);
}

}  // namespace
}  // namespace tegata
