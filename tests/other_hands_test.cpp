// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// The built-in hand against hands of others' making: its shape and angles fitted to their surfaces.
#include <gtest/gtest.h>

#include <filesystem>

#include "tegata/base/random.h"
#include "tegata/fit/surface_fit.h"
#include "tegata/gltf/hand_gltf.h"
#include "tegata/take/makehuman_for_tests.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

/// Fits with keypoints that are off by 3 mm along each axis, and holds the fit against those that
/// are not.
void expect_close_fit(Side side, const HandSurface& given) {
  HandSurface rough = given;
  Random random(1);
  for (Eigen::Vector3d& keypoint : rough.keypoints) {
    for (int axis = 0; axis < 3; ++axis) keypoint[axis] += 0.003 * random.normal();
  }
  const SurfaceFit fit = fit_surface(ShapedHand(side), rough);
  const PosedHand posed(fit.model, fit.pose);
  double joint_error = 0.0;
  for (std::size_t k = 1; k < kKeypointCount; ++k) {
    if (k % 4 == 0) continue;
    joint_error += (posed.keypoints()[k] - given.keypoints[k]).norm() / (3.0 * kDigitCount);
  }
  testing::Test::RecordProperty("mean_distance_mm", std::to_string(1e3 * fit.mean_distance));
  testing::Test::RecordProperty("distance_95_mm", std::to_string(1e3 * fit.distance_95));
  testing::Test::RecordProperty("joint_error_mm", std::to_string(1e3 * joint_error));
  EXPECT_LT(fit.mean_distance, 0.002);
  EXPECT_LT(fit.distance_95, 0.005);
  EXPECT_LT(joint_error, 0.005);
}

class WebxrGenericHand : public testing::TestWithParam<Side> {};

TEST_P(WebxrGenericHand, IsReachedByTheBuiltInHand) {
  const fs::path file = fs::path(TEGATA_SOURCE_DIR) /
                        "build/assets/node_modules/@webxr-input-profiles/assets/dist/profiles" /
                        "generic-hand" / (std::string(side_name(GetParam())) + ".glb");
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not there: scripts/fetch_test_assets.sh";
  const HandModel model = read_hand_gltf(file, GetParam());
  const PosedHand posed(model, HandPose{{}, model.rest_angles});
  expect_close_fit(GetParam(), {posed.surface(), posed.keypoints()});
}

INSTANTIATE_TEST_SUITE_P(BothSides, WebxrGenericHand, testing::Values(Side::right, Side::left),
                         [](const auto& info) { return std::string(side_name(info.param)); });

TEST(MakeHumanHandSurface, IsReachedByTheBuiltInHand) {
  const fs::path folder = fs::path(TEGATA_DATA_DIR) / "makehuman_hand";
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";
  const ScannedHand scan = makehuman_hand(folder).scan;
  expect_close_fit(Side::right, {scan.surface, scan.keypoints});
}

}  // namespace
}  // namespace tegata
