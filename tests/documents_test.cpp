// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// What docs/formats.md shows is what the readers take.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "run_program.h"
#include "tegata/take/calibration_file.h"
#include "tegata/take/hand_shape_file.h"
#include "tegata/take/result.h"
#include "tegata/take/take_info.h"
#include "tegata/take/test_folder.h"
#include "tegata/take/truth.h"

namespace tegata {
namespace {

/// The fenced block of docs/formats.md whose first line after the fence starts with `opening`.
std::string snippet(const std::string& language, const std::string& opening) {
  std::istringstream document(read_text(TEGATA_SOURCE_DIR "/docs/formats.md"));
  std::string block;
  bool inside = false;
  for (std::string line; std::getline(document, line);) {
    if (inside && line == "```") {
      if (block.starts_with(opening)) return block;
      inside = false;
    } else if (inside) {
      block += line + "\n";
    } else if (line == "```" + language) {
      block.clear();
      inside = true;
    }
  }
  ADD_FAILURE() << "docs/formats.md has no block of " << language << " that starts with "
                << opening;
  return {};
}

class FormatsDocument : public testing::Test {
 protected:
  std::filesystem::path file_of(const std::string& language, const std::string& opening) const {
    const std::filesystem::path file = folder_ / ("snippet." + language);
    write_text(file, snippet(language, opening));
    return file;
  }
  TestFolder folder_;
};

TEST_F(FormatsDocument, TakeSnippetIsRead) {
  const TakeInfo info = read_take_info(file_of("toml", "name ="));
  EXPECT_EQ(info.name, "mug-03");
  EXPECT_TRUE(info.initial_landmarks.has_value());
  EXPECT_TRUE(info.segmentation.has_value());
  EXPECT_EQ(info.offsets.at("left"), 3);
}

TEST_F(FormatsDocument, CalibrationSnippetIsRead) {
  const CameraRig rig = read_calibration(file_of("toml", "[cam_0]"));
  EXPECT_EQ(rig.size(), 2u);
  EXPECT_EQ(rig[0].name, "left");
}

TEST_F(FormatsDocument, HandShapeSnippetIsRead) {
  const HandShapeFile hand = read_hand_shape(file_of("toml", "format = \"tegata-hand-shape\""));
  EXPECT_EQ(hand.name, "anna");
  EXPECT_EQ(hand.parameters[0], 0.1748);
  EXPECT_TRUE(hand.standard_deviations.has_value());
}

TEST_F(FormatsDocument, ResultSnippetIsRead) {
  const Result result = read_result_json(file_of("json", "{\"format\": \"tegata-result\""));
  ASSERT_EQ(result.frames.size(), 2u);
  EXPECT_TRUE(result.frames[0].pose.has_value());
  EXPECT_FALSE(result.frames[1].pose.has_value());
}

std::set<std::string> keys_of(const nlohmann::json& object) {
  std::set<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.insert(key);
  return keys;
}

TEST_F(FormatsDocument, HullsSnippetHasTheKeysThatTheProgramWrites) {
  const std::string take = (folder_ / "take").string(), hulls = (folder_ / "hulls").string();
  ASSERT_EQ(run_program({"simulate", take, "--mode", "clean", "--frames", "1", "--size", "320x240",
                         "--quiet"})
                .exit_code,
            0);
  ASSERT_EQ(run_program({"hull", take, "-o", hulls, "--quiet"}).exit_code, 0);
  const auto written = nlohmann::json::parse(read_text(folder_ / "hulls" / "hulls.json"));
  const auto described = nlohmann::json::parse(snippet("json", "{\"format\": \"tegata-hulls\""));
  EXPECT_EQ(keys_of(written), keys_of(described));
  EXPECT_EQ(written["format"], described["format"]);
  EXPECT_EQ(written["version"], described["version"]);
  const auto &frame = written["frames"][0], &example = described["frames"][0];
  EXPECT_EQ(keys_of(frame), keys_of(example));
  EXPECT_EQ(keys_of(frame["levels"][0]), keys_of(example["levels"][0]));
  EXPECT_EQ(keys_of(frame["milliseconds"]), keys_of(example["milliseconds"]));
}

TEST_F(FormatsDocument, SilhouettesSnippetHasTheKeysThatTheProgramWrites) {
  const std::string take = (folder_ / "take").string(), masks = (folder_ / "masks").string();
  ASSERT_EQ(
      run_program({"simulate", take, "--frames", "1", "--size", "320x240", "--quiet"}).exit_code,
      0);
  const ProgramRun run = run_program({"segment", take, "-o", masks, "--method", "infrared"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("a hand in 3 of 3 pictures"), std::string::npos) << run.out;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "masks" / "contact_sheet.png"));
  const auto written = nlohmann::json::parse(read_text(folder_ / "masks" / "silhouettes.json"));
  const auto described =
      nlohmann::json::parse(snippet("json", "{\"format\": \"tegata-silhouettes\""));
  EXPECT_EQ(keys_of(written), keys_of(described));
  EXPECT_EQ(written["format"], described["format"]);
  EXPECT_EQ(written["version"], described["version"]);
  const auto &frame = written["frames"][0], &example = described["frames"][0];
  EXPECT_EQ(keys_of(frame), keys_of(example));
  EXPECT_EQ(keys_of(frame["views"]["camera_0"]), keys_of(example["views"]["left"]));
}

TEST_F(FormatsDocument, TruthSnippetIsRead) {
  const Truth truth = read_truth_json(file_of("json", "{\"format\": \"tegata-truth\""));
  ASSERT_EQ(truth.frames.size(), 1u);
  EXPECT_TRUE(truth.frames[0].angles.has_value());
}

}  // namespace
}  // namespace tegata
