// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/contradiction.h"

#include <gtest/gtest.h>

#include "tegata/fit/support.h"
#include "tegata/fit/test_scene.h"

namespace tegata {
namespace {

// A hand that turns before four cameras, and its poses.
struct FourViews {
  std::vector<FitFrame> frames;
  std::vector<HandPose> poses;

  std::vector<const FitFrame*> pointers() const {
    std::vector<const FitFrame*> all;
    for (const FitFrame& frame : frames) all.push_back(&frame);
    return all;
  }
};

CameraRig four_cameras() {
  CameraRig rig = test::orthogonal_rig(0.8);
  rig.push_back(rig[0]);
  rig[3].name = "camera_3";
  rig[3].camera_from_world.rotation = so3_exp({0.5, 0.6, 0.0});
  return rig;
}

FourViews before_four_cameras(int count, const CameraRig& rig = four_cameras()) {
  FourViews scene;
  for (int f = 0; f < count; ++f) {
    scene.poses.push_back(test::grasping_pose(0.25 * f));
    scene.frames.push_back(test::perfect_frame(test::coarse_hand(), scene.poses.back(), rig));
  }
  return scene;
}

// The picture of a camera moved to the right.
void shift(FitView& view, int pixels) {
  Silhouette moved(view.silhouette.width(), view.silhouette.height(), PixelLabel::background);
  for (int y = 0; y < moved.height(); ++y) {
    for (int x = pixels; x < moved.width(); ++x) moved(x, y) = view.silhouette(x - pixels, y);
  }
  view = make_fit_view(view.camera, std::move(moved));
}

TEST(Contradiction, CameraThatWasPushedIsFoundAndTheHandIsWhereTheOthersSeeIt) {
  FourViews scene = before_four_cameras(3);
  shift(scene.frames[1].views[2], 15);
  const HandPose truth = scene.poses[1];
  // As a fit with all views has it: off.
  scene.poses[1].world_from_hand.translation += Eigen::Vector3d(0.005, 0.002, 0.0);
  const FitHand hand(test::coarse_hand());
  const auto found = find_contradictions(hand, scene.pointers(), scene.poses, {}, {}, 2);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].frame, 1U);
  EXPECT_EQ(found[0].view, 2U);
  EXPECT_LT(test::mean_keypoint_distance(test::coarse_hand(), found[0].pose, truth), 1e-3);

  AgreeingFrames agreeing(scene.pointers());
  EXPECT_TRUE(agreeing.leave_out_contradictions(hand, scene.poses, {}, {}, 2));
  EXPECT_EQ(agreeing.left_out()[1], std::vector<std::string>{"camera_2"});
  EXPECT_TRUE(agreeing.left_out()[0].empty() && agreeing.left_out()[2].empty());
  EXPECT_EQ(agreeing.frames()[1]->views.size(), 3U);
  EXPECT_TRUE(agreeing.frames()[1]->hull.has_value());
  EXPECT_EQ(agreeing.frames()[0], &scene.frames[0]);
  EXPECT_FALSE(agreeing.leave_out_contradictions(hand, scene.poses, {}, {}, 2));
}

// Of such a view nobody knows where the hand ends and the forearm begins.
TEST(Contradiction, AViewAlongTheForearmIsFoundByWhereItDrawsTheHand) {
  const HandPose truth = test::grasping_pose(0.25);
  CameraRig rig = four_cameras();
  rig[3].camera_from_world.rotation = Eigen::Quaterniond::FromTwoVectors(
      truth.world_from_hand.rotation * Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ());
  FourViews scene = before_four_cameras(5, rig);
  const FitHand hand(test::coarse_hand());
  ASSERT_FALSE(uncovered_distance(hand, hand.posed(truth), scene.frames[1].views[3]));
  scene.poses[1].world_from_hand.translation +=
      rig[3].camera_from_world.rotation.conjugate() * Eigen::Vector3d(0.006, 0.0, 0.0);
  EXPECT_TRUE(find_contradictions(hand, scene.pointers(), scene.poses, {}, {}, 1).empty());

  shift(scene.frames[1].views[3], 12);
  const auto found = find_contradictions(hand, scene.pointers(), scene.poses, {}, {}, 1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].frame, 1U);
  EXPECT_EQ(found[0].view, 3U);
  EXPECT_LT(test::mean_keypoint_distance(test::coarse_hand(), found[0].pose, truth), 1e-3);
}

TEST(Contradiction, WhatHidesTheHandInAViewContradictsNothing) {
  FourViews scene = before_four_cameras(2);
  FitView& view = scene.frames[0].views[0];
  Silhouette eaten = view.silhouette;
  for (int y = 0; y < eaten.height() / 2; ++y) {
    for (int x = 0; x < eaten.width(); ++x) eaten(x, y) = PixelLabel::background;
  }
  view = make_fit_view(view.camera, std::move(eaten));
  const FitHand hand(test::coarse_hand());
  EXPECT_TRUE(find_contradictions(hand, scene.pointers(), scene.poses, {}, {}, 1).empty());
}

TEST(Contradiction, HandOfAnotherShapeMakesNoCameraSuspect) {
  FourViews scene = before_four_cameras(2);
  HandShape slender;
  slender.finger_thickness = 0.85;
  const HandModel other = built_in_hand(slender, Side::right, {.triangle_count = 2000});
  EXPECT_TRUE(
      find_contradictions(FitHand(other), scene.pointers(), scene.poses, {}, {}, 1).empty());
}

TEST(Contradiction, OfTwoViewsNobodyKnowsWhichIsWrong) {
  FourViews scene = before_four_cameras(1);
  scene.frames[0].views.resize(2);
  shift(scene.frames[0].views[1], 15);
  const FitHand hand(test::coarse_hand());
  EXPECT_TRUE(find_contradictions(hand, scene.pointers(), scene.poses, {}, {}, 1).empty());
}

}  // namespace
}  // namespace tegata
