// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/take_info.h"

#include <gtest/gtest.h>

#include <string>

#include "tegata/take/staged_folder.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

TakeInfo read(const std::string& content) {
  const TestFolder folder;
  write_file(folder / "take.toml", content);
  return read_take_info(folder / "take.toml");
}

std::string error_with(const std::string& content) {
  return error_of([&] { read(content); });
}

TEST(TakeInfo, ReadsTheExampleOfTheDocumentation) {
  const TakeInfo info = read(R"(name = "mug-03"
hand = "left"
fps = 25
metres_per_unit = 0.001
[initial_pose]
wrist      = [0.01, 0.02, 0.90]
index_mcp  = [0.03, 0.09, 0.88]
little_mcp = [-0.03, 0.08, 0.91]
[segmentation]
method = "background"
hand_label = 255
[offset]
left = 3
"top 1" = -2
)");
  EXPECT_EQ(info.hand_label, 255);
  EXPECT_EQ(info.offsets, (std::map<std::string, int>{{"left", 3}, {"top 1", -2}}));
  EXPECT_EQ(info.name, "mug-03");
  EXPECT_EQ(info.side, Side::left);
  EXPECT_EQ(info.fps, 25.0);
  EXPECT_EQ(info.metres_per_unit, 0.001);
  ASSERT_TRUE(info.initial_landmarks.has_value());
  EXPECT_EQ(info.initial_landmarks->little_mcp, Eigen::Vector3d(-0.03, 0.08, 0.91));
  EXPECT_EQ(info.segmentation, SegmentationMethod::background);
}

TEST(TakeInfo, WhatIsWrittenReadsBackTheSame) {
  TakeInfo info;
  info.name = "a \"b\"\n\\c";
  info.side = Side::right;
  info.fps = 1000.0 / 3.0;
  info.metres_per_unit = 1e-5;
  info.initial_landmarks = {{1.0 / 3.0, 0.0, 1e22}, {-1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
  info.segmentation = SegmentationMethod::skin;
  info.hand_label = 7;
  info.offsets = {{"a\"b", 4}};
  const TestFolder folder;
  write_take_info(info, folder / "take.toml");
  const TakeInfo back = read_take_info(folder / "take.toml");
  EXPECT_EQ(back.name, info.name);
  EXPECT_EQ(back.side, info.side);
  EXPECT_EQ(back.fps, info.fps);
  EXPECT_EQ(back.metres_per_unit, info.metres_per_unit);
  EXPECT_EQ(back.initial_landmarks->wrist, info.initial_landmarks->wrist);
  EXPECT_EQ(back.segmentation, info.segmentation);
  EXPECT_EQ(back.hand_label, info.hand_label);
  EXPECT_EQ(back.offsets, info.offsets);
  write_take_info(TakeInfo(), folder / "empty.toml");
  const TakeInfo empty = read_take_info(folder / "empty.toml");
  EXPECT_FALSE(empty.side || empty.initial_landmarks || empty.segmentation);
  EXPECT_EQ(empty.name, "");
}

// 2^53 + 1, which is not a double.
TEST(TakeInfo, WholeNumbersOfMoreDigitsThanADoubleHoldsAreRead) {
  EXPECT_EQ(read("fps = 9007199254740993").fps, 9007199254740992.0);
}

TEST(TakeInfo, UnknownKeysAreSaidWithThoseThatWouldDo) {
  EXPECT_TRUE(says(error_with("fsp = 30.0"), "take.toml", "'fsp'", "'fps'", "'metres_per_unit'"));
  EXPECT_TRUE(
      says(error_with("[segmentation]\nmode = \"skin\""), "[segmentation]", "'mode'", "'method'"));
  EXPECT_TRUE(says(error_with("[initial_pose]\nthumb = [0, 0, 0]"), "[initial_pose]", "'thumb'",
                   "'index_mcp'"));
}

TEST(TakeInfo, WrongValuesAreSaid) {
  EXPECT_TRUE(says(error_with("fps = \"30\""), "'fps'", "a string", "a number"));
  EXPECT_TRUE(says(error_with("fps = 0"), "'fps'", "got 0", "above 0"));
  EXPECT_TRUE(says(error_with("metres_per_unit = inf"), "'metres_per_unit'", "inf", "finite"));
  EXPECT_TRUE(says(error_with("hand = \"both\""), "'hand'", "both", "'right' or 'left'"));
  EXPECT_TRUE(says(error_with("name = 3"), "'name'", "a number", "a string"));
  EXPECT_TRUE(says(error_with("segmentation = \"skin\""), "'segmentation'", "a string", "a table"));
  EXPECT_TRUE(says(error_with("[segmentation]\nmethod = \"otsu\""), "'method'", "otsu",
                   "'infrared', 'background', 'skin' or 'mask'"));
  EXPECT_TRUE(
      says(error_with("[initial_pose]\nwrist = [0.0, 0.1, 0.2]"), "'index_mcp'", "missing"));
  EXPECT_TRUE(says(error_with("[initial_pose]\nwrist = [0.0, 0.1]"), "'wrist'", "2 numbers"));
  EXPECT_TRUE(
      says(error_with("[segmentation]\nhand_label = 0"), "'hand_label'", "0", "1 to 65535"));
  EXPECT_TRUE(says(error_with("[offset]\nleft = 1.5"), "[offset]", "'left'", "1.5", "whole"));
  EXPECT_TRUE(says(error_with("fps = \n"), "take.toml", "line 1"));
}

TEST(TakeInfo, MethodNamesGoBackAndForth) {
  for (const char* name : {"infrared", "background", "skin", "mask"}) {
    EXPECT_EQ(segmentation_method_name(segmentation_method_from_name(name)), name);
  }
  EXPECT_TRUE(says(error_of([] { segmentation_method_from_name("otsu"); }), "otsu", "'skin'"));
}

}  // namespace
}  // namespace tegata
