// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/scanned_hand.h"

#include <gtest/gtest.h>

#include "tegata/hand/built_in_hand.h"
#include "tegata/math/so3.h"
#include "tegata/mesh/mesh_file.h"
#include "tegata/take/makehuman_for_tests.h"
#include "tegata/take/staged_folder.h"
#include "tegata/take/test_folder.h"
#include "tegata/take/toml_table.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

/// hand.toml beside a mesh of the given name.
std::string toml_of(const ScannedHand& scan, const std::string& mesh, double metres_per_unit) {
  std::string content =
      text("mesh = ", toml_string(mesh), "\nhand = \"", side_name(scan.side),
           "\"\nmetres_per_unit = ", toml_number(metres_per_unit), "\n[keypoints]\n");
  for (std::size_t k = 0; k < kKeypointCount; ++k) {
    const Eigen::Vector3d point = scan.keypoints[k] / metres_per_unit;
    content += text(keypoint_names()[k], " = ", toml_numbers({point.data(), 3}), "\n");
  }
  return content;
}

/// The built-in hand's surface and joints in a frame of its own, as a scanner would give them.
ScannedHand built_in_scan(Side side) {
  const HandModel model = built_in_hand(HandShape(), side);
  const HandPose pose{{so3_exp({0.3, -1.1, 0.7}), {0.5, 1.5, -0.2}}, model.rest_angles};
  ScannedHand scan;
  scan.name = "hand";
  scan.side = side;
  scan.surface = PosedHand(model, pose).surface();
  scan.keypoints = posed_keypoints(model.skeleton, pose);
  return scan;
}

/// Reads a scan through files.
HandModel read(const ScannedHand& scan, const std::string& mesh = "scan.ply",
               double metres_per_unit = 1.0) {
  const TestFolder folder;
  TriangleMesh scaled = scan.surface;
  for (Eigen::Vector3d& vertex : scaled.vertices) vertex /= metres_per_unit;
  if (mesh.ends_with(".obj")) {
    write_obj(scaled, folder / mesh);
  } else {
    write_ply(scaled, folder / mesh);
  }
  write_file(folder / "hand.toml", toml_of(scan, mesh, metres_per_unit));
  return rigged(read_scanned_hand(folder / "hand.toml"));
}

/// Reads a TOML text with the built-in hand's mesh beside it.
std::string error_with(const std::string& content) {
  const TestFolder folder;
  write_ply(built_in_scan(Side::right).surface, folder / "scan.ply");
  write_file(folder / "hand.toml", content);
  return error_of([&] { rigged(read_scanned_hand(folder / "hand.toml")); });
}

TEST(ScannedHand, TheRulesGiveTheBuiltInSurfaceItsOwnBonesAgain) {
  for (const Side side : {Side::right, Side::left}) {
    const HandModel expected = built_in_hand(HandShape(), side), got = read(built_in_scan(side));
    EXPECT_EQ(got.name, "hand");
    EXPECT_EQ(got.skeleton.side, side);
    EXPECT_EQ(got.rest_surface.triangles, expected.rest_surface.triangles);
    ASSERT_EQ(got.links.size(), expected.links.size());
    std::size_t same = 0;
    for (std::size_t i = 0; i < got.links.size(); ++i) {
      same += main_bone(got.links[i]) == main_bone(expected.links[i]) ? 1 : 0;
    }
    EXPECT_GT(static_cast<double>(same), 0.97 * static_cast<double>(got.links.size()));
    for (std::size_t k = 1; k < kKeypointCount; ++k) {
      const int near = static_cast<int>(k) - 1;
      const double length =
          (got.skeleton.keypoints[k] -
           got.skeleton.keypoints[k % 4 == 1 ? 0 : static_cast<std::size_t>(near)])
              .norm();
      EXPECT_GT(length, 0.005);
    }
  }
}

TEST(ScannedHand, AtItsRestAnglesItLiesWhereTheScanDid) {
  const ScannedHand scan = built_in_scan(Side::right);
  const HandModel model = rigged(scan);
  const auto keypoints = posed_keypoints(model.skeleton, {Rigid3d(), model.rest_angles});
  const Rigid3d scan_from_hand =
      align_points(Eigen::Map<const Eigen::Matrix3Xd>(keypoints[0].data(), 3, kKeypointCount),
                   Eigen::Map<const Eigen::Matrix3Xd>(scan.keypoints[0].data(), 3, kKeypointCount));
  const PosedHand posed(model, {scan_from_hand, model.rest_angles});
  for (std::size_t i = 0; i < posed.vertices().size(); ++i) {
    ASSERT_LT((posed.vertices()[i] - scan.surface.vertices[i]).norm(), 1e-6);
  }
}

