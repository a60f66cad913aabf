// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// The WebXR generic hand and the glTF validator, both from npm (scripts/fetch_test_assets.sh).
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tegata/gltf/hand_gltf.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/hand/test_hand.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

class WebxrHand : public testing::TestWithParam<Side> {
 protected:
  WebxrHand()
      : folder_(fs::temp_directory_path() / ("tegata_webxr_hand_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~WebxrHand() override { fs::remove_all(folder_); }

  static fs::path modules() {
    return fs::path(TEGATA_SOURCE_DIR) / "build" / "assets" / "node_modules";
  }
  static fs::path generic_hand() {
    return modules() / "@webxr-input-profiles" / "assets" / "dist" / "profiles" / "generic-hand" /
           (std::string(side_name(GetParam())) + ".glb");
  }
  /// Whether the official validator finds no error; what it finds is printed.
  static bool is_valid(const fs::path& file) {
    const std::string script =
        "const bytes = new Uint8Array(require('fs').readFileSync(process.argv[1]));"
        "require('gltf-validator').validateBytes(bytes).then(report => {"
        "  if (report.issues.numErrors + report.issues.numWarnings > 0)"
        "    console.log(JSON.stringify(report.issues));"
        "  process.exit(report.issues.numErrors > 0 ? 1 : 0); });";
    return std::system(("NODE_PATH='" + modules().string() + "' node -e \"" + script + "\" '" +
                        file.string() + "'")
                           .c_str()) == 0;
  }

  fs::path folder_;
};

/// The greatest distance between vertices of two hands of the same topology in a pose.
double greatest_distance(const HandModel& a, const HandModel& b, const HandPose& pose) {
  const PosedHand posed_a(a, pose), posed_b(b, pose);
  double greatest = 0.0;
  for (std::size_t i = 0; i < posed_a.vertices().size(); ++i) {
    greatest = std::max(greatest, (posed_a.vertices()[i] - posed_b.vertices()[i]).norm());
  }
  return greatest;
}

HandPose bent_pose() {
  return {{so3_exp({0.4, -1.0, 2.0}), {0.1, -0.2, 0.9}},
          0.6 * angle_limits().upper + 0.4 * relaxed_angles()};
}

TEST_P(WebxrHand, LoadsAndBendsTowardsThePalm) {
  if (!fs::exists(generic_hand())) GTEST_SKIP() << generic_hand() << " is absent";
  const HandModel hand = read_hand_gltf(generic_hand(), GetParam());
  EXPECT_GT(hand.rest_surface.vertices.size(), 1000U);
  EXPECT_GT(enclosed_volume(hand.rest_surface), 1e-4);
  const double length = hand.skeleton.keypoints[12].y() - hand.skeleton.keypoints[0].y();
  EXPECT_GT(length, 0.14);
  EXPECT_LT(length, 0.22);
  // At zero angles the fingers are straight and beside each other; bent, their tips come towards
  // the palm, on which z is negative.
  const auto flat = posed_keypoints(hand.skeleton, HandPose());
  HandPose fist;
  fist.angles = 0.8 * angle_limits().upper;
  const auto bent = posed_keypoints(hand.skeleton, fist);
  for (const std::size_t tip : {8U, 12U, 16U, 20U}) {
    EXPECT_LT(bent[tip].z(), flat[tip].z() - 0.01);
    EXPECT_LT(bent[tip].y(), flat[tip].y() - 0.06);
  }
}

TEST_P(WebxrHand, IsRefusedAsTheOtherHand) {
  if (!fs::exists(generic_hand())) GTEST_SKIP() << generic_hand() << " is absent";
  const Side other = GetParam() == Side::right ? Side::left : Side::right;
  EXPECT_ANY_THROW(read_hand_gltf(generic_hand(), other));
}

TEST_P(WebxrHand, RoundTripMovesNoVertexInAnyPose) {
  if (!fs::exists(generic_hand())) GTEST_SKIP() << generic_hand() << " is absent";
  const HandModel read = read_hand_gltf(generic_hand(), GetParam());
  write_hand_gltf(read, {}, folder_ / "again.glb");
  const HandModel again = read_hand_gltf(folder_ / "again.glb", GetParam());
  ASSERT_EQ(again.rest_surface.triangles, read.rest_surface.triangles);
  EXPECT_LT(greatest_distance(read, again, {Rigid3d(), read.rest_angles}), 1e-5);
  EXPECT_LT(greatest_distance(read, again, HandPose()), 1e-5);
  EXPECT_LT(greatest_distance(read, again, bent_pose()), 1e-5);
}

TEST_P(WebxrHand, TheValidatorFindsNoErrorInWhatIsWritten) {
  if (!fs::exists(modules() / "gltf-validator")) {
    GTEST_SKIP() << "gltf-validator is absent from " << modules();
  }
  if (std::system("node --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "node is absent";
  const std::vector<HandKeyframe> keyframes = {{0.0, HandPose()}, {0.04, bent_pose()}};
  write_hand_gltf(built_in_hand(HandShape(), GetParam()), keyframes, folder_ / "built_in.glb");
  EXPECT_TRUE(is_valid(folder_ / "built_in.glb"));
  // Some of its vertices are linked to one bone twice.
  write_hand_gltf(test_hand(), {}, folder_ / "small.glb");
  EXPECT_TRUE(is_valid(folder_ / "small.glb"));
  if (!fs::exists(generic_hand())) GTEST_SKIP() << generic_hand() << " is absent";
  const HandModel read = read_hand_gltf(generic_hand(), GetParam());
  write_hand_gltf(read, keyframes, folder_ / "webxr.glb");
  EXPECT_TRUE(is_valid(folder_ / "webxr.glb"));
}

INSTANTIATE_TEST_SUITE_P(Sides, WebxrHand, testing::Values(Side::right, Side::left),
                         [](const auto& info) { return std::string(side_name(info.param)); });

}  // namespace
}  // namespace tegata
