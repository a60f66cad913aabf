// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/surface_fit.h"

#include <gtest/gtest.h>

#include <limits>

#include "tegata/base/error.h"
#include "tegata/base/random.h"
#include "tegata/fit/surface_fit_target.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

const ShapedHand& hand(Side side) {
  static const ShapedHand right(Side::right, {.cell_size = 0.004, .triangle_count = 1500});
  static const ShapedHand left(Side::left, {.cell_size = 0.004, .triangle_count = 1500});
  return side == Side::right ? right : left;
}

/// Somebody's hand somewhere, with keypoints that are off by some millimetres.
struct Case {
  ShapeParameters shape = shape_prior().mean;
  HandPose pose;
  HandSurface given;
  std::array<Eigen::Vector3d, kKeypointCount> joints;
};

Case make_case(Side side, std::uint64_t seed, double keypoint_noise) {
  Random random(seed);
  Case made;
  for (int i = 0; i < kShapeParameterCount; ++i) {
    made.shape[i] += random.normal() * shape_prior().deviation[i];
  }
  made.pose.world_from_hand = {so3_exp({1.0, -0.6, 2.0}), {0.2, 0.1, 0.8}};
  made.pose.angles = relaxed_angles();
  for (int angle = 0; angle < kAngleCount; ++angle) {
    made.pose.angles[angle] += random.uniform(-0.2, 0.2);
  }
  const HandModel model = hand(side).model(shape_from_parameters(made.shape));
  const PosedHand posed(model, made.pose);
  made.joints = posed.keypoints();
  made.given = {posed.surface(), posed.keypoints()};
  for (Eigen::Vector3d& keypoint : made.given.keypoints) {
    for (int axis = 0; axis < 3; ++axis) keypoint[axis] += keypoint_noise * random.normal();
  }
  return made;
}

double mean_joint_distance(const SurfaceFit& fit, const Case& truth) {
  const PosedHand posed(fit.model, fit.pose);
  double sum = 0.0;
  for (std::size_t k = 1; k < kKeypointCount; ++k) {
    sum += (posed.keypoints()[k] - truth.joints[k]).norm();
  }
  return sum / (kKeypointCount - 1);
}

TEST(FitSurface, FindsShapeAndPoseOfItsOwnHandDespiteRoughKeypoints) {
  for (const Side side : {Side::right, Side::left}) {
    const Case truth = make_case(side, side == Side::right ? 1 : 2, 0.004);
    const SurfaceFit fit = fit_surface(hand(side), truth.given);
    EXPECT_LT(fit.mean_distance, 0.0004);
    EXPECT_LT(fit.distance_95, 0.0012);
    EXPECT_LT(mean_joint_distance(fit, truth), 0.004);
    EXPECT_NEAR(fit.shape[0], truth.shape[0], 0.006);
  }
}

TEST(FitSurface, WhatLiesBehindTheWristDoesNotCount) {
  Case truth = make_case(Side::right, 3, 0.0);
  // A sleeve on the forearm.
  const Rigid3d hand_from_world = truth.pose.world_from_hand.inverse();
  for (Eigen::Vector3d& vertex : truth.given.surface.vertices) {
    Eigen::Vector3d in_hand = hand_from_world * vertex;
    if (in_hand.y() < -0.01) {
      in_hand.x() *= 1.6;
      in_hand.z() *= 1.6;
    }
    vertex = truth.pose.world_from_hand * in_hand;
  }
  const SurfaceFit fit = fit_surface(hand(Side::right), truth.given);
  EXPECT_LT(fit.mean_distance, 0.0004);
}

TEST(FitSurface, MissingPartsOfTheSurfaceAreNoOutliers) {
  Case truth = make_case(Side::right, 4, 0.002);
  std::vector<Triangle>& triangles = truth.given.surface.triangles;
  // The back of the hand was not scanned.
  const Eigen::Vector3d back = truth.pose.world_from_hand.rotation * Eigen::Vector3d::UnitZ();
  std::vector<Triangle> kept;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (triangle_normal(truth.given.surface, t).dot(back) < 0.5) kept.push_back(triangles[t]);
  }
  ASSERT_LT(kept.size(), 4 * triangles.size() / 5);
  triangles = kept;
  const SurfaceFit fit = fit_surface(hand(Side::right), truth.given);
  EXPECT_LT(mean_joint_distance(fit, truth), 0.005);
}

TEST(FitSurface, SameSurfaceGivesTheSameFit) {
  const Case truth = make_case(Side::right, 5, 0.004);
  const SurfaceFit once = fit_surface(hand(Side::right), truth.given);
  const SurfaceFit again = fit_surface(hand(Side::right), truth.given);
  EXPECT_EQ(once.shape, again.shape);
  EXPECT_EQ(once.pose.angles, again.pose.angles);
}

TEST(FitSurface, RefusesWhatIsNoHand) {
  HandSurface given = make_case(Side::right, 6, 0.0).given;
  given.keypoints[7].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(fit_surface(hand(Side::right), given), Error);
  given = make_case(Side::right, 6, 0.0).given;
  given.keypoints[9] = given.keypoints[0];
  EXPECT_THROW(fit_surface(hand(Side::right), given), Error);
  given = make_case(Side::right, 6, 0.0).given;
  for (Eigen::Vector3d& vertex : given.surface.vertices) {
    vertex = given.keypoints[0] - (given.keypoints[9] - given.keypoints[0]);
  }
  EXPECT_THROW(fit_surface(hand(Side::right), given), Error);
}

}  // namespace
}  // namespace tegata
