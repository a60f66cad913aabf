// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/shape_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tegata/base/error.h"
#include "tegata/fit/grasp_fit.h"
#include "tegata/fit/test_scene.h"
#include "tegata/hand/scaled_hand.h"

namespace tegata {
namespace {

const ShapedHand& shapes() {
  static const ShapedHand hand(Side::right, {.cell_size = 0.004, .triangle_count = 1200});
  return hand;
}

/// Somebody's hand in some takes: frames, and the estimates of a hand of the mean shape.
struct ShapeScene {
  ShapeParameters truth;
  HandModel model;
  std::vector<std::vector<HandPose>> poses;
  std::vector<std::vector<FitFrame>> frames;
  std::vector<GraspFrames> grasps;
};

ShapeScene make_scene(const ShapeParameters& truth, std::size_t takes, std::size_t frames) {
  ShapeScene scene{truth, shapes().model(shape_from_parameters(truth)), {}, {}, {}};
  for (std::size_t t = 0; t < takes; ++t) {
    scene.poses.emplace_back();
    scene.frames.emplace_back();
    for (std::size_t f = 0; f < frames; ++f) {
      HandPose pose = test::grasping_pose(0.35 * static_cast<double>(f));
      pose.angles += 0.2 * static_cast<double>(t) * JointAngles::Ones();
      scene.poses[t].push_back(pose);
      scene.frames[t].push_back(test::perfect_frame(scene.model, pose, test::orthogonal_rig(0.8)));
    }
  }
  for (std::size_t t = 0; t < takes; ++t) {
    GraspFrames& grasp = scene.grasps.emplace_back();
    grasp.estimate.angles = scene.poses[t][0].angles + 0.05 * JointAngles::Ones();
    for (std::size_t f = 0; f < frames; ++f) {
      grasp.frames.push_back(&scene.frames[t][f]);
      Rigid3d pose = scene.poses[t][f].world_from_hand;
      pose.translation += Eigen::Vector3d(0.004, -0.003, 0.002);
      grasp.estimate.world_from_hand.push_back(pose);
    }
  }
  return scene;
}

TEST(ShapeFit, ScaleOfAnyHandIsFoundWithPosesAndAngles) {
  const HandModel mean = shapes().model(HandShape());
  for (const double scale : {0.88, 1.1}) {
    ShapeParameters truth = shape_prior().mean;
    truth[0] *= scale;
    ShapeScene scene = make_scene(truth, 1, 3);
    const ScaleFit fit = fit_scale(mean, 1.0, scene.grasps);
    EXPECT_NEAR(fit.scale, scale, 0.01);
    EXPECT_GT(fit.standard_deviation, 0.0);
    EXPECT_LT(fit.standard_deviation, 0.03);
    const HandModel found = scaled(mean, fit.scale);
    for (std::size_t f = 0; f < 3; ++f) {
      EXPECT_LT(test::mean_keypoint_distance(scene.model, scene.grasps[0].estimate.pose(f),
                                             scene.poses[0][f]),
                0.004);
    }
  }
}

TEST(ShapeFit, AKnownShapeIsRecoveredFromTwoGrasps) {
  ShapeParameters truth = shape_prior().mean;
  for (int i = 0; i < kShapeParameterCount; ++i) {
    truth[i] += (i % 2 == 0 ? 1.0 : -1.0) * shape_prior().deviation[i];
  }
  ShapeScene scene = make_scene(truth, 2, 3);
  const ShapeFit fit = fit_shape(shapes(), shape_prior().mean, scene.grasps);
  // Every bone's length and the hand's breadth, in metres.
  const ShapeDrivers found = drivers_of_shape(shape_from_parameters(fit.shape));
  const ShapeDrivers expected = drivers_of_shape(shape_from_parameters(truth));
  const ShapeDrivers before = drivers_of_shape(HandShape());
  const auto bones = [&](const ShapeDrivers& of) {
    return (of - expected).head<kBoneCount - 1>().cwiseAbs().mean();
  };
  EXPECT_LT(bones(found), 0.0015);
  EXPECT_LT(bones(found), 0.75 * bones(before));
  EXPECT_LT(std::abs(fit.shape[0] - truth[0]), 0.003);
  int within_two = 0;
  for (int i = 0; i < kShapeParameterCount; ++i) {
    EXPECT_GT(fit.standard_deviations[i], 0.0);
    // All off by one: the prior is held for wider, by no more than sqrt(1 + 29 / 10).
    EXPECT_LE(fit.standard_deviations[i], 2.0 * shape_prior().deviation[i]) << i;
    if (std::abs(fit.shape[i] - truth[i]) < 2.0 * fit.standard_deviations[i]) ++within_two;
  }
  EXPECT_GE(within_two, 20);
}

TEST(ShapeFit, WhatNoPictureTellsStaysAtThePrior) {
  ShapeScene scene = make_scene(shape_prior().mean, 1, 1);
  scene.frames[0][0].views.clear();
  scene.frames[0][0].hull.reset();
  const ShapeFit fit = fit_shape(shapes(), shape_prior().mean, scene.grasps);
  EXPECT_LT((fit.shape - shape_prior().mean).norm(), 1e-9);
  EXPECT_LT((fit.standard_deviations - shape_prior().deviation).norm(), 1e-6);
}

TEST(ShapeFit, TheNumberOfThreadsChangesNothing) {
  ShapeScene one = make_scene(shape_prior().mean, 1, 2), two = make_scene(shape_prior().mean, 1, 2);
  ShapeFitOptions options;
  options.shape.stages.front().most_iterations = 2;
  options.shape.stages.resize(1);
  options.threads = 1;
  const ShapeFit with_one = fit_shape(shapes(), shape_prior().mean, one.grasps, options);
  options.threads = 2;
  const ShapeFit with_two = fit_shape(shapes(), shape_prior().mean, two.grasps, options);
  EXPECT_EQ(with_one.shape, with_two.shape);
}

TEST(ShapeFit, RefusesNoFrames) {
  std::vector<GraspFrames> none;
  EXPECT_THROW(fit_shape(shapes(), shape_prior().mean, none), Error);
  EXPECT_THROW(fit_scale(shapes().model(HandShape()), 1.0, none), Error);
}

}  // namespace
}  // namespace tegata
