// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/hull_term.h"

#include <gtest/gtest.h>

#include "tegata/base/error.h"
#include "tegata/fit/test_scene.h"
#include "tegata/hand/scaled_hand.h"

namespace tegata {
namespace {

// What a micrometre everywhere would come to, by the options' 4 mm.
constexpr double kNoGradient = 1e-6 / (0.004 * 0.004);

TEST(HullTerm, IsZeroOnTheHandsOwnSurface) {
  const HandModel& hand = test::coarse_hand();
  const PosedHand posed(hand, test::grasping_pose(0.0));
  FrameEquations equations;
  add_hull_term(FitHand(hand), posed, HullTarget(posed.surface()), {}, equations);
  EXPECT_LT(equations.gradient.norm(), kNoGradient);
}

TEST(HullTerm, PullsTowardsTheHull) {
  const HandModel& hand = test::coarse_hand();
  const HandPose truth = test::grasping_pose(0.0);
  HandPose shifted = truth;
  shifted.world_from_hand.translation += Eigen::Vector3d(0.004, 0.0, 0.0);
  FrameEquations equations;
  add_hull_term(FitHand(hand), PosedHand(hand, shifted),
                HullTarget(PosedHand(hand, truth).surface()), {}, equations);
  EXPECT_GT(equations.gradient[3], 0.0);  // going back lowers the energy
}

TEST(HullTerm, UnprovenPartsAttractNothing) {
  const HandModel& hand = test::coarse_hand();
  const PosedHand posed(hand, test::grasping_pose(0.0));
  TriangleMesh hull = posed.surface();
  const std::size_t count = hull.vertices.size();
  hull.unproven.assign(count, 0);
  // A sheet beside the hand that only unknown pixels keep.
  for (int i = 0; i < 200; ++i) {
    hull.vertices.emplace_back(0.2, 0.001 * i, 0.0);
    hull.normals.emplace_back(1.0, 0.0, 0.0);
    hull.unproven.push_back(1);
  }
  FrameEquations equations;
  add_hull_term(FitHand(hand), posed, HullTarget(hull), {}, equations);
  EXPECT_LT(equations.gradient.norm(), kNoGradient);
}

TEST(HullTerm, PullsTheScaleTowardsTheHull) {
  const HandModel& hand = test::coarse_hand();
  const HandPose pose = test::grasping_pose(0.0);
  const HullTarget hull(PosedHand(hand, pose).surface());
  for (const double scale : {0.97, 1.03}) {
    const HandModel model = scaled(hand, scale);
    const PosedHand posed(model, pose);
    const ScaleMotion motion(posed, scale);
    FrameEquations equations(1), without;
    add_hull_term(FitHand(model), posed, hull, {}, equations, &motion);
    add_hull_term(FitHand(model), posed, hull, {}, without);
    EXPECT_GT(equations.shape_gradient[0] * (scale - 1.0), 0.0) << scale;
    EXPECT_GT(equations.shape_hessian(0, 0), 0.0);
    EXPECT_EQ(equations.gradient, without.gradient);
    EXPECT_EQ(equations.cost, without.cost);
  }
}

TEST(HullTarget, RefusesAHullWithoutProvenVerticesOrNormals) {
  TriangleMesh hull = test::coarse_hand().rest_surface;
  hull.normals = vertex_normals(hull);
  hull.unproven.assign(hull.vertices.size(), 1);
  EXPECT_THROW(HullTarget{hull}, Error);
  hull.unproven.clear();
  hull.normals.clear();
  EXPECT_THROW(HullTarget{hull}, Error);
}

}  // namespace
}  // namespace tegata
