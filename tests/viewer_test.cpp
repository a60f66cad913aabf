// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// The report page in a real browser: a take of 60 frames and three cameras, one of which shows
// another moment for a while. The poses are the truth's, so that nothing needs to be fitted; the
// overlaps and what is doubted are measured. What happens in the browser is in
// viewer/test/report_test.mjs.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "run_program.h"
#include "tegata/export/viewer_page.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/image/rasterizer.h"
#include "tegata/pipeline/silhouettes.h"
#include "tegata/take/result.h"
#include "tegata/take/test_folder.h"
#include "tegata/take/truth.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFrames = 60, kBroken = 37, kMissing = 52;
constexpr std::size_t kMade = 21;  // simulated ones, which the others repeat to and fro
constexpr double kOff = 0.06;      // how far the fingers are moved [rad]

/// Of which simulated frame the pictures and the pose are.
std::size_t source_of(std::size_t frame) {
  const std::size_t phase = frame % (2 * kMade - 2);
  return phase < kMade ? phase : 2 * kMade - 2 - phase;
}

std::string frame_name(std::size_t i) {
  const std::string name = std::to_string(i);
  return std::string(6 - name.size(), '0') + name;
}

/// Where the palm's keypoints are, the palm is: those do not move with any angle.
Rigid3d world_from_hand(const Skeleton& skeleton, const TruthFrame& truth) {
  Eigen::Matrix<double, 3, 5> in_hand, in_world;
  const int palm[] = {0, 5, 9, 13, 17};
  for (int i = 0; i < 5; ++i) {
    in_hand.col(i) = skeleton.keypoints[static_cast<std::size_t>(palm[i])];
    in_world.col(i) = truth.keypoints[static_cast<std::size_t>(palm[i])];
  }
  const Eigen::Matrix4d moved = Eigen::umeyama(in_hand, in_world, false);
  return {Eigen::Quaterniond(moved.topLeftCorner<3, 3>()), moved.topRightCorner<3, 1>()};
}

/// The truth as a result whose fingers move a little, with overlaps as the pictures have them.
Result result_of_truth(Take& take, const Truth& truth, const HandModel& hand) {
  std::map<std::size_t, std::vector<std::optional<Silhouette>>> seen;  // by simulated frame
  Result result;
  result.take = take.info().name;
  result.model_name = hand.name;
  result.grasp_angles = *truth.frames.front().angles;
  result.grasp_standard_deviations.setConstant(0.02);
  result.iterations = 23;
  result.termination = "converged";
  result.seconds = {{"segment", 0.4}, {"hull", 0.3}, {"frames", 12.0}, {"all_frames", 3.5}};
  for (std::size_t i = 0; i < take.frame_names().size(); ++i) {
    ResultFrame frame;
    frame.name = take.frame_names()[i];
    frame.time = static_cast<double>(i) / 30.0;
    if (i == kMissing) {
      frame.status = "pictures from 1 camera, 2 or more are needed";
      result.frames.push_back(frame);
      continue;
    }
    HandPose& pose = frame.pose.emplace();
    const std::size_t source = source_of(i);
    pose.world_from_hand = world_from_hand(hand.skeleton, truth.frames[source]);
    pose.angles = *truth.frames[source].angles;
    for (int angle = 5; angle < kAngleCount; angle += 4) {
      pose.angles[angle] += kOff * std::sin(0.2 * static_cast<double>(i) + angle);
    }
    const PosedHand posed(hand, pose);
    frame.keypoints = posed.keypoints();
    for (std::size_t b = 0; b < frame.support.size(); ++b) {
      frame.support[b] =
          0.5 + 0.5 * std::cos(0.15 * static_cast<double>(i) + static_cast<double>(b));
    }
    const bool is_broken = i + 1 >= kBroken && i <= kBroken + 1;
    auto& silhouettes = seen[is_broken ? i : source];
    if (silhouettes.empty()) {
      silhouettes =
          Segmenter(take, SegmentationMethod::infrared, {}).segment(take.read_frame(i, Observer{}));
    }
    for (std::size_t c = 0; c < take.rig().size(); ++c) {
      const Camera& camera = take.rig()[c];
      if (!silhouettes[c]) continue;
      frame.views.push_back(camera.name);
      frame.silhouette_iou[camera.name] =
          intersection_over_union(*silhouettes[c], render_silhouette(posed.surface(), camera));
    }
    result.frames.push_back(frame);
  }
  return result;
}

