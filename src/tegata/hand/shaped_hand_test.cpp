// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/shaped_hand.h"

#include <gtest/gtest.h>

#include "tegata/base/error.h"
#include "tegata/base/random.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/hand/test_hand.h"
#include "tegata/math/finite_difference.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

const ShapedHand& coarse(Side side) {
  static const ShapedHand right(Side::right, {.cell_size = 0.004, .triangle_count = 600});
  static const ShapedHand left(Side::left, {.cell_size = 0.004, .triangle_count = 600});
  return side == Side::right ? right : left;
}

ShapeParameters random_shape_parameters(std::uint64_t seed) {
  Random random(seed);
  ShapeParameters parameters = shape_prior().mean;
  for (int i = 0; i < kShapeParameterCount; ++i) {
    parameters[i] += 1.5 * random.normal() * shape_prior().deviation[i];
  }
  return parameters;
}

/// All vertices, then all keypoints, one after the other.
Eigen::VectorXd stacked(const std::vector<Eigen::Vector3d>& vertices,
                        const std::array<Eigen::Vector3d, kKeypointCount>& keypoints) {
  Eigen::VectorXd all(3 * static_cast<Eigen::Index>(vertices.size() + keypoints.size()));
  Eigen::Index at = 0;
  for (const Eigen::Vector3d& point : vertices) all.segment<3>(3 * at++) = point;
  for (const Eigen::Vector3d& point : keypoints) all.segment<3>(3 * at++) = point;
  return all;
}

TEST(ShapedHand, BasisIsTheDerivativeOfRestSurfaceAndJoints) {
  for (const Side side : {Side::right, Side::left}) {
    const ShapeParameters at = random_shape_parameters(side == Side::right ? 1 : 2);
    const Eigen::MatrixXd numeric = finite_difference_jacobian(
        [&](const Eigen::VectorXd& x) {
          const HandModel model = coarse(side).model(shape_from_parameters(x));
          return stacked(model.rest_surface.vertices, model.skeleton.keypoints);
        },
        at);
    const ShapeBasis basis = coarse(side).basis(at);
    Eigen::Index row = 0;
    double worst = 0.0;
    for (const ShapeJacobian& jacobian : basis.vertices) {
      worst = std::max(worst, (jacobian - numeric.middleRows<3>(3 * row++)).cwiseAbs().maxCoeff());
    }
    for (const ShapeJacobian& jacobian : basis.keypoints) {
      worst = std::max(worst, (jacobian - numeric.middleRows<3>(3 * row++)).cwiseAbs().maxCoeff());
    }
    EXPECT_LT(worst, 1e-8);
  }
}

TEST(PosedShape, JacobianIsTheDerivativeOfThePosedSurfaceAndJoints) {
  for (const Side side : {Side::right, Side::left}) {
    const ShapeParameters at = random_shape_parameters(side == Side::right ? 3 : 4);
    const HandPose pose{{so3_exp({0.4, -1.0, 0.7}), {0.1, -0.2, 0.9}}, random_angles(5)};
    const Eigen::MatrixXd numeric = finite_difference_jacobian(
        [&](const Eigen::VectorXd& x) {
          const HandModel model = coarse(side).model(shape_from_parameters(x));
          const PosedHand posed(model, pose);
          return stacked(posed.vertices(), posed.keypoints());
        },
        at);
    const HandModel model = coarse(side).model(shape_from_parameters(at));
    const ShapeBasis basis = coarse(side).basis(at);
    const PosedShape posed(model, basis, pose);
    Eigen::Index row = 0;
    double worst = 0.0;
    for (std::size_t i = 0; i < model.links.size(); ++i) {
      worst = std::max(
          worst,
          (posed.vertex_jacobian(i) - numeric.middleRows<3>(3 * row++)).cwiseAbs().maxCoeff());
    }
    for (int k = 0; k < kKeypointCount; ++k) {
      worst = std::max(
          worst,
          (posed.keypoint_jacobian(k) - numeric.middleRows<3>(3 * row++)).cwiseAbs().maxCoeff());
    }
    EXPECT_LT(worst, 1e-8);
  }
}

TEST(ShapedHand, TrianglesAndLinksDoNotChangeWithTheShape) {
  const HandModel mean = coarse(Side::right).model(HandShape());
  const HandModel other = coarse(Side::right).model(HandShape::percentile(95, Sex::male));
  EXPECT_EQ(mean.rest_surface.triangles, other.rest_surface.triangles);
  EXPECT_NE(mean.rest_surface.vertices, other.rest_surface.vertices);
}

