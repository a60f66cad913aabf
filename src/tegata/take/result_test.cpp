// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/result.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "tegata/base/random.h"
#include "tegata/math/so3.h"
#include "tegata/take/staged_folder.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

Result some_result() {
  Random random(3);
  Result result;
  result.take = "mug-03";
  result.side = Side::left;
  result.model_name = "built-in";
  result.model_shape = {{"length", 1.0 / 3.0}};
  result.model_scale = 1.0 / 1.1;
  result.model_scale_standard_deviation = 1.0 / 70.0;
  result.iterations = 12;
  result.termination = "converged";
  result.seconds = {{"hull", 0.25}, {"fit", 1.5}};
  result.start = {"000001", 4.0 / 3.0};
  ResultFrame fitted;
  fitted.name = "000000";
  fitted.time = 1.0 / 30.0;
  fitted.pose.emplace();
  fitted.pose->world_from_hand = {so3_exp({0.3, -1.0, 2.0}), {0.1, 1.0 / 3.0, 1e-17}};
  for (int i = 0; i < kAngleCount; ++i) {
    fitted.pose->angles[i] = random.uniform(-1.0, 1.0);
    result.grasp_angles[i] = random.uniform(-1.0, 1.0);
    result.grasp_standard_deviations[i] = random.uniform();
  }
  for (auto& keypoint : fitted.keypoints) keypoint = {random.uniform(), random.uniform(), 0.5};
  for (double& support : fitted.support) support = random.uniform();
  fitted.views = {"right", "left"};
  fitted.silhouette_iou = {{"left", 0.97}, {"right", 0.5}};
  fitted.uncovered = {{"left", 1.0 / 3000.0}};
  fitted.left_out = {{"top", "it contradicts the other cameras"}};
  ResultFrame doubtful = fitted;
  doubtful.name = "000001";
  doubtful.status = "the views disagree";
  ResultFrame lost;
  lost.name = "000002";
  lost.status = "only one view";
  lost.views = {"left"};
  result.frames = {fitted, doubtful, lost};
  return result;
}

std::string written(const Result& result) {
  const TestFolder folder;
  write_result_json(result, folder / "result.json");
  return read_file(folder / "result.json");
}

std::string error_reading(const std::string& from, const std::string& to) {
  const TestFolder folder;
  std::string content = written(some_result());
  const std::size_t at = content.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) content.replace(at, from.size(), to);
  write_file(folder / "result.json", content);
  return error_of([&] { read_result_json(folder / "result.json"); });
}

TEST(Result, AStartWithoutARivalStaysWithoutOne) {
  Result result = some_result();
  result.start->lead = std::numeric_limits<double>::infinity();
  const TestFolder folder;
  write_result_json(result, folder / "result.json");
  const Result back = read_result_json(folder / "result.json");
  ASSERT_TRUE(back.start);
  EXPECT_EQ(back.start->lead, result.start->lead);
  result.start.reset();
  write_result_json(result, folder / "result.json");
  EXPECT_FALSE(read_result_json(folder / "result.json").start);
}

TEST(Result, ReadsBackTheSameToTheBit) {
  const Result result = some_result();
  const TestFolder folder;
  write_result_json(result, folder / "result.json");
  const Result back = read_result_json(folder / "result.json");
  EXPECT_EQ(back.take, result.take);
  EXPECT_EQ(back.side, result.side);
  EXPECT_EQ(back.model_name, result.model_name);
  EXPECT_EQ(back.model_shape, result.model_shape);
  EXPECT_EQ(back.model_scale, result.model_scale);
  EXPECT_EQ(back.model_scale_standard_deviation, result.model_scale_standard_deviation);
  EXPECT_EQ(back.grasp_angles, result.grasp_angles);
  EXPECT_EQ(back.grasp_standard_deviations, result.grasp_standard_deviations);
  EXPECT_EQ(back.iterations, result.iterations);
  EXPECT_EQ(back.termination, result.termination);
  EXPECT_EQ(back.seconds, result.seconds);
  ASSERT_TRUE(back.start);
  EXPECT_EQ(back.start->frame, result.start->frame);
  EXPECT_EQ(back.start->lead, result.start->lead);
  ASSERT_EQ(back.frames.size(), result.frames.size());
  for (std::size_t i = 0; i < back.frames.size(); ++i) {
    const ResultFrame& a = back.frames[i];
    const ResultFrame& b = result.frames[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.time, b.time);
    EXPECT_EQ(a.status, b.status);
    EXPECT_EQ(a.views, b.views);
    ASSERT_EQ(a.pose.has_value(), b.pose.has_value());
    if (!a.pose) continue;
    EXPECT_EQ(a.pose->world_from_hand.translation, b.pose->world_from_hand.translation);
    EXPECT_EQ(a.pose->angles, b.pose->angles);
    EXPECT_EQ(a.keypoints, b.keypoints);
    EXPECT_EQ(a.support, b.support);
    EXPECT_EQ(a.silhouette_iou, b.silhouette_iou);
    EXPECT_EQ(a.uncovered, b.uncovered);
    EXPECT_EQ(a.left_out, b.left_out);
  }
  EXPECT_EQ(written(back), written(result));
}

