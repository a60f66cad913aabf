// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/forearm.h"

#include <gtest/gtest.h>

#include "tegata/fit/test_scene.h"

namespace tegata {
namespace {

// A cylinder from the wrist backwards, bent away from the hand's axis.
TriangleMesh arm_hull(const Rigid3d& world_from_hand, const Eigen::Vector3d& axis, double radius) {
  TriangleMesh arm;
  const Eigen::Vector3d across = axis.unitOrthogonal(), third = axis.cross(across);
  for (int ring = 0; ring < 20; ++ring) {
    for (int i = 0; i < 24; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / 24;
      const Eigen::Vector3d out = std::cos(turn) * across + std::sin(turn) * third;
      arm.vertices.push_back(world_from_hand * (0.01 * ring * axis + radius * out));
      arm.normals.push_back(world_from_hand.rotation * out);
    }
  }
  arm.triangles = {{0, 1, 24}};
  return arm;
}

FitFrame frame_of(const TriangleMesh& hull) {
  FitFrame frame;
  frame.hull.emplace(hull);
  return frame;
}

TEST(Forearm, FollowsTheHullBehindABentWrist) {
  const FitHand hand(test::coarse_hand());
  const Rigid3d pose = test::grasping_pose(0.3).world_from_hand;
  const Eigen::Vector3d axis = Eigen::Vector3d(0.3, -1.0, 0.4).normalized();
  const auto forearm = find_forearm(hand, frame_of(arm_hull(pose, axis, 0.03)), pose);
  ASSERT_TRUE(forearm.has_value());
  EXPECT_TRUE(inspect_topology(forearm->surface).closed);
  for (const Eigen::Vector3d& vertex : forearm->surface.vertices) {
    const Eigen::Vector3d in_hand = pose.inverse() * vertex;
    EXPECT_GT(axis.dot(in_hand), 0.0) << "reaches into the hand";
    EXPECT_NEAR((in_hand - axis.dot(in_hand) * axis).norm(), 0.034, 0.006);
  }
}

TEST(Forearm, PiecesInEmptySpaceAreNoneOfIt) {
  const FitHand hand(test::coarse_hand());
  const Rigid3d pose = test::grasping_pose(0.3).world_from_hand;
  const Eigen::Vector3d axis = Eigen::Vector3d(0.3, -1.0, 0.4).normalized();
  TriangleMesh hull = arm_hull(pose, axis, 0.03);
  const std::size_t arm_count = hull.vertices.size();
  for (std::size_t i = 0; i < 2 * arm_count; ++i) {  // a slab as large, beside the far half
    const double along = static_cast<double>(i) / static_cast<double>(2 * arm_count);
    hull.vertices.push_back(pose * Eigen::Vector3d(0.12 + 0.1 * along, -0.15, 0.02 * along));
    hull.normals.push_back(Eigen::Vector3d::UnitX());
  }
  const auto forearm = find_forearm(hand, frame_of(hull), pose);
  ASSERT_TRUE(forearm.has_value());
  for (const Eigen::Vector3d& vertex : forearm->surface.vertices) {
    const Eigen::Vector3d in_hand = pose.inverse() * vertex;
    EXPECT_LT((in_hand - axis.dot(in_hand) * axis).norm(), 0.045);
  }
}

// Where a picture ends fewer cameras bound the hull, and it is wider on one side.
TEST(Forearm, WhatAPictureDoesNotShowDoesNotTurnItsAxis) {
  const FitHand hand(test::coarse_hand());
  const Rigid3d pose = test::grasping_pose(0.3).world_from_hand;
  const Eigen::Vector3d axis = Eigen::Vector3d(0.3, -1.0, 0.4).normalized();
  TriangleMesh hull = arm_hull(pose, axis, 0.03);
  Camera camera = test::orthogonal_rig(0.8).front();
  camera.height = 1000;  // the arm goes towards its upper edge
  const auto edge = project(camera, pose * (0.12 * axis));
  ASSERT_TRUE(edge);
  camera.cy -= edge->y();
  const Eigen::Vector3d aside(0.05, 0.0, 0.0);
  for (std::size_t i = hull.vertices.size(); i-- > 0;) {
    if (axis.dot(pose.inverse() * hull.vertices[i]) < 0.16) continue;
    for (int copy = 1; copy <= 6; ++copy) {
      hull.vertices.push_back(hull.vertices[i] + copy / 6.0 * aside);
      hull.normals.push_back(hull.normals[i]);
    }
  }
  FitFrame frame = frame_of(hull);
  const auto off_axis = [&] {
    const auto forearm = find_forearm(hand, frame, pose);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& vertex : forearm->beyond.vertices) mean += vertex;
    const Eigen::Vector3d towards =
        pose.inverse() * (mean / static_cast<double>(forearm->beyond.vertices.size()));
    return std::acos(axis.dot(towards.normalized()));
  };
  const double by_all = off_axis();
  frame.views.push_back(
      make_fit_view(camera, Silhouette(camera.width, camera.height, PixelLabel::background)));
  EXPECT_LT(off_axis(), 0.5 * by_all) << by_all;
}

TEST(Forearm, WhereTheHullEndsAtTheWristThereIsNone) {
  const FitHand hand(test::coarse_hand());
  const HandPose pose = test::grasping_pose(0.3);
  TriangleMesh fingers = PosedHand(test::coarse_hand(), pose).surface();
  FitFrame frame;
  EXPECT_FALSE(find_forearm(hand, frame, pose.world_from_hand).has_value());
  for (Eigen::Vector3d& vertex : fingers.vertices) {
    const Eigen::Vector3d in_hand = pose.world_from_hand.inverse() * vertex;
    if (in_hand.y() < 0.0) vertex = pose.world_from_hand * Eigen::Vector3d(0.0, 0.0, 0.0);
  }
  frame.hull.emplace(fingers);
  EXPECT_FALSE(find_forearm(hand, frame, pose.world_from_hand).has_value());
}

}  // namespace
}  // namespace tegata
