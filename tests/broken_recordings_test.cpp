// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Recordings with damaged files through the real program: what cannot be read is said view by view,
// and nothing else is lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "run_program.h"
#include "tegata/base/text.h"
#include "tegata/take/calibration_file.h"
#include "tegata/take/picture_file.h"
#include "tegata/take/result.h"
#include "tegata/take/test_folder.h"
#include "tegata/take/test_video.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCannotBeRead = "its picture cannot be read";

class BrokenRecording : public testing::Test {
 protected:
  static constexpr int kFrames = 6;

  void SetUp() override {
    const ProgramRun run = run_program({"simulate", take().string(), "--mode", "infrared",
                                        "--frames", text(kFrames), "--size", "160x120", "--quiet"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }

  fs::path take() const { return folder_ / "take"; }
  static std::string frame(int index) { return text("00000", index); }
  fs::path image(int camera, int index) const {
    return take() / "images" / text("camera_", camera) / (frame(index) + ".png");
  }
  fs::path video(int camera) const { return take() / "videos" / text("camera_", camera, ".avi"); }

  /// The same take with a video for each camera.
  void make_videos() const {
    fs::create_directory(take() / "videos");
    for (int camera = 0; camera < 3; ++camera) {
      std::vector<CameraImage> pictures;
      for (int i = 0; i < kFrames; ++i) pictures.push_back(read_picture(image(camera, i)));
      write_text(video(camera), motion_jpeg_avi(pictures));
    }
    fs::remove_all(take() / "images");
  }

  /// The masks that the program makes of the take, by camera and frame.
  std::map<std::string, std::string> masks(const std::string& name, ProgramRun& run) const {
    const fs::path made = folder_ / name;
    run = run_program({"segment", take().string(), "-o", made.string()});
    std::map<std::string, std::string> files;
    if (!fs::exists(made / "masks")) return files;
    for (const auto& file : fs::recursive_directory_iterator(made / "masks")) {
      if (!file.is_regular_file()) continue;
      const fs::path path = file.path();
      files[path.parent_path().filename().string() + " " + path.stem().string()] = read_text(path);
    }
    return files;
  }

  /// Segments and fits the take, and expects these views, as "camera_1 000003", to be lost.
  void expect_lost(std::map<std::string, std::string> whole,
                   const std::vector<std::string>& lost) const {
    for (const std::string& view : lost) whole.erase(view);
    ProgramRun run;
    const auto left = masks("left", run);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_TRUE(left == whole) << run.err;
    const auto json = nlohmann::json::parse(read_text(folder_ / "left" / "silhouettes.json"));
    std::vector<std::string> said;
    for (const auto& entry : json["frames"]) {
      if (!entry.contains("left_out")) continue;
      for (const auto& [camera, why] : entry["left_out"].items()) {
        said.push_back(text(camera, " ", entry["frame"].get<std::string>()));
        EXPECT_EQ(why, kCannotBeRead);
        EXPECT_NE(run.out.find(camera + " was left out of "), std::string::npos) << run.out;
        EXPECT_NE(run.err.find(text("frame ", entry["frame"].get<std::string>(), ", camera '",
                                    camera, "' is left out: ")),
                  std::string::npos)
            << run.err;
      }
    }
    std::sort(said.begin(), said.end());
    EXPECT_EQ(said, lost);
    for (const std::string& line : run.error_lines()) EXPECT_NE(line.front(), '[') << line;
    expect_fit_loses(lost);
  }

 private:
  void expect_fit_loses(const std::vector<std::string>& lost) const {
    const fs::path result = folder_ / "result";
    const ProgramRun fit =
        run_program({"fit", take().string(), "-o", result.string(), "--no-report"});
    ASSERT_EQ(fit.exit_code, 0) << fit.err;
    const Result fitted = read_result_json(result / "result.json");
    std::vector<std::string> said;
    for (const ResultFrame& entry : fitted.frames) {
      for (const auto& [camera, why] : entry.left_out) {
        if (why == kCannotBeRead) said.push_back(text(camera, " ", entry.name));
      }
    }
    std::sort(said.begin(), said.end());
    EXPECT_EQ(said, lost);
    const ProgramRun info = run_program({"info", result.string()});
    ASSERT_EQ(info.exit_code, 0) << info.err;
    for (const std::string& view : lost) {
      const std::string camera = view.substr(0, view.find(' '));
      EXPECT_NE(info.out.find(camera + " was left out of "), std::string::npos) << info.out;
      EXPECT_NE(info.out.find(view.substr(view.find(' ') + 1)), std::string::npos) << info.out;
    }
    EXPECT_EQ(run_program({"info", take().string()}).exit_code, 0);
  }

 protected:
  TestFolder folder_;
};

TEST_F(BrokenRecording, ATruncatedAndAnEmptyPictureAreTheOnlyOnesLost) {
  ProgramRun run;
  const auto whole = masks("whole", run);
  ASSERT_EQ(whole.size(), 3u * kFrames) << run.err;
  fs::resize_file(image(1, 2), fs::file_size(image(1, 2)) / 2);
  fs::resize_file(image(2, 4), 0);
  expect_lost(whole, {"camera_1 000002", "camera_2 000004"});
}

// Where picture `index` lies in an AVI, its header not included.
std::size_t picture_in(const std::string& avi, int index) {
  std::size_t at = avi.find("movi");
  for (int i = 0; i <= index; ++i) at = avi.find("00dc", at) + 4;
  return at + 4;
}

TEST_F(BrokenRecording, AVideoThatEndsEarlyLosesItsEndAndADamagedOneWhatIsDamaged) {
  make_videos();
  ProgramRun run;
  const auto whole = masks("whole", run);
  ASSERT_EQ(whole.size(), 3u * kFrames) << run.err;
  std::string avi = read_text(video(1));
  write_text(video(1), avi.substr(0, picture_in(avi, 4) + 100));
  avi = read_text(video(2));
  const std::size_t begin = picture_in(avi, 2) + 40, end = picture_in(avi, 3) + 40;
  avi.replace(begin, end - begin, end - begin, '\0');
  write_text(video(2), avi);
  expect_lost(whole, {"camera_1 000004", "camera_1 000005", "camera_2 000002", "camera_2 000003"});
}

}  // namespace
}  // namespace tegata