TEST(Result, KeysStandInTheOrderOfTheDocumentation) {
  const std::string content = written(some_result());
  std::size_t last = 0;
  for (const char* key :
       {"format",         "version",     "tegata",         "take",        "hand",
        "units",          "joint_names", "keypoint_names", "model",       "grasp",
        "frames",         "frame",       "time",           "status",      "rotation",
        "translation",    "angles",      "keypoints",      "support",     "views",
        "silhouette_iou", "report",      "iterations",     "termination", "seconds"}) {
    const std::size_t at = content.find(text("\"", key, "\":"), last);
    ASSERT_NE(at, std::string::npos) << key;
    last = at;
  }
}

TEST(Result, ARotationIsWrittenWithPositiveW) {
  Result result = some_result();
  Eigen::Quaterniond& rotation = result.frames[0].pose->world_from_hand.rotation;
  rotation = Eigen::Quaterniond(-0.5, 0.5, 0.5, -0.5);
  EXPECT_NE(written(result).find("\"rotation\":[0.5,-0.5,-0.5,0.5]"), std::string::npos);
  const std::string one = written(result);
  rotation.coeffs() *= -1.0;
  EXPECT_EQ(written(result), one);
}

TEST(Result, AFrameWithoutAPoseHasNothingInvented) {
  const auto json = nlohmann::json::parse(written(some_result()));
  const auto& lost = json["frames"][2];
  EXPECT_EQ(lost["status"], "only one view");
  for (const char* key : {"rotation", "translation", "angles", "keypoints", "support"}) {
    EXPECT_FALSE(lost.contains(key)) << key;
  }
  EXPECT_EQ(json["frames"][1]["angles"].size(), 20u);
}

TEST(Result, NumbersThatAreNotFiniteAreNotWritten) {
  Result result = some_result();
  result.frames[0].keypoints[4].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(says(error_of([&] { written(result); }), "result.json", "not finite"));
}

TEST(Result, OtherFormatsVersionsAndConventionsAreRefused) {
  EXPECT_TRUE(says(error_reading("tegata-result", "other"), "result.json", "format", "other",
                   "tegata-result"));
  EXPECT_TRUE(says(error_reading("\"version\": 1", "\"version\": 2"), "version", "got 2"));
  EXPECT_TRUE(says(error_reading("\"m\"", "\"mm\""), "units.length", "'mm'", "'m'"));
  EXPECT_TRUE(says(error_reading("thumb_cmc_flexion", "thumb_cmc_bend"), "joint_names[1]",
                   "thumb_cmc_bend"));
  EXPECT_TRUE(says(error_reading("\"left\"", "\"both\""), "hand", "both"));
}

TEST(Result, ShapesAndMissingKeysAreSaidWithTheirPlace) {
  EXPECT_TRUE(says(error_reading("\"time\":", "\"t\":"), "frames[0]", "'time'", "missing"));
  EXPECT_TRUE(says(error_reading("\"rotation\":[", "\"rotation\":[1.0,"), "frames[0].rotation",
                   "array of 5", "4 numbers"));
  EXPECT_TRUE(
      says(error_reading("\"rotation\":[", "\"rotation\":[2.0],\"r\":["), "frames[0].rotation"));
  EXPECT_TRUE(says(error_reading("\"rotation\"", "\"rot\""), "frames[0]", "'rotation'", "missing"));
  EXPECT_TRUE(says(error_reading("\"keypoints\":[", "\"keypoints\":[[0,0,0],"),
                   "frames[0].keypoints", "array of 22"));
  EXPECT_TRUE(says(error_reading("\"palm\"", "\"hoof\""), "frames[0].support", "hoof"));
  EXPECT_TRUE(says(error_reading("\"time\":0", "\"time\":\"0\",\"t\":0"), "frames[0].time",
                   "a string", "a number"));
  EXPECT_TRUE(says(error_reading("000001", "000000"), "frames[1].frame", "second time"));
  EXPECT_TRUE(says(error_reading("{", "["), "result.json", "not JSON"));
}

TEST(Result, UnknownKeysOfLaterWritersAreIgnored) {
  const TestFolder folder;
  std::string content = written(some_result());
  content.insert(1, "\"later\": [1], ");
  write_file(folder / "result.json", content);
  EXPECT_EQ(read_result_json(folder / "result.json").take, "mug-03");
}

TEST(AnglesCsv, HasOneRowAFrameInDegreesAndEmptyCellsWithoutAPose) {
  Result result = some_result();
  result.frames[0].name = "a,\"b\"";
  result.frames[0].pose->angles[0] = 0.5;
  result.frames[0].pose->angles[1] = -1e-9;
  const TestFolder folder;
  write_angles_csv(result, folder / "angles.csv");
  const std::string table = read_file(folder / "angles.csv");
  EXPECT_TRUE(table.starts_with("frame,time_s,thumb_cmc_abduction_deg,thumb_cmc_flexion_deg,"));
  EXPECT_NE(table.find("\n\"a,\"\"b\"\"\",0.033333,28.6479,0.0000,"), std::string::npos);
  EXPECT_TRUE(table.ends_with("\n000002,0.000000,,,,,,,,,,,,,,,,,,,,\n"));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 4);
}

}  // namespace
}  // namespace tegata
