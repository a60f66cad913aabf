// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/forearm_picture.h"

#include <gtest/gtest.h>

#include "tegata/fit/test_scene.h"

namespace tegata {
namespace {

TriangleMesh tube(const HandPose& pose, double from, double to, double radius) {
  constexpr std::uint32_t kSectors = 16;
  TriangleMesh mesh;
  for (const double along : {from, to}) {
    for (std::uint32_t i = 0; i < kSectors; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / kSectors;
      mesh.vertices.push_back(pose.world_from_hand * Eigen::Vector3d(radius * std::cos(turn),
                                                                     -along,
                                                                     radius * std::sin(turn)));
    }
  }
  for (std::uint32_t i = 0; i < kSectors; ++i) {
    const std::uint32_t next = (i + 1) % kSectors;
    mesh.triangles.push_back({i, next, i + kSectors});
    mesh.triangles.push_back({next, next + kSectors, i + kSectors});
  }
  return mesh;
}

// From 15 mm behind the wrist so far back; beyond that it is somewhere about there.
Forearm arm_of_length(const HandPose& pose, double length) {
  return {tube(pose, 0.015, length, 0.025), tube(pose, length, length + 0.3, 0.06)};
}

// A hand of which the hull has a finger elsewhere, with 13 cm of its arm in the picture.
struct ArmScene {
  ArmScene() {
    Camera camera = test::orthogonal_rig(0.8).front();
    camera.cy += 50.0;
    Silhouette silhouette = render_silhouette(posed.surface(), camera);
    const Silhouette arm = render_silhouette(arm_of_length(pose, 0.13).surface, camera);
    for (std::size_t i = 0; i < arm.values().size(); ++i) {
      if (arm.values()[i] == PixelLabel::hand) silhouette.values()[i] = PixelLabel::hand;
    }
    TriangleMesh hull = posed.surface();
    hull.vertices.front() = pose.world_from_hand * finger;
    frame.hull.emplace(hull);
    frame.views.push_back(make_fit_view(camera, std::move(silhouette)));
  }
  const Camera& camera() const { return frame.views.front().camera; }
  Silhouette seen_with(double hull_length) const {
    return forearm_picture(hand, posed, frame, camera(), arm_of_length(pose, hull_length));
  }
  bool shows(const Silhouette& arm, const Eigen::Vector3d& in_hand) const {
    const auto pixel = project(camera(), pose.world_from_hand * in_hand);
    return arm(static_cast<int>(std::lround(pixel->x())),
               static_cast<int>(std::lround(pixel->y()))) == PixelLabel::hand;
  }

  const Eigen::Vector3d finger{0.1, 0.08, 0.0};  // in the hand's frame
  FitHand hand{test::coarse_hand()};
  HandPose pose = test::grasping_pose(0.0);
  PosedHand posed{test::coarse_hand(), pose};
  FitFrame frame;
};

TEST(ForearmPicture, TheArmGoesOnWhereTheHullEndsAndThePictureDoesNot) {
  const ArmScene scene;
  const Silhouette arm = scene.seen_with(0.06);
  EXPECT_TRUE(scene.shows(arm, {0.0, -0.05, 0.0})) << "the forearm itself";
  EXPECT_TRUE(scene.shows(arm, {0.0, -0.12, 0.0})) << "beyond the hull";
  EXPECT_FALSE(scene.shows(arm, {0.0, 0.05, 0.0})) << "the palm";
  EXPECT_FALSE(scene.shows(arm, scene.finger)) << "what the hull has before the wrist";
  // All of the arm's contour, which runs between pixels, is the arm's.
  FitView view = scene.frame.views.front();
  view.forearm = std::make_shared<const Silhouette>(arm);
  const Rigid3d hand_from_world = scene.pose.world_from_hand.inverse();
  const Eigen::Vector3d eye = scene.camera().center_in_world();
  int asked = 0;
  for (const ContourPoint& point : view.contour) {
    const Eigen::Vector3d ray = pixel_direction(scene.camera(), point.pixel);
    const double depth = (scene.posed.keypoints()[kWrist] - eye).dot(ray) / ray.squaredNorm();
    if ((hand_from_world * (eye + depth * ray)).y() > -0.07) continue;
    ++asked;
    EXPECT_TRUE(view.is_forearm(point.pixel)) << point.pixel.transpose();
  }
  EXPECT_GT(asked, 50);
}

TEST(ForearmPicture, AnArmThatLeavesThePictureIsTheForearmAlone) {
  const ArmScene scene;
  EXPECT_EQ(scene.seen_with(0.3),
            render_silhouette(arm_of_length(scene.pose, 0.3).surface, scene.camera()));
}

TEST(ForearmPicture, WhatIsBesideTheHandStaysTheHands) {
  // The arm goes on across all of the picture.
  const ArmScene scene;
  Forearm forearm = arm_of_length(scene.pose, 0.06);
  const Eigen::Vector3d wrist = scene.posed.keypoints()[kWrist];
  forearm.beyond.vertices = {wrist + Eigen::Vector3d(-1.0, -1.0, 0.0),
                             wrist + Eigen::Vector3d(3.0, -1.0, 0.0),
                             wrist + Eigen::Vector3d(-1.0, 3.0, 0.0)};
  forearm.beyond.triangles = {{0, 1, 2}};
  const Silhouette arm =
      forearm_picture(scene.hand, scene.posed, scene.frame, scene.camera(), forearm);
  const Silhouette hand = render_silhouette(scene.posed.surface(), scene.camera());
  const Silhouette forearm_alone = render_silhouette(forearm.surface, scene.camera());
  int beside = 0;
  for (int y = 0; y < hand.height(); ++y) {
    for (int x = 6; x < hand.width() - 6; ++x) {
      const bool is_near = hand(x - 6, y) == PixelLabel::hand || hand(x + 6, y) == PixelLabel::hand;
      if (!is_near || forearm_alone(x, y) == PixelLabel::hand) continue;
      ++beside;
      EXPECT_EQ(arm(x, y), PixelLabel::background) << x << ' ' << y;
    }
  }
  EXPECT_GT(beside, 1000);
  EXPECT_EQ(arm(2, 2), PixelLabel::hand) << "far from the hand";
  EXPECT_FALSE(scene.shows(arm, scene.finger)) << "what the hull has before the wrist";
}

}  // namespace
}  // namespace tegata
