// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// What docs/formats.md shows is what the readers take, and what docs/calibration.md tells to type
// works.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "run_program.h"
#include "tegata/base/random.h"
#include "tegata/calibrate/rendered_board_for_tests.h"
#include "tegata/math/so3.h"
#include "tegata/pipeline/calibrate_take.h"
#include "tegata/take/calibration_file.h"
#include "tegata/take/hand_shape_file.h"
#include "tegata/take/picture_file.h"
#include "tegata/take/result.h"
#include "tegata/take/take_info.h"
#include "tegata/take/test_folder.h"
#include "tegata/take/truth.h"

namespace tegata {
namespace {

/// The fenced block of a document whose first line after the fence starts with `opening`.
std::string snippet(const std::string& language, const std::string& opening,
                    const std::string& name = "formats.md") {
  std::istringstream document(read_text(TEGATA_SOURCE_DIR "/docs/" + name));
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
  ADD_FAILURE() << "docs/" << name << " has no block of " << language << " that starts with "
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

// Other tools' calibrations and pictures of the board of the worked example, under the names that
// the document uses.
class CalibrationDocument : public testing::Test {
 protected:
  CalibrationDocument() {
    std::filesystem::current_path(folder_.path());
    for (const char* name : {"take", "easymocap_folder", "colmap_folder", "board_take"}) {
      std::filesystem::create_directory(name);
    }
    write_text("camchain.yaml",
               "cam0:\n  camera_model: pinhole\n  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]\n"
               "  distortion_model: radtan\n  intrinsics: [600.0, 600.0, 320.0, 240.0]\n"
               "  resolution: [640, 480]\ncam1:\n  camera_model: pinhole\n"
               "  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]\n  distortion_model: radtan\n"
               "  intrinsics: [600.0, 600.0, 320.0, 240.0]\n  resolution: [640, 480]\n"
               "  T_cn_cnm1:\n  - [1.0, 0.0, 0.0, 0.3]\n  - [0.0, 1.0, 0.0, 0.0]\n"
               "  - [0.0, 0.0, 1.0, 0.0]\n  - [0.0, 0.0, 0.0, 1.0]\n");
    std::string intrinsics, extrinsics;
    for (const char* name : {"01", "02"}) {
      intrinsics += text("K_", name, ": [900.0, 0, 960, 0, 900.0, 540, 0, 0, 1]\ndist_", name,
                         ": [0, 0, 0, 0, 0]\n");
      extrinsics += text("R_", name, ": [0.0, 0.", name, ", 0.0]\nT_", name, ": [0, 0, 1]\n");
    }
    write_text("easymocap_folder/intri.yml", intrinsics);
    write_text("easymocap_folder/extri.yml", extrinsics);
    write_text("colmap_folder/cameras.txt", "1 PINHOLE 640 480 600 600 320 240\n");
    write_text("colmap_folder/images.txt",
               "1 1 0 0 0 0 0 1 1 left/0.png\n\n2 1 0 0 0 0.3 0 1 1 right/0.png\n\n");
    write_text("board_take/board.toml", snippet("toml", "kind = \"circles\"", "calibration.md"));
    for (const char* name : {"left", "right"}) write_board_pictures(name, name[0] == 'l');
  }
  ~CalibrationDocument() override { std::filesystem::current_path("/"); }

  static void write_board_pictures(const std::string& name, bool left) {
    const std::filesystem::path folder = std::filesystem::path("board_take/images") / name;
    std::filesystem::create_directories(folder);
    const Board board = read_board("board_take/board.toml");
    Camera camera;
    camera.width = 320;
    camera.height = 240;
    camera.fx = camera.fy = 330.0;
    camera.cx = 159.5;
    camera.cy = 119.5;
    const Rigid3d camera_from_world = {so3_exp({0.0, left ? 0.25 : -0.25, 0.0}), {0.0, 0.0, 0.55}};
    const auto points = board_points(board);
    const Rigid3d middled = {Eigen::Quaterniond::Identity(),
                             -0.5 * (points.front() + points.back())};
    Random random(4);
    for (int f = 0; f < 10; ++f) {
      const auto about = [&](double most) { return random.uniform(-most, most); };
      const Eigen::Vector3d turn(about(0.5), about(0.4), about(1.0));
      const Rigid3d world_from_board = {so3_exp(turn), {about(0.08), about(0.05), about(0.06)}};
      write_picture(
          render_board(circles_paint(board), camera, camera_from_world * world_from_board * middled,
                       {29500, 30400, 16, 12.0}),
          folder / text(f, ".png"));
    }
  }
  TestFolder folder_;
};

TEST_F(CalibrationDocument, ItsCommandsWork) {
  std::istringstream document(read_text(TEGATA_SOURCE_DIR "/docs/calibration.md"));
  int count = 0;
  for (std::string line; std::getline(document, line);) {
    if (!line.starts_with("tegata ")) continue;
    std::istringstream words(line.substr(line.find(' ')));
    std::vector<std::string> arguments;
    for (std::string word; words >> word;) arguments.push_back(word);
    if (line.starts_with("tegata calibration check")) {
      std::filesystem::remove_all("take");
      ASSERT_EQ(run_program({"simulate", "take", "--frames", "2", "--size", "320x240"}).exit_code,
                0);
    } else {
      std::filesystem::remove("take/calibration.toml");
    }
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 0) << line << ": " << run.err;
    ++count;
    if (arguments[0] == "board") {
      EXPECT_TRUE(std::filesystem::exists("board.svg"));
      continue;
    }
    EXPECT_EQ(read_calibration("take/calibration.toml").size(), arguments[1] == "check" ? 3u : 2u);
    if (arguments[0] != "calibrate") continue;
    EXPECT_TRUE(std::filesystem::exists("coverage.png"));
    const CameraRig rig = read_calibration("take/calibration.toml");
    EXPECT_NEAR((rig[0].center_in_world() - rig[1].center_in_world()).norm(),
                2.0 * 0.55 * std::sin(0.25), 0.01);
  }
  EXPECT_GE(count, 6);
}

}  // namespace
}  // namespace tegata
