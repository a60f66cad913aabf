// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/hand_model.h"

#include <gtest/gtest.h>

#include <limits>

#include "tegata/base/error.h"
#include "tegata/hand/skin_rows.h"
#include "tegata/hand/test_hand.h"
#include "tegata/math/finite_difference.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

using Step = Eigen::Matrix<double, kHandParameterCount, 1>;

TEST(PosedHand, AtRestIsTheRestSurface) {
  const HandModel model = test_hand();
  HandPose pose;
  pose.angles = model.rest_angles;
  const PosedHand posed(model, pose);
  for (std::size_t i = 0; i < posed.vertices().size(); ++i) {
    EXPECT_LT((posed.vertices()[i] - model.rest_surface.vertices[i]).norm(), 1e-12);
    EXPECT_LT((posed.normals()[i] - model.rest_surface.normals[i]).norm(), 1e-12);
  }
}

TEST(PosedHand, VertexIsTheWeightedDivisionOfItsBonesImages) {
  const HandModel model = test_hand();
  const HandPose pose = random_pose(5);
  const PosedHand posed(model, pose);
  const auto to = bone_transforms(model.skeleton, pose.angles);
  const auto from = bone_transforms(model.skeleton, model.rest_angles);
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    Eigen::Vector3d expected = Eigen::Vector3d::Zero();
    for (std::size_t j = 0; j < 2; ++j) {
      const auto bone = static_cast<std::size_t>(model.links[i].bones[j]);
      expected += model.links[i].weights[j] *
                  (pose.world_from_hand *
                   (to[bone] * (from[bone].inverse() * model.rest_surface.vertices[i])));
    }
    EXPECT_LT((posed.vertices()[i] - expected).norm(), 1e-12) << i;
    EXPECT_NEAR(posed.normals()[i].norm(), 1.0, 1e-12) << i;
  }
}

Eigen::VectorXd flat(const std::vector<Eigen::Vector3d>& points) {
  return Eigen::Map<const Eigen::VectorXd>(points[0].data(),
                                           static_cast<Eigen::Index>(3 * points.size()));
}

TEST(PosedHand, JacobiansOfVerticesAndNormalsAreThoseOfFiniteDifferences) {
  for (const HandModel& model : hands_to_check()) {
    for (const HandPose& pose : poses_to_check(model)) {
      const auto difference = [&](auto&& points_of) {
        return finite_difference_jacobian(
            [&](const Eigen::VectorXd& step) -> Eigen::VectorXd {
              return flat(points_of(PosedHand(model, advanced(pose, step))));
            },
            Eigen::VectorXd::Zero(kHandParameterCount));
      };
      const Eigen::MatrixXd vertices =
          difference([](const PosedHand& hand) { return hand.vertices(); });
      const Eigen::MatrixXd normals =
          difference([](const PosedHand& hand) { return hand.normals(); });
      const PosedHand posed(model, pose);
      for (std::size_t i = 0; i < posed.vertices().size(); ++i) {
        const auto row = static_cast<Eigen::Index>(3 * i);
        const PointJacobian of_vertex = posed.vertex_jacobian(i) - vertices.middleRows<3>(row);
        const PointJacobian of_normal = posed.normal_jacobian(i) - normals.middleRows<3>(row);
        EXPECT_LT(of_vertex.cwiseAbs().maxCoeff(), 1e-8) << model.name << " " << i;
        EXPECT_LT(of_normal.cwiseAbs().maxCoeff(), 1e-8) << model.name << " " << i;
      }
    }
  }
}

TEST(PosedHand, KeypointJacobianIsThatOfFiniteDifferences) {
  for (const HandModel& model : hands_to_check()) {
    for (const HandPose& pose : poses_to_check(model)) {
      const Eigen::MatrixXd expected = finite_difference_jacobian(
          [&](const Eigen::VectorXd& step) -> Eigen::VectorXd {
            const auto points = posed_keypoints(model.skeleton, advanced(pose, step));
            return Eigen::Map<const Eigen::VectorXd>(points[0].data(), 3 * kKeypointCount);
          },
          Eigen::VectorXd::Zero(kHandParameterCount));
      const PosedHand posed(model, pose);
      for (int k = 0; k < kKeypointCount; ++k) {
        const PointJacobian difference =
            posed.keypoint_jacobian(k) - expected.middleRows<3>(Eigen::Index{3} * k);
        EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-8) << model.name << " " << k;
      }
    }
  }
}

