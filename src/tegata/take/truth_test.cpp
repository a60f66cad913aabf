// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/truth.h"

#include <gtest/gtest.h>

#include <string>

#include "tegata/base/random.h"
#include "tegata/take/staged_folder.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

Truth some_truth() {
  Random random(5);
  Truth truth;
  truth.side = Side::left;
  for (const char* name : {"000000", "000001"}) {
    TruthFrame& frame = truth.frames.emplace_back();
    frame.name = name;
    for (auto& keypoint : frame.keypoints) keypoint = {random.uniform(), 1.0 / 3.0, 0.0};
  }
  truth.frames[0].angles = JointAngles::Constant(0.1);
  return truth;
}

TEST(Truth, ReadsBackTheSameToTheBit) {
  const TestFolder folder;
  const Truth truth = some_truth();
  write_truth_json(truth, folder / "truth.json");
  const Truth back = read_truth_json(folder / "truth.json");
  EXPECT_EQ(back.side, Side::left);
  ASSERT_EQ(back.frames.size(), 2u);
  EXPECT_EQ(back.frames[1].name, "000001");
  EXPECT_EQ(back.frames[1].keypoints, truth.frames[1].keypoints);
  EXPECT_EQ(back.frames[0].angles, truth.frames[0].angles);
  EXPECT_FALSE(back.frames[1].angles.has_value());
}

TEST(Truth, MadeByOtherProgramsItNeedsNoFormat) {
  const TestFolder folder;
  write_file(folder / "truth.json", R"({"side": "right", "frames": []})");
  EXPECT_EQ(read_truth_json(folder / "truth.json").side, Side::right);
}

TEST(Truth, WhatIsWrongIsSaidWithItsPlace) {
  const TestFolder folder;
  const auto error_with = [&](const std::string& content) {
    write_file(folder / "truth.json", content);
    return error_of([&] { read_truth_json(folder / "truth.json"); });
  };
  EXPECT_TRUE(says(error_with(R"({"frames": []})"), "truth.json", "'side'", "missing"));
  EXPECT_TRUE(says(error_with(R"({"side": "up", "frames": []})"), "side", "'up'", "'left'"));
  EXPECT_TRUE(says(error_with(R"({"side": "left", "frames": [{"frame": "0", "keypoints": []}]})"),
                   "frames[0].keypoints", "array of 0", "21 points"));
  EXPECT_TRUE(says(error_with(R"({"side": "left", "frames": [{"frame": "0", "angle": []}]})"),
                   "frames[0]", "'angle'", "'angles'"));
  EXPECT_TRUE(
      says(error_with(R"({"format": "x", "side": "left", "frames": []})"), "format", "'x'"));
  EXPECT_TRUE(says(error_with(R"([])"), "array", "an object"));
  EXPECT_TRUE(says(error_with("{"), "truth.json", "not JSON"));
}

}  // namespace
}  // namespace tegata
