// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/result_folder.h"

#include <gtest/gtest.h>

#include "tegata/export/test_result.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/mesh/mesh_file.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

HandModel coarse_hand() {
  BuiltInHandOptions options;
  options.cell_size = 0.005;
  options.triangle_count = 300;
  return built_in_hand(HandShape{}, Side::right, options);
}

TEST(ResultFolder, FrameWithoutPoseGetsNoMesh) {
  const TestFolder folder;
  const Result result = test_result(3);
  const HandModel hand = coarse_hand();
  write_result_files(result, hand, folder.path());
  EXPECT_TRUE(std::filesystem::exists(folder / "result.json"));
  EXPECT_TRUE(std::filesystem::exists(folder / "angles.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder / "hand.glb"));
  EXPECT_TRUE(std::filesystem::exists(folder / "meshes/frame0.ply"));
  EXPECT_FALSE(std::filesystem::exists(folder / "meshes/frame2.ply"));
  const TriangleMesh mesh = read_ply(folder / "meshes/frame1.ply");
  const PosedHand posed(hand, *result.frames[1].pose);
  ASSERT_EQ(mesh.vertices.size(), posed.vertices().size());
  EXPECT_LT((mesh.vertices.back() - posed.vertices().back()).norm(), 1e-6);
}

TEST(ResultFolder, ResultWithoutAnyPoseIsWritten) {
  const TestFolder folder;
  Result result = test_result(2);
  result.frames[0].pose.reset();
  write_result_files(result, coarse_hand(), folder.path());
  EXPECT_TRUE(std::filesystem::exists(folder / "hand.glb"));
  EXPECT_TRUE(std::filesystem::is_empty(folder / "meshes"));
}

TEST(ResultFolder, NamesWhatCannotBeWritten) {
  const TestFolder folder;
  const std::string message =
      error_of([&] { write_result_files(test_result(2), coarse_hand(), folder / "missing"); });
  EXPECT_TRUE(says(message, "missing", "result.json"));
}

}  // namespace
}  // namespace tegata
