// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// What docs/formats.md shows is what the readers take.
#include <gtest/gtest.h>

#include <sstream>

#include "run_program.h"
#include "tegata/take/calibration_file.h"
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
}

TEST_F(FormatsDocument, CalibrationSnippetIsRead) {
  const CameraRig rig = read_calibration(file_of("toml", "[cam_0]"));
  EXPECT_EQ(rig.size(), 2u);
  EXPECT_EQ(rig[0].name, "left");
}

TEST_F(FormatsDocument, ResultSnippetIsRead) {
  const Result result = read_result_json(file_of("json", "{\"format\": \"tegata-result\""));
  ASSERT_EQ(result.frames.size(), 2u);
  EXPECT_TRUE(result.frames[0].pose.has_value());
  EXPECT_FALSE(result.frames[1].pose.has_value());
}

TEST_F(FormatsDocument, TruthSnippetIsRead) {
  const Truth truth = read_truth_json(file_of("json", "{\"format\": \"tegata-truth\""));
  ASSERT_EQ(truth.frames.size(), 1u);
  EXPECT_TRUE(truth.frames[0].angles.has_value());
}

}  // namespace
}  // namespace tegata
