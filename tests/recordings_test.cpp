// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Recordings of real hands through the whole program.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "run_program.h"
#include "tegata/base/angle.h"
#include "tegata/pipeline/calibrate_take.h"
#include "tegata/take/calibration_file.h"
#include "tegata/take/result.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

TEST(Recordings, TwoVideosOfABareHandAreFitted) {
  const fs::path recording = fs::path(TEGATA_DATA_DIR) / "hand_2cam";
  if (!fs::exists(recording)) GTEST_SKIP() << recording << " is not there";
  const TestFolder folder;
  const fs::path take = folder / "take", result = folder / "result";
  const std::string convert = text(TEGATA_SOURCE_DIR, "/examples/two_cameras/make_take.sh '",
                                   recording.string(), "' '", take.string(), "' >&2");
  ASSERT_EQ(std::system(convert.c_str()), 0);

  const ProgramRun run = run_program({"fit", take.string(), "-o", result.string(), "--quiet",
                                      "--no-report", "--grasp", "free", "--frames", "60:78:6"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Result fitted = read_result_json(result / "result.json");
  ASSERT_EQ(fitted.frames.size(), 4u);
  std::size_t ok = 0;
  double overlap = 0.0;
  for (const ResultFrame& frame : fitted.frames) {
    if (frame.status != "ok") continue;
    ASSERT_EQ(frame.silhouette_iou.size(), 2u);
    ++ok;
    for (const auto& [camera, iou] : frame.silhouette_iou) overlap += iou / 2.0;
  }
  EXPECT_GE(ok, 3u);
  EXPECT_GE(overlap / static_cast<double>(ok), 0.6);
}

// The board crossed an eighth of each picture, so lenses are those that its makers had calibrated
// by other pictures; the poses are ours.
class BoardOfFourCameras : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(folder_)) GTEST_SKIP() << folder_ << " is not there";
  }
  const fs::path folder_ = fs::path(TEGATA_DATA_DIR) / "board_4cam";
};

void expect_same_rig(const CameraRig& found, const CameraRig& solved) {
  ASSERT_EQ(found.size(), solved.size());
  for (std::size_t a = 0; a < found.size(); ++a) {
    for (std::size_t b = a + 1; b < found.size(); ++b) {
      const Rigid3d got = found[b].camera_from_world * found[a].camera_from_world.inverse();
      const Rigid3d expected = solved[b].camera_from_world * solved[a].camera_from_world.inverse();
      EXPECT_LT(got.rotation.angularDistance(expected.rotation), 0.5 * kDegree) << a << " " << b;
      EXPECT_NEAR(got.translation.norm() / expected.translation.norm(), 1.0, 0.01);
      EXPECT_LT((got.translation - expected.translation).norm(),
                0.01 * expected.translation.norm());
    }
  }
}

TEST_F(BoardOfFourCameras, PosesAreThoseOfTheSolvedCameras) {
  CalibrateTakeOptions options;
  options.intrinsics_file = find_intrinsics(folder_, "");
  ASSERT_EQ(options.intrinsics_file.filename(), "camera_array.toml");
  BoardRecording recording = read_board_recording(folder_, options, {});
  const CameraRig solved = read_calibration(options.intrinsics_file);
  BoardCalibrationOptions known;
  known.known_intrinsics = true;
  const BoardCalibration found = calibrate_rig(recording, known);
  EXPECT_LT(found.rms, 0.6);
  expect_same_rig(found.rig, solved);

  const BoardCalibration free = calibrate_rig(recording, {});
  EXPECT_LT(free.rms, 0.6);
  std::reverse(recording.cameras.begin(), recording.cameras.end());
  for (auto& frame : recording.views) std::reverse(frame.begin(), frame.end());
  const BoardCalibration turned = calibrate_rig(recording, known);
  for (std::size_t c = 0; c < found.rig.size(); ++c) {
    const Camera &one = found.rig[c], &other = turned.rig[found.rig.size() - 1 - c];
    EXPECT_EQ(one.name, other.name);
    EXPECT_LT((one.center_in_world() - other.center_in_world()).norm(), 1e-6);
    // Without those lenses it must be said that the directions are open.
    EXPECT_GT(free.cameras.at(one.name).direction_deviation, 0.5 * kDegree) << one.name;
  }
}

}  // namespace
}  // namespace tegata
