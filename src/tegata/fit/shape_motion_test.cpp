// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/shape_motion.h"

#include <gtest/gtest.h>

#include "tegata/fit/test_scene.h"
#include "tegata/hand/scaled_hand.h"
#include "tegata/math/finite_difference.h"

namespace tegata {
namespace {

const Eigen::RowVector3d kAlong(0.3, -0.5, 0.8);

TEST(ScaleMotion, IsTheSlopeOfEveryVertex) {
  const HandPose pose = test::grasping_pose(0.3);
  const double scale = 1.1;
  const HandModel model = scaled(test::coarse_hand(), scale);
  const PosedHand posed(model, pose);
  const ScaleMotion motion(posed, scale);
  for (std::size_t vertex = 0; vertex < posed.vertices().size(); vertex += 37) {
    const auto along = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
      const HandModel other = scaled(test::coarse_hand(), x[0]);
      return kAlong * PosedHand(other, pose).vertices()[vertex];
    };
    const Eigen::MatrixXd slope =
        finite_difference_jacobian(along, Eigen::VectorXd::Constant(1, scale), 1e-4);
    ASSERT_NEAR(motion.row(vertex, kAlong)[0], slope(0, 0), 1e-8) << vertex;
  }
}

TEST(ParameterMotion, IsTheSlopeOfEveryVertex) {
  const ShapedHand shapes(Side::right, {.cell_size = 0.005, .triangle_count = 600});
  const HandPose pose = test::grasping_pose(0.3);
  ShapeParameters parameters = shape_prior().mean + 0.7 * shape_prior().deviation;
  const HandModel model = shapes.model(shape_from_parameters(parameters));
  const ShapeBasis basis = shapes.basis(parameters);
  const ParameterMotion motion(model, basis, pose);
  for (std::size_t vertex = 0; vertex < model.links.size(); vertex += 31) {
    const auto along = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
      const HandModel other = shapes.model(shape_from_parameters(x));
      return kAlong * PosedHand(other, pose).vertices()[vertex];
    };
    const Eigen::MatrixXd slope = finite_difference_jacobian(along, parameters, 1e-5);
    ASSERT_LT((motion.row(vertex, kAlong) - slope).norm(), 1e-6) << vertex;
  }
}

}  // namespace
}  // namespace tegata
