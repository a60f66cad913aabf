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
#include "tegata/base/error.h"
#include "tegata/math/so3.h"
#include "tegata/pipeline/calibrate_take.h"
#include "tegata/pipeline/check_calibration.h"
#include "tegata/take/calibration_file.h"
#include "tegata/take/picture_file.h"
#include "tegata/take/result.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

// By the example's script; its exit code.
int make_take(const fs::path& recording, const fs::path& take) {
  const std::string convert = text(TEGATA_SOURCE_DIR, "/examples/two_cameras/make_take.sh '",
                                   recording.string(), "' '", take.string(), "' >&2");
  return std::system(convert.c_str());
}

TEST(Recordings, TwoVideosOfABareHandAreFitted) {
  const fs::path recording = fs::path(TEGATA_DATA_DIR) / "hand_2cam";
  if (!fs::exists(recording)) GTEST_SKIP() << recording << " is not there";
  const TestFolder folder;
  const fs::path take = folder / "take", result = folder / "result";
  ASSERT_EQ(make_take(recording, take), 0);

  const ProgramRun run = run_program({"fit", take.string(), "-o", result.string(), "--quiet",
                                      "--no-report", "--grasp", "free", "--frames", "30:190:40"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Result fitted = read_result_json(result / "result.json");
  ASSERT_EQ(fitted.frames.size(), 5u);
  std::size_t ok = 0;
  for (const ResultFrame& frame : fitted.frames) {
    if (frame.status != "ok") continue;
    ASSERT_EQ(frame.silhouette_iou.size(), 2u);
    ++ok;
    for (const auto& [camera, overlap] : frame.silhouette_iou) {
      EXPECT_GE(overlap, 0.8) << frame.name << ' ' << camera;
    }
  }
  EXPECT_GE(ok, 4u);
}

class TwoCameras : public testing::Test {
 protected:
  void SetUp() override {
    const fs::path recording = fs::path(TEGATA_DATA_DIR) / "hand_2cam";
    if (!fs::exists(recording)) GTEST_SKIP() << recording << " is not there";
    const fs::path take = folder_ / "recording";
    ASSERT_EQ(make_take(recording, take), 0);
    const ProgramRun run = run_program(
        {"segment", take.string(), "-o", take_.string(), "--frames", "30:190:20", "--quiet"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    truth_ = read_calibration(take_ / "calibration.toml");
  }

  /// The problems that the check finds with other cameras.
  std::vector<CalibrationProblem> problems_of(const CameraRig& rig) const {
    write_calibration(rig, take_ / "calibration.toml");
    Take take = Take::open(take_);
    return check_take(take, {}, {}).calibration.problems;
  }
  /// What the start of a fit says.
  std::string warnings_of(const CameraRig& rig) const {
    write_calibration(rig, take_ / "calibration.toml");
    Take take = Take::open(take_);
    std::string warnings;
    const Observer observer{{}, [&](std::string_view message) { warnings += message; }};
    try {
      prepare_checked_take(take, {}, observer);
    } catch (const Error& error) {
      warnings += error.what();
    }
    return warnings;
  }
  CameraRig turned(std::size_t camera, const Eigen::Vector3d& by) const {
    CameraRig rig = truth_;
    Rigid3d& pose = rig[camera].camera_from_world;
    pose = {so3_exp(by) * pose.rotation, so3_exp(by) * pose.translation};
    return rig;
  }

  const TestFolder folder_;
  const fs::path take_ = folder_ / "take";
  CameraRig truth_;
};

bool names(const std::vector<CalibrationProblem>& problems, const std::string& camera,
           const std::string& cause) {
  return problems.size() == 1 &&
         std::count(problems[0].cameras.begin(), problems[0].cameras.end(), camera) == 1 &&
         problems[0].message.find(cause) != std::string::npos;
}

TEST_F(TwoCameras, WrongCalibrationsAreCaughtAndNamed) {
  EXPECT_TRUE(problems_of(truth_).empty());
  CameraRig exchanged = truth_;
  std::swap(exchanged[0].camera_from_world, exchanged[1].camera_from_world);
  constexpr const char* kExchanged = "'cam0' and 'cam1' seem to be exchanged";
  EXPECT_TRUE(names(problems_of(exchanged), "cam0", kExchanged));
  EXPECT_NE(warnings_of(exchanged).find(kExchanged), std::string::npos);
  for (std::size_t c = 0; c < 2; ++c) {
    const std::string name = truth_[c].name;
    for (const Eigen::Vector3d& axis : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0)}) {
      for (const double angle : {-5.0 * kDegree, 5.0 * kDegree}) {
        const auto problems = problems_of(turned(c, angle * axis));
        EXPECT_TRUE(names(problems, name, text("'", name, "' does not fit the others: turned")))
            << axis.transpose() << (problems.empty() ? "nothing found" : problems[0].message);
      }
    }
  }
  for (const auto& file : fs::directory_iterator(take_ / "masks" / "cam1")) {
    CameraImage mask = read_picture(file.path());
    for (int y = 0; y < mask.values.height(); ++y) {
      auto row = mask.values.values().begin() + y * mask.values.width();
      std::reverse(row, row + mask.values.width());
    }
    write_picture(mask, file.path());
  }
  const auto problems = problems_of(truth_);
  EXPECT_TRUE(names(problems, "cam1", "'cam1' seem to be mirrored left to right"))
      << (problems.empty() ? "nothing found" : problems[0].message);
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
