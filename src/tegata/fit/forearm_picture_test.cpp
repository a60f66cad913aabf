// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/forearm_picture.h"

#include <gtest/gtest.h>

#include "tegata/fit/test_scene.h"

namespace tegata {
namespace {

// From 15 mm behind the wrist so far back.
Forearm arm_of_length(const HandPose& pose, double length) {
  constexpr std::uint32_t kSectors = 16;
  Forearm arm;
  for (const double along : {0.015, length}) {
    for (std::uint32_t i = 0; i < kSectors; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / kSectors;
      arm.surface.vertices.push_back(
          pose.world_from_hand *
          Eigen::Vector3d(0.025 * std::cos(turn), -along, 0.025 * std::sin(turn)));
    }
  }
  for (std::uint32_t i = 0; i < kSectors; ++i) {
    const std::uint32_t next = (i + 1) % kSectors;
    arm.surface.triangles.push_back({i, next, i + kSectors});
    arm.surface.triangles.push_back({next, next + kSectors, i + kSectors});
  }
  arm.end = pose.world_from_hand * Eigen::Vector3d(0.0, -length, 0.0);
  return arm;
}

// A hand with 13 cm of its arm in the picture, and something beside them.
struct ArmScene {
  ArmScene() {
    Camera camera = test::orthogonal_rig(0.8).front();
    camera.cy += 50.0;
    Silhouette silhouette = render_silhouette(posed.surface(), camera);
    const Silhouette arm = render_silhouette(arm_of_length(pose, 0.13).surface, camera);
    for (std::size_t i = 0; i < arm.values().size(); ++i) {
      if (arm.values()[i] == PixelLabel::hand) silhouette.values()[i] = PixelLabel::hand;
    }
    for (int y = 10; y < 20; ++y) silhouette(20, y) = PixelLabel::hand;
    view = make_fit_view(camera, std::move(silhouette));
  }
  bool shows(const Silhouette& arm, double along) const {
    const auto pixel = project(view.camera, pose.world_from_hand * Eigen::Vector3d(0, along, 0));
    return arm(static_cast<int>(std::lround(pixel->x())),
               static_cast<int>(std::lround(pixel->y()))) == PixelLabel::hand;
  }

  FitHand hand{test::coarse_hand()};
  HandPose pose = test::grasping_pose(0.0);
  PosedHand posed{test::coarse_hand(), pose};
  FitView view;
};

TEST(ForearmPicture, TheArmGoesOnWhereTheHullEndsAndThePictureDoesNot) {
  const ArmScene scene;
  const Silhouette arm =
      forearm_picture(scene.hand, scene.posed, scene.view, arm_of_length(scene.pose, 0.06));
  EXPECT_TRUE(scene.shows(arm, -0.05)) << "the forearm itself";
  EXPECT_TRUE(scene.shows(arm, -0.12)) << "beyond the hull";
  EXPECT_FALSE(scene.shows(arm, 0.05)) << "the palm";
  EXPECT_EQ(arm(20, 15), PixelLabel::background) << "not joined to the arm";
  // All of the arm's contour, which runs between pixels, is the arm's.
  FitView with_arm = scene.view;
  with_arm.forearm = std::make_shared<const Silhouette>(arm);
  const Rigid3d hand_from_world = scene.pose.world_from_hand.inverse();
  int asked = 0;
  for (const ContourPoint& point : scene.view.contour) {
    const Eigen::Vector3d ray = pixel_direction(scene.view.camera, point.pixel);
    const Eigen::Vector3d eye = scene.view.camera.center_in_world();
    const double depth = (scene.posed.keypoints()[kWrist] - eye).dot(ray) / ray.squaredNorm();
    const Eigen::Vector3d in_hand = hand_from_world * (eye + depth * ray);
    if (in_hand.y() > -0.07 || in_hand.y() < -0.2 || point.pixel.x() < 30.0) continue;
    ++asked;
    EXPECT_TRUE(with_arm.is_forearm(point.pixel)) << point.pixel.transpose();
  }
  EXPECT_GT(asked, 50);
}

TEST(ForearmPicture, AnArmThatLeavesThePictureIsTheForearmAlone) {
  const ArmScene scene;
  const Forearm forearm = arm_of_length(scene.pose, 0.3);
  EXPECT_EQ(forearm_picture(scene.hand, scene.posed, scene.view, forearm),
            render_silhouette(forearm.surface, scene.view.camera));
}

TEST(ForearmPicture, WhatIsSeenBesideTheHandStaysTheHands) {
  // All of the picture is seen as hand.
  const ArmScene scene;
  const Forearm forearm = arm_of_length(scene.pose, 0.06);
  const Silhouette hand = render_silhouette(scene.posed.surface(), scene.view.camera);
  int beside = 0;
  const FitView view = make_fit_view(
      scene.view.camera,
      Silhouette(scene.view.camera.width, scene.view.camera.height, PixelLabel::hand));
  const Silhouette arm = forearm_picture(scene.hand, scene.posed, view, forearm);
  const Silhouette forearm_alone = render_silhouette(forearm.surface, scene.view.camera);
  for (int y = 8; y < hand.height() - 8; ++y) {
    for (int x = 8; x < hand.width() - 8; ++x) {
      const bool is_near = hand(x - 6, y) == PixelLabel::hand || hand(x + 6, y) == PixelLabel::hand;
      if (!is_near || forearm_alone(x, y) == PixelLabel::hand) continue;
      ++beside;
      EXPECT_EQ(arm(x, y), PixelLabel::background) << x << ' ' << y;
    }
  }
  EXPECT_GT(beside, 1000);
  EXPECT_EQ(arm(2, 2), PixelLabel::hand);
}

}  // namespace
}  // namespace tegata
