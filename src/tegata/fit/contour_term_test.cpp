// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/contour_term.h"

#include <gtest/gtest.h>

#include "tegata/fit/test_scene.h"
#include "tegata/hand/scaled_hand.h"
#include "tegata/math/finite_difference.h"

namespace tegata {
namespace {

FrameEquations evaluate(const HandModel& hand, const HandPose& pose, const FitView& view) {
  FrameEquations equations;
  add_contour_term(FitHand(hand), PosedHand(hand, pose), view, {}, equations);
  return equations;
}

FitView seen(const HandModel& hand, const HandPose& pose, const Camera& camera) {
  return make_fit_view(camera, render_silhouette(PosedHand(hand, pose).surface(), camera));
}

TEST(ContourTerm, PullsTheOutlineOntoTheContour) {
  const HandModel& hand = test::coarse_hand();
  const HandPose truth = test::grasping_pose(0.2);
  const Camera camera = test::orthogonal_rig(0.8)[0];
  const FitView view = seen(hand, truth, camera);
  for (int axis = 0; axis < 2; ++axis) {  // the camera looks along z
    for (const double shift : {-0.003, 0.003}) {
      HandPose shifted = truth;
      shifted.world_from_hand.translation[axis] += shift;
      EXPECT_GT(evaluate(hand, shifted, view).gradient[3 + axis] * shift, 0.0);
    }
  }
}

TEST(ContourTerm, GradientIsTheSlopeOfTheEnergy) {
  const HandModel& hand = test::coarse_hand();
  const HandPose truth = test::grasping_pose(0.2);
  const FitView view = seen(hand, truth, test::orthogonal_rig(0.8)[0]);
  HandPose shifted = truth;
  shifted.world_from_hand.translation.x() += 0.0015;
  const auto energy = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    HandPose pose = shifted;
    pose.world_from_hand.translation.x() += x[0];
    return Eigen::VectorXd::Constant(1, evaluate(hand, pose, view).cost);
  };
  // Outlines change discretely with the pose, so the slope is taken over a step that averages that.
  const double slope = finite_difference_jacobian(energy, Eigen::VectorXd::Zero(1), 5e-4)(0, 0);
  EXPECT_NEAR(evaluate(hand, shifted, view).gradient[3], slope, 0.3 * std::abs(slope));
}

TEST(ContourTerm, GradientByTheScaleIsTheSlopeOfTheEnergy) {
  const HandModel& hand = test::coarse_hand();
  const HandPose pose = test::grasping_pose(0.2);
  const FitView view = seen(hand, pose, test::orthogonal_rig(0.8)[0]);
  const auto evaluate_at = [&](double at) {
    const HandModel model = scaled(hand, at);
    const PosedHand posed(model, pose);
    const ScaleMotion motion(posed, at);
    FitHand fit_hand(hand);
    fit_hand.model = &model;
    FrameEquations equations(1);
    add_contour_term(fit_hand, posed, view, {.sigma = 0.01}, equations, &motion);
    return equations;
  };
  const auto energy = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    return Eigen::VectorXd::Constant(1, evaluate_at(x[0]).cost);
  };
  // Far from the truth outline points lose and find their borders as the scale changes.
  for (const double scale : {0.99, 1.01}) {
    const double slope =
        finite_difference_jacobian(energy, Eigen::VectorXd::Constant(1, scale), 4e-3)(0, 0);
    const double gradient = evaluate_at(scale).shape_gradient[0];
    EXPECT_NEAR(gradient, slope, 0.4 * std::abs(slope)) << scale;
    EXPECT_GT(gradient * (scale - 1.0), 0.0) << "back to the true scale is better";
  }
}

TEST(ContourTerm, BordersWithUnknownPixelsPullNothing) {
  const HandModel& hand = test::coarse_hand();
  const HandPose truth = test::grasping_pose(0.2);
  const Camera camera = test::orthogonal_rig(0.8)[0];
  Silhouette all_unknown = render_silhouette(PosedHand(hand, truth).surface(), camera);
  for (PixelLabel& label : all_unknown.values()) {
    if (label == PixelLabel::background) label = PixelLabel::unknown;
  }
  HandPose shifted = truth;
  shifted.world_from_hand.translation.x() += 0.003;
  const FrameEquations equations =
      evaluate(hand, shifted, make_fit_view(camera, std::move(all_unknown)));
  EXPECT_EQ(equations.gradient.norm(), 0.0);
}

}  // namespace
}  // namespace tegata
