// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/landmark_term.h"

#include <gtest/gtest.h>

#include "tegata/fit/test_scene.h"
#include "tegata/math/finite_difference.h"

namespace tegata {
namespace {

TEST(LandmarkTerm, GradientIsTheFiniteDifferenceOfTheEnergy) {
  const HandModel& hand = test::coarse_hand();
  const FitHand fit_hand(hand);
  const HandPose pose = test::grasping_pose(0.3);
  const StartLandmarks landmarks{{0.0, 0.0, 0.1}, {0.05, 0.02, 0.0}, {-0.03, 0.0, 0.04}};
  const auto evaluate = [&](const HandPose& at) {
    FrameEquations equations;
    add_landmark_term(fit_hand, PosedHand(hand, at), landmarks, {}, equations);
    return equations;
  };
  const auto energy = [&](const Eigen::VectorXd& step) -> Eigen::VectorXd {
    return Eigen::VectorXd::Constant(1, evaluate(advanced(pose, step)).cost);
  };
  const Eigen::MatrixXd expected = finite_difference_jacobian(energy, ParameterVector::Zero());
  const FrameEquations equations = evaluate(pose);
  EXPECT_LT((equations.gradient.transpose() - expected).norm(), 1e-5 * expected.norm());
}

}  // namespace
}  // namespace tegata
