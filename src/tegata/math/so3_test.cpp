// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/math/so3.h"

#include <gtest/gtest.h>

#include <numbers>

namespace tegata {
namespace {

TEST(So3, LogUndoesExpFromTinyToNearlyHalfATurn) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1.0, -2.0, 0.5).normalized();
  for (const double angle : {0.0, 1e-12, 1e-6, 1e-4, 0.1, 1.0, std::numbers::pi - 1e-6}) {
    const Eigen::Vector3d axis_angle = angle * axis;
    EXPECT_LT((so3_log(so3_exp(axis_angle)) - axis_angle).norm(), 1e-9) << "angle " << angle;
  }
}

TEST(So3, LogTakesTheShortWayForEitherSignOfTheQuaternion) {
  const Eigen::Quaterniond rotation = so3_exp({0.0, 0.4, 0.0});
  const Eigen::Quaterniond negated(-rotation.w(), -rotation.x(), -rotation.y(), -rotation.z());
  EXPECT_LT((so3_log(negated) - Eigen::Vector3d(0.0, 0.4, 0.0)).norm(), 1e-12);
}

TEST(So3, ExpIsAUnitQuaternionAndAgreesWithAngleAxis) {
  const Eigen::Vector3d axis_angle(0.2, -0.8, 1.1);
  const Eigen::AngleAxisd expected(axis_angle.norm(), axis_angle.normalized());
  EXPECT_NEAR(so3_exp(axis_angle).norm(), 1.0, 1e-12);
  EXPECT_LT(so3_exp(axis_angle).angularDistance(Eigen::Quaterniond(expected)), 1e-12);
}

TEST(So3, CrossMatrixIsTheCrossProduct) {
  const Eigen::Vector3d a(1.0, 2.0, 3.0), b(-2.0, 0.5, 4.0);
  EXPECT_LT((cross_matrix(a) * b - a.cross(b)).norm(), 1e-12);
}

}  // namespace
}  // namespace tegata
