// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/calibrate/tangency.h"

#include <gtest/gtest.h>

#include "tegata/base/angle.h"

namespace tegata {
namespace {

// Two cameras side by side that look along z.
CameraRig side_by_side() {
  CameraRig rig(2);
  rig[1].camera_from_world.translation = {-0.2, 0.0, 0.0};
  return rig;
}

OutlineRays outline(const std::vector<Eigen::Vector2d>& corners) {
  OutlineRays rays;
  for (const Eigen::Vector2d& corner : corners) {
    rays.rays.push_back(Eigen::Vector3d(corner.x(), corner.y(), 1.0).normalized());
  }
  rays.cut.assign(corners.size(), false);
  return rays;
}

// A hand whose fingertips, which reach up to 0.3, have left the first picture on the right: what is
// left of it ends at 0.24, beside where the picture's edge cuts the fingers.
TEST(Tangency, WhatReachesPastATangentBeyondThePicturesEdgeIsNoContradiction) {
  OutlineRays left = outline({{-0.2, -0.1}, {0.35, -0.05}, {0.35, 0.22}, {0.25, 0.24}});
  const OutlineRays right = outline({{-0.4, -0.1}, {0.1, -0.1}, {0.3, 0.3}});
  const std::vector<PairTangency> whole = pair_tangencies(side_by_side(), {{left, right}});
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(whole[0].count, 2u);
  left.cut[1] = left.cut[2] = true;
  const std::vector<PairTangency> cut = pair_tangencies(side_by_side(), {{left, right}});
  EXPECT_TRUE(cut.empty() || cut[0].median < 0.1 * kDegree);
}

// An arm that enters the first picture from below leaves the fingertips' tangent as it is.
TEST(Tangency, ATangentFarFromWhereASilhouetteIsCutCounts) {
  OutlineRays left = outline({{-0.1, -0.3}, {0.0, -0.3}, {0.1, 0.1}, {0.0, 0.3}});
  const OutlineRays right = outline({{-0.3, -0.5}, {-0.2, -0.5}, {-0.1, 0.1}, {-0.2, 0.3}});
  left.cut[0] = left.cut[1] = true;
  const std::vector<PairTangency> pairs = pair_tangencies(side_by_side(), {{left, right}});
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].count, 1u);
  EXPECT_LT(pairs[0].median, 0.1 * kDegree);
}

}  // namespace
}  // namespace tegata
