// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/math/rigid3d.h"

#include <gtest/gtest.h>

#include "tegata/base/error.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

const Rigid3d kTransform{so3_exp({0.3, -1.2, 0.7}), {0.1, -2.0, 30.0}};

TEST(Rigid3d, InverseUndoesIt) {
  const Eigen::Vector3d point(1.0, 2.0, 3.0);
  EXPECT_LT((kTransform.inverse() * (kTransform * point) - point).norm(), 1e-12);
  EXPECT_LT(((kTransform * kTransform.inverse()) * point - point).norm(), 1e-12);
}

TEST(Rigid3d, RotationAboutKeepsItsCenter) {
  const Eigen::Vector3d center(1.0, -1.0, 4.0);
  EXPECT_LT((rotation_about(center, {0.0, 0.5, 1.0}) * center - center).norm(), 1e-12);
}

TEST(AlignPoints, RecoversAKnownTransform) {
  const Eigen::Matrix3Xd points_in_a = Eigen::Matrix3Xd::Random(3, 7);
  Eigen::Matrix3Xd points_in_b(3, 7);
  for (int i = 0; i < 7; ++i) points_in_b.col(i) = kTransform * Eigen::Vector3d(points_in_a.col(i));
  const Rigid3d found = align_points(points_in_a, points_in_b);
  EXPECT_LT(found.rotation.angularDistance(kTransform.rotation), 1e-9);
  EXPECT_LT((found.translation - kTransform.translation).norm(), 1e-9);
}

TEST(AlignPoints, NeverAnswersWithAReflection) {
  const Eigen::Matrix3Xd points_in_a = Eigen::Matrix3Xd::Random(3, 7);
  Eigen::Matrix3Xd mirrored = points_in_a;
  mirrored.row(0) *= -1.0;
  const Rigid3d found = align_points(points_in_a, mirrored);
  EXPECT_NEAR(found.rotation.toRotationMatrix().determinant(), 1.0, 1e-9);
}

TEST(AlignPoints, RefusesFewerThanThreePoints) {
  EXPECT_THROW(align_points(Eigen::Matrix3Xd(3, 2), Eigen::Matrix3Xd(3, 2)), Error);
}

}  // namespace
}  // namespace tegata