TEST(PosedHand, RowsMadeOnceServeAllPoses) {
  const HandModel model = test_hand();
  const auto rows = std::make_shared<const SkinRows>(model);
  for (const HandPose& pose : poses_to_check(model)) {
    EXPECT_EQ(PosedHand(model, pose, rows).vertices(), PosedHand(model, pose).vertices());
  }
}

TEST(PosedHand, SurfaceHasTheModelsTriangles) {
  const HandModel model = test_hand();
  const TriangleMesh surface = PosedHand(model, random_pose(1)).surface();
  EXPECT_EQ(surface.triangles, model.rest_surface.triangles);
  EXPECT_EQ(surface.normals.size(), surface.vertices.size());
}

TEST(Advanced, TurnsFromTheLeftAboutTheHandsOrigin) {
  const HandPose pose = random_pose(3);
  Step step = Step::Zero();
  step.head<3>() << 0.1, 0.2, -0.3;
  step.segment<3>(3) << 1.0, 2.0, 3.0;
  step[kPoseParameterCount + 7] = 0.5;
  const HandPose next = advanced(pose, step);
  EXPECT_LT(next.world_from_hand.rotation.angularDistance(so3_exp(step.head<3>()) *
                                                          pose.world_from_hand.rotation),
            1e-12);
  EXPECT_LT((next.world_from_hand.translation - pose.world_from_hand.translation -
             Eigen::Vector3d(1.0, 2.0, 3.0))
                .norm(),
            1e-12);
  EXPECT_NEAR(next.angles[7] - pose.angles[7], 0.5, 1e-12);
}

TEST(HandModel, MirroredTwiceIsTheSame) {
  const HandModel model = test_hand(), twice = mirrored(mirrored(model));
  EXPECT_EQ(twice.rest_surface.vertices, model.rest_surface.vertices);
  EXPECT_EQ(twice.rest_surface.triangles, model.rest_surface.triangles);
  EXPECT_EQ(twice.rest_surface.normals, model.rest_surface.normals);
  EXPECT_EQ(twice.skeleton.axes, model.skeleton.axes);
}

TEST(HandModel, MirroredHandInTheSameAnglesIsTheMirrorImage) {
  const HandModel model = test_hand(), other = mirrored(model);
  HandPose pose;
  pose.angles = random_angles(4);
  const PosedHand posed(model, pose), mirror(other, pose);
  for (std::size_t i = 0; i < posed.vertices().size(); ++i) {
    const Eigen::Vector3d& vertex = posed.vertices()[i];
    const Eigen::Vector3d expected(-vertex.x(), vertex.y(), vertex.z());
    EXPECT_LT((mirror.vertices()[i] - expected).norm(), 1e-12) << i;
  }
}

TEST(HandModel, MirroredSurfaceIsNotInsideOut) {
  EXPECT_NEAR(enclosed_volume(mirrored(test_hand()).rest_surface),
              enclosed_volume(test_hand().rest_surface), 1e-15);
  EXPECT_GT(enclosed_volume(test_hand().rest_surface), 0.0);
}

TEST(HandModel, MainBoneHasTheLargestWeight) {
  SkinLinks links;
  links.bones = {3, 7, 9, 0};
  links.weights = {0.2, 0.3, 0.5, 0.0};
  EXPECT_EQ(main_bone(links), 9);
}

TEST(CheckHand, RefusesWhatDoesNotFit) {
  const HandModel good = test_hand();
  EXPECT_NO_THROW(check_hand(good));
  const auto broken = [&](auto&& change) {
    HandModel model = good;
    change(model);
    return model;
  };
  const std::vector<HandModel> bad = {
      broken([](HandModel& m) { m.links.pop_back(); }),
      broken([](HandModel& m) { m.rest_surface.normals.clear(); }),
      broken([](HandModel& m) { m.rest_surface.triangles.clear(); }),
      broken([](HandModel& m) {
        m.links[3].weights = {0.6, 0.6, 0.0, 0.0};
      }),
      broken([](HandModel& m) {
        m.links[3].weights = {1.5, -0.5, 0.0, 0.0};
      }),
      broken([](HandModel& m) { m.links[3].bones[0] = kBoneCount; }),
      broken([](HandModel& m) { m.skeleton.axes[2] *= 2.0; }),
      broken([](HandModel& m) {
        m.rest_surface.vertices[0].x() = std::numeric_limits<double>::quiet_NaN();
      }),
      broken([](HandModel& m) {
        m.skeleton.keypoints[4].x() = std::numeric_limits<double>::infinity();
      }),
  };
  for (std::size_t i = 0; i < bad.size(); ++i) EXPECT_THROW(check_hand(bad[i]), Error) << i;
}

}  // namespace
}  // namespace tegata