TEST(ShapedHand, ScaleScalesEveryVertex) {
  ShapeParameters parameters = random_shape_parameters(6);
  const HandModel small = coarse(Side::right).model(shape_from_parameters(parameters));
  parameters[0] *= 1.07;
  const HandModel large = coarse(Side::right).model(shape_from_parameters(parameters));
  for (std::size_t i = 0; i < small.links.size(); ++i) {
    EXPECT_LT((large.rest_surface.vertices[i] - 1.07 * small.rest_surface.vertices[i]).norm(),
              1e-12);
  }
}

// A longer bone or thicker digit moves nothing but that digit, and what lies along a longer bone.
TEST(ShapedHand, ADigitsSizesMoveNoOther) {
  const HandModel mean = coarse(Side::right).model(HandShape());
  HandShape shape;
  shape.digit_thickness[2] = 1.2;
  shape.bone_lengths[7] = 1.2;
  const HandModel other = coarse(Side::right).model(shape);
  double farthest = 0.0;
  for (std::size_t i = 0; i < mean.links.size(); ++i) {
    bool is_linked = false;
    for (std::size_t link = 0; link < 4; ++link) {
      const int bone = mean.links[i].bones[link];
      is_linked = is_linked || (mean.links[i].weights[link] > 0.0 && bone >= 7 && bone <= 9);
    }
    const double moved = (mean.rest_surface.vertices[i] - other.rest_surface.vertices[i]).norm();
    farthest = std::max(farthest, moved);
    if (!is_linked) {
      EXPECT_EQ(moved, 0.0);
    }
  }
  EXPECT_GT(farthest, 0.15 * bone_length(HandShape(), 8));
}

// Where a flat finger bends does not show: only with what bends may the surface change.
TEST(ShapedHand, AKnuckleFartherOutLeavesTheRestOfAFlatHandWhereItIs) {
  HandShape shape;
  shape.metacarpal_lengths[1] = 1.1;
  const double farther = 0.1 * right_skeleton(HandShape()).keypoints[9].y();
  shape.bone_lengths[6] -= farther / bone_length(HandShape(), 7);
  const HandModel before = coarse(Side::right).model(HandShape());
  const HandModel after = coarse(Side::right).model(shape);
  const HandPose flat{{}, JointAngles::Zero()};
  const PosedHand one(before, flat), other(after, flat);
  for (std::size_t k = 0; k < kKeypointCount; ++k) {
    const double moved = (other.keypoints()[k] - one.keypoints()[k]).norm();
    EXPECT_NEAR(moved, k == 9 ? farther : 0.0, 1e-9);
  }
  double farthest = 0.0, across = 0.0;
  for (std::size_t i = 0; i < before.links.size(); ++i) {
    const Eigen::Vector3d moved = other.vertices()[i] - one.vertices()[i];
    farthest = std::max(farthest, moved.norm());
    across = std::max(across, moved.cwiseAbs().dot(Eigen::Vector3d(1.0, 0.0, 1.0)));
    for (std::size_t link = 0; link < 4; ++link) {
      const bool is_outer = before.links[i].bones[link] == 8 || before.links[i].bones[link] == 9;
      if (is_outer && before.links[i].weights[link] == 1.0) {
        EXPECT_LT(moved.norm(), 1e-9);
      }
    }
  }
  EXPECT_GT(farthest, 0.5 * farther);
  EXPECT_LT(across, 0.15 * farther);  // where palm and finger run together
}

TEST(ShapedHand, HandsOfAllPeopleKeepTheirSurfaceRightSideOut) {
  for (const HandShape& shape :
       {HandShape::percentile(1, Sex::female), HandShape::percentile(99, Sex::male),
        shape_from_parameters(random_shape_parameters(7)),
        shape_from_parameters(random_shape_parameters(8))}) {
    const HandModel mean = built_in_hand(HandShape(), Side::right);
    const HandModel model = built_in_hand(shape, Side::right);
    const TriangleMesh& surface = model.rest_surface;
    std::size_t turned = 0;
    for (std::size_t i = 0; i < surface.normals.size(); ++i) {
      turned += surface.normals[i].dot(mean.rest_surface.normals[i]) < 0.7 ? 1U : 0U;
    }
    EXPECT_LT(turned, surface.normals.size() / 150);
  }
}

TEST(ShapedHand, RefusesShapesThatAreNotHands) {
  HandShape shape;
  shape.bone_lengths[4] = 2.0;
  EXPECT_THROW(coarse(Side::right).model(shape), Error);
}

}  // namespace
}  // namespace tegata
