// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/camera/lens.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tegata {
namespace {

TEST(Lens, FisheyeIsOpenCvsFormula) {
  const Lens lens{LensModel::fisheye, {0.02, -0.01, 0.003, -0.0005}};
  const double a = std::atan(0.5);  // of (0.3, 0.4)
  const double radius = a + 0.02 * std::pow(a, 3) - 0.01 * std::pow(a, 5) + 0.003 * std::pow(a, 7) -
                        0.0005 * std::pow(a, 9);
  const Eigen::Vector2d seen = lens.distort({0.3, 0.4});
  EXPECT_NEAR(seen.x(), 0.6 * radius, 1e-15);
  EXPECT_NEAR(seen.y(), 0.8 * radius, 1e-15);
  EXPECT_EQ(lens.distort({0.0, 0.0}), Eigen::Vector2d::Zero());
}

TEST(Lens, EachModelsInverseUndoesIt) {
  for (const Lens& lens :
       {Lens{LensModel::fisheye, {0.02, -0.01, 0.003, -0.0005}}, Lens{LensModel::fisheye, {}},
        Lens{LensModel::perspective, {-0.3, 0.1, 1e-3, -2e-3, -0.02}},
        Lens{LensModel::perspective, {0.4, 0.1, 0, 0, 0.01, 0.7, 0.2, 0.03}},
        Lens{LensModel::perspective, {-0.2, 0.05, 0, 0, 0, 0, 0, 0, 1e-3, -2e-3, 3e-3, 1e-4}}}) {
    for (const double x : {-0.5, -0.1, 0.0, 0.4}) {
      const Eigen::Vector2d ideal(x, 0.3 - 0.5 * x);
      EXPECT_LT((lens.undistort(lens.distort(ideal)) - ideal).norm(), 1e-10) << x;
    }
  }
}

TEST(Lens, FisheyeHoldsForRaysFarOffTheAxis) {
  const Lens lens{LensModel::fisheye, {-0.02, 0.004, 0.0, 0.0}};
  for (const double degrees : {70.0, 80.0, 88.0}) {
    const Eigen::Vector2d ideal(std::tan(degrees / 180.0 * 3.14159265358979), 0.0);
    EXPECT_NEAR(lens.undistort(lens.distort(ideal)).x() / ideal.x(), 1.0, 1e-8) << degrees;
  }
}

TEST(Lens, RadiiBeyondThePictureOfAFisheyeStayFinite) {
  const Lens lens{LensModel::fisheye, {-0.3, 0.0, 0.0, 0.0}};  // turns back at 60 degrees
  EXPECT_TRUE(lens.undistort({5.0, 5.0}).allFinite());
  EXPECT_FALSE(lens.is_ideal());
  EXPECT_FALSE((Lens{LensModel::fisheye, {}}).is_ideal());
  EXPECT_TRUE(Lens{}.is_ideal());
}

}  // namespace
}  // namespace tegata