TEST(ScannedHand, UnitsAndKindsOfMeshGiveTheSameHand) {
  const ScannedHand scan = built_in_scan(Side::left);
  const HandModel metres = read(scan), millimetres = read(scan, "scan.obj", 0.001);
  ASSERT_EQ(millimetres.links.size(), metres.links.size());
  for (std::size_t i = 0; i < metres.links.size(); ++i) {
    ASSERT_LT((millimetres.rest_surface.vertices[i] - metres.rest_surface.vertices[i]).norm(),
              1e-6);
  }
}

TEST(ScannedHand, InsideOutIsTurnedAndStrayVerticesAreLeftOut) {
  ScannedHand scan = built_in_scan(Side::right);
  const std::size_t count = scan.surface.vertices.size();
  for (Triangle& triangle : scan.surface.triangles) std::swap(triangle[0], triangle[1]);
  scan.surface.vertices.emplace_back(3.0, 3.0, 3.0);
  scan.surface.normals.clear();
  const HandModel model = rigged(scan);
  EXPECT_EQ(model.links.size(), count);
  EXPECT_GT(enclosed_volume(model.rest_surface), 0.0);
}

TEST(ScannedHand, WhatDoesNotFitIsSaid) {
  const ScannedHand scan = built_in_scan(Side::right);
  const std::string good = toml_of(scan, "scan.ply", 1.0);
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string content = good;
    const std::size_t at = content.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return content.replace(at, from.size(), to);
  };
  EXPECT_TRUE(says(error_with(changed("scan.ply", "lost.ply")), "lost.ply"));
  EXPECT_TRUE(says(error_with(changed("scan.ply", "scan.stl")), "hand.toml", "mesh", ".obj"));
  EXPECT_TRUE(says(error_with(changed("right", "both")), "hand.toml", "hand", "'left'"));
  EXPECT_TRUE(says(error_with(changed("thumb_ip =", "thumb_pip =")), "thumb_pip", "thumb_ip"));
  EXPECT_TRUE(says(error_with(changed("mesh =", "mehs =")), "hand.toml", "mehs", "mesh"));
  EXPECT_TRUE(says(error_with(changed("metres_per_unit = 1.0", "metres_per_unit = 0.0")),
                   "metres_per_unit", "above"));
  EXPECT_TRUE(says(error_with(changed("metres_per_unit = 1.0", "metres_per_unit = 1000.0")),
                   "'hand'", "m apart"));
  EXPECT_TRUE(says(error_with(changed("\"right\"", "\"left\"")), "'hand'", "other hand"));
}

TEST(ScannedHand, JointsElsewhereThanTheMeshAreSaid) {
  ScannedHand scan = built_in_scan(Side::right);
  for (Eigen::Vector3d& vertex : scan.surface.vertices) vertex.x() += 1.0;
  EXPECT_TRUE(says(error_of([&] { rigged(scan); }), "'hand'", "wrist", "same frame"));
}

TEST(ScannedHand, AMeshWithoutTrianglesIsSaid) {
  ScannedHand scan = built_in_scan(Side::right);
  scan.surface.triangles.clear();
  EXPECT_TRUE(says(error_of([&] { rigged(scan); }), "'hand'", "no triangles"));
}

class MakeHuman : public testing::Test {
 protected:
  void SetUp() override {
    const fs::path folder = fs::path(TEGATA_DATA_DIR) / "makehuman_hand";
    if (!fs::exists(folder)) GTEST_SKIP() << folder << " is absent";
    hand_ = makehuman_hand(folder);
  }
  MakeHumanHand hand_;
};

TEST_F(MakeHuman, IsCutOutWhole) {
  EXPECT_EQ(hand_.scan.surface.vertices.size(), 1595U);
  EXPECT_EQ(hand_.scan.surface.triangles.size(), 3162U);
}

TEST_F(MakeHuman, TheRulesFindTheBonesThatItsRigHas) {
  const HandModel model = read(hand_.scan, "scan.obj");
  ASSERT_EQ(model.links.size(), hand_.rig_bones.size());
  std::size_t same = 0, same_digit = 0;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const int got = main_bone(model.links[i]), expected = hand_.rig_bones[i];
    same += got == expected ? 1 : 0;
    same_digit += got == 0 || expected == 0 || (got - 1) / 3 == (expected - 1) / 3 ? 1 : 0;
  }
  const auto share = [&](std::size_t count) {
    return static_cast<double>(count) / static_cast<double>(model.links.size());
  };
  RecordProperty("same_bone", std::to_string(share(same)));
  EXPECT_GT(share(same), 0.8);
  EXPECT_GT(share(same_digit), 0.995);
}

TEST_F(MakeHuman, BendsWithoutCollapsing) {
  const HandModel model = rigged(hand_.scan);
  const double rest = enclosed_volume(model.rest_surface);
  HandPose fist;
  fist.angles = 0.9 * angle_limits().upper;
  const PosedHand posed(model, fist);
  EXPECT_NEAR(enclosed_volume(posed.surface()) / rest, 1.0, 0.1);
}

}  // namespace
}  // namespace tegata
