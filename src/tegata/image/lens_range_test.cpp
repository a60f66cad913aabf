// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/image/lens_range.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tegata {
namespace {

TEST(LensRange, EndsWhereTheRadialPolynomialTurnsBack) {
  Camera camera;
  camera.fx = camera.fy = 100.0;
  camera.distortion = {-0.3};  // r - 0.3 r^3 turns back at r = 1 / sqrt(0.9)
  EXPECT_NEAR(invertible_radius(camera), 1.0 / std::sqrt(0.9), 0.006);
  const LensRange range(camera);
  EXPECT_TRUE(range.contains({0.0, 104.0}));
  EXPECT_FALSE(range.contains({0.0, 107.0}));
}

TEST(LensRange, HasNoEndForAnIdealLensOrAPincushion) {
  Camera camera;
  camera.fx = camera.fy = 100.0;
  EXPECT_TRUE(std::isinf(invertible_radius(camera)));
  EXPECT_TRUE(LensRange(camera).contains({1e9, 0.0}));
  camera.distortion = {0.3};
  EXPECT_TRUE(std::isinf(invertible_radius(camera)));
}

}  // namespace
}  // namespace tegata