class Viewer : public testing::Test {
 protected:
  void SetUp() override {
    if (viewer_page().empty()) GTEST_SKIP() << "built without the report page";
  }
  fs::path take() const { return folder_ / "take"; }
  fs::path result() const { return folder_ / "result"; }

  /// A take of kFrames frames, or of its first ones, and its result.
  void make_result(std::size_t frame_count = kFrames) const {
    ASSERT_EQ(run_program({"simulate", take().string(), "--grasp", "cylinder", "--cameras", "3",
                           "--frames", std::to_string(std::min(frame_count, kMade)), "--turn-deg",
                           "6", "--no-forearm", "--quiet"})
                  .exit_code,
              0);
    for (const std::string camera : {"camera_0", "camera_1", "camera_2"}) {
      const fs::path pictures = take() / "images" / camera;
      for (std::size_t i = kMade; i < frame_count; ++i) {
        fs::copy_file(pictures / (frame_name(source_of(i)) + ".png"),
                      pictures / (frame_name(i) + ".png"));
      }
    }
    for (std::size_t i = kBroken - 1; i <= kBroken + 1 && i < frame_count; ++i) {
      const fs::path pictures = take() / "images" / "camera_1";
      fs::copy_file(pictures / (frame_name(kMade - 1) + ".png"),
                    pictures / (frame_name(i) + ".png"), fs::copy_options::overwrite_existing);
    }
    Take opened = Take::open(take());
    const HandModel hand = built_in_hand(HandShape{}, Side::right);
    const Truth truth = read_truth_json(take() / "truth.json");
    fs::create_directory(result());
    write_result_json(result_of_truth(opened, truth, hand), result() / "result.json");
  }

  TestFolder folder_;
};

TEST_F(Viewer, ReportOfSixtyFramesWorksInABrowser) {
  ASSERT_NO_FATAL_FAILURE(make_result());
  const ProgramRun run =
      run_program({"report", result().string(), "--take", take().string(), "--json", "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto said = nlohmann::json::parse(run.out);
  const fs::path page = said["report"].get<std::string>();
  std::cout << "report of 60 frames and 3 cameras: " << said["bytes"] << " bytes\n";
  EXPECT_EQ(said["bytes"], fs::file_size(page));
  EXPECT_LT(said["bytes"], 10'000'000);

  if (std::system("command -v chromium >/dev/null") != 0) {
    GTEST_SKIP() << "chromium is not installed: the page was made and not opened";
  }
  fs::create_directories(TEGATA_SCREENSHOTS);
  const std::string command = "TEGATA_REPORT='" + page.string() +
                              "' TEGATA_SCREENSHOTS='" TEGATA_SCREENSHOTS
                              "' node '" TEGATA_VIEWER_COPY "/test/report_test.mjs'";
  const int status = std::system(command.c_str());
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << command;
}

TEST_F(Viewer, ReportWithoutTheTakeHasNoPictures) {
  ASSERT_NO_FATAL_FAILURE(make_result(4));
  const fs::path page = folder_ / "alone.html";
  const ProgramRun run = run_program({"report", result().string(), "-o", page.string(), "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string content = read_text(page);
  EXPECT_NE(content.find("Made without the take: no cameras and no pictures."), std::string::npos);
  EXPECT_EQ(content.find("\"jpeg\":"), std::string::npos);
  EXPECT_FALSE(fs::exists(result() / "report.html"));
}

TEST_F(Viewer, ViewSaysWhereThePageIsOrHowToMakeIt) {
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  fs::create_directory(result());
  const ProgramRun missing = run_program({"view", result().string()});
  EXPECT_EQ(missing.exit_code, 1);
  ASSERT_EQ(missing.error_lines().size(), 1u) << missing.err;
  EXPECT_TRUE(says(missing.error_lines().front(), "report.html", "tegata report"));
  write_text(result() / "report.html", "<!doctype html>");
  const ProgramRun found = run_program({"view", result().string()});
  EXPECT_EQ(found.exit_code, 0) << found.err;
  EXPECT_EQ(found.out, "open this in a browser: " + (result() / "report.html").string() + "\n");
}

}  // namespace
}  // namespace tegata
