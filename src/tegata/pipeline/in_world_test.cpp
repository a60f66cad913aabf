// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/in_world.h"

#include <gtest/gtest.h>

#include "tegata/hand/scaled_hand.h"
#include "tegata/math/so3.h"
#include "tegata/pipeline/fit_take.h"
#include "tegata/pipeline/test_take.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

constexpr double kScale = 10.0;
const Rigid3d kElsewhere = {so3_exp({0.4, -1.0, 2.0}), Eigen::Vector3d(80.0, -50.0, 33.0)};

Result fit_of(const std::filesystem::path& folder, double scale) {
  Take take = Take::open(folder);
  FitTakeOptions options;
  options.scale = scale;
  options.hull.voxel_size *= scale;
  return fit_take(take, test::small_hand(), options, {});
}

class AnotherWorld : public testing::Test {
 protected:
  AnotherWorld() {
    test::write_mask_take(folder_.path(), 2);
    here_ = fit_of(folder_.path(), 1.0);
    CameraRig rig = test::small_rig();
    for (Camera& camera : rig) {
      camera.camera_from_world.translation *= kScale;
      camera.camera_from_world = camera.camera_from_world * kElsewhere.inverse();
    }
    write_calibration(rig, folder_.path() / "calibration.toml");
    there_ = fit_of(folder_.path(), kScale);
  }

  TestFolder folder_;
  Result here_, there_;
};

TEST_F(AnotherWorld, HasTheSameAnswerBitByBit) {
  EXPECT_EQ(here_.grasp_angles, there_.grasp_angles);
  EXPECT_EQ(here_.grasp_standard_deviations, there_.grasp_standard_deviations);
  for (std::size_t f = 0; f < 2; ++f) {
    EXPECT_EQ(here_.frames[f].status, there_.frames[f].status);
    EXPECT_EQ(here_.frames[f].silhouette_iou, there_.frames[f].silhouette_iou);
  }
}

TEST_F(AnotherWorld, HasPosesAndLengthsOfItsOwn) {
  EXPECT_EQ(there_.model_scale, kScale);
  for (std::size_t f = 0; f < 2; ++f) {
    const ResultFrame &here = here_.frames[f], &there = there_.frames[f];
    for (std::size_t k = 0; k < kKeypointCount; ++k) {
      EXPECT_LT((kElsewhere * (kScale * here.keypoints[k]) - there.keypoints[k]).norm(), 1e-5);
    }
    const HandModel hand = scaled(test::small_hand(), kScale);
    EXPECT_LT(
        (posed_keypoints(hand.skeleton, *there.pose)[kWrist] - there.keypoints[kWrist]).norm(),
        1e-9);
    for (const auto& [camera, distance] : here.uncovered) {
      EXPECT_NEAR(kScale * distance, there.uncovered.at(camera), 1e-9);
    }
  }
}

TEST(InWorld, NormalsOfAMeshTurnWithIt) {
  const SceneFrame scene = {kElsewhere, 2.0};
  TriangleMesh mesh;
  mesh.vertices = {{1.0, 0.0, 0.0}};
  mesh.normals = {{0.0, 1.0, 0.0}};
  const TriangleMesh moved = in_world(scene, mesh);
  EXPECT_LT((moved.vertices[0] - scene.in_world(Eigen::Vector3d(1.0, 0.0, 0.0))).norm(), 1e-12);
  EXPECT_LT((moved.normals[0] - kElsewhere.rotation * Eigen::Vector3d(0.0, 1.0, 0.0)).norm(),
            1e-12);
}

}  // namespace
}  // namespace tegata
