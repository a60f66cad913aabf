// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/border_term.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tegata/fit/contour_term.h"
#include "tegata/fit/test_scene.h"
#include "tegata/hand/scaled_hand.h"
#include "tegata/math/finite_difference.h"

namespace tegata {
namespace {

FitView border_view(const HandModel& hand, const HandPose& pose, const Camera& camera) {
  return make_fit_view(camera, render_silhouette(PosedHand(hand, pose).surface(), camera));
}

FrameEquations border_equations(const HandModel& hand, const HandPose& pose, const FitView& view) {
  FrameEquations equations;
  add_border_term(FitHand(hand), PosedHand(hand, pose), view, {}, equations);
  return equations;
}

// The largest bend of a row of energies: what jumps has one as large as the jump.
template <typename Energy>
double largest_bend(const Energy& energy) {
  constexpr int kSteps = 100;
  double largest = 0.0, before = energy(0), at = energy(1);
  for (int i = 2; i < kSteps; ++i) {
    const double next = energy(i);
    largest = std::max(largest, std::abs(next - 2.0 * at + before));
    before = at;
    at = next;
  }
  return largest;
}

TEST(BorderTerm, JumpsFarLessThanTheContourTerm) {
  const HandModel& hand = test::coarse_hand();
  const FitHand fit_hand(hand);
  const HandPose truth = test::grasping_pose(0.2);
  for (const Camera& camera : test::orthogonal_rig(0.8)) {
    const FitView view = border_view(hand, truth, camera);
    const auto posed = [&](int step) {
      HandPose pose = truth;
      pose.world_from_hand.translation += Eigen::Vector3d::Constant(1e-5 * step);
      pose.angles.array() += 2e-4 * step;
      return PosedHand(hand, pose);
    };
    const double border = largest_bend([&](int step) {
      FrameEquations equations;
      add_border_term(fit_hand, posed(step), view, {}, equations);
      return equations.cost;
    });
    const double contour = largest_bend([&](int step) {
      FrameEquations equations;
      add_contour_term(fit_hand, posed(step), view, {.sigma = 0.0025, .violation_sigma = 0.008},
                       equations);
      return equations.cost;
    });
    EXPECT_LT(border, 0.3 * contour);
  }
}

TEST(BorderTerm, GradientIsTheSlopeOfTheEnergy) {
  const HandModel& hand = test::coarse_hand();
  const HandPose truth = test::grasping_pose(0.2);
  const FitView view = border_view(hand, truth, test::orthogonal_rig(0.8)[0]);
  for (const double shift : {-0.0015, 0.0015}) {
    HandPose shifted = truth;
    shifted.world_from_hand.translation.x() += shift;
    const auto energy = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
      HandPose pose = shifted;
      pose.world_from_hand.translation.x() += x[0];
      return Eigen::VectorXd::Constant(1, border_equations(hand, pose, view).cost);
    };
    const double slope = finite_difference_jacobian(energy, Eigen::VectorXd::Zero(1), 2e-4)(0, 0);
    EXPECT_NEAR(border_equations(hand, shifted, view).gradient[3], slope, 0.15 * std::abs(slope));
    EXPECT_GT(slope * shift, 0.0) << "back to the truth is better";
  }
}

TEST(BorderTerm, ASceneTenTimesAsLargeHasTheSameEnergy) {
  const HandModel& hand = test::coarse_hand();
  const HandModel large = scaled(hand, 10.0);
  const HandPose truth = test::grasping_pose(0.2), large_truth = test::grasping_pose(0.2, 10.0);
  HandPose bent = truth, large_bent = large_truth;
  bent.angles.array() += 0.05;
  large_bent.angles.array() += 0.05;
  const double cost =
      border_equations(hand, bent, border_view(hand, truth, test::orthogonal_rig(0.8)[0])).cost;
  const double large_cost =
      border_equations(large, large_bent,
                       border_view(large, large_truth, test::orthogonal_rig(8.0)[0]))
          .cost;
  EXPECT_NEAR(large_cost, cost, 1e-6 * cost);
}

TEST(BorderTerm, BordersWithUnknownPixelsPullNothing) {
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
      border_equations(hand, shifted, make_fit_view(camera, std::move(all_unknown)));
  EXPECT_EQ(equations.gradient.norm(), 0.0);
}

}  // namespace
}  // namespace tegata
