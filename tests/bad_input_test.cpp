// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Bad input through the real program: one line that says what, where and what would do, exit code
// 1, and nothing half-written beside what was there.
#include <gtest/gtest.h>
#include <sys/mount.h>

#include <filesystem>
#include <regex>

#include "run_program.h"
#include "tegata/take/calibration_file.h"
#include "tegata/take/picture_file.h"
#include "tegata/take/result.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

namespace fs = std::filesystem;

class BadInput : public testing::Test {
 protected:
  void SetUp() override {
    const ProgramRun run = run_program({"simulate", take().string(), "--mode", "mask", "--frames",
                                        "2", "--size", "320x240", "--quiet"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    for (const Camera& camera : read_calibration(take() / "calibration.toml")) {
      cameras_.push_back(camera.name);
    }
  }

  fs::path take() const { return folder_ / "take"; }
  fs::path result() const { return folder_ / "result"; }
  fs::path mask(std::size_t camera, const std::string& frame) const {
    return take() / "masks" / cameras_[camera] / (frame + ".png");
  }

  /// Replaces the first camera's value of a key in calibration.toml.
  void set_calibration(const std::string& key, const std::string& value) const {
    const fs::path file = take() / "calibration.toml";
    const std::string content = read_text(file);
    const std::regex line("(^|\\n)" + key + " = [^\\n]*");
    ASSERT_TRUE(std::regex_search(content, line)) << content;
    write_text(file, std::regex_replace(content, line, "$1" + key + " = " + value,
                                        std::regex_constants::format_first_only));
  }

  ProgramRun fit(std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {"fit", take().string(), "-o", result().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }

  /// Fits, and expects the one line and nothing else.
  template <typename... Parts>
  void expect_refused(const Parts&... parts) const {
    const ProgramRun run = fit({"--quiet"});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.out, "");
    ASSERT_EQ(run.error_lines().size(), 1u) << run.err;
    EXPECT_TRUE(says(run.error_lines().front(), "tegata: error: ", parts...));
    EXPECT_EQ(names_in(folder_.path()), std::vector<std::string>{"take"});
  }

  TestFolder folder_;
  std::vector<std::string> cameras_;
};

TEST_F(BadInput, TakeThatIsNotThere) {
  fs::remove_all(take());
  const ProgramRun run = fit();
  EXPECT_EQ(run.exit_code, 1);
  ASSERT_EQ(run.error_lines().size(), 1u) << run.err;
  EXPECT_TRUE(says(run.err.substr(0, run.err.size() - 1), take().string()));
  EXPECT_TRUE(names_in(folder_.path()).empty());
}

TEST_F(BadInput, MissingCalibration) {
  fs::remove(take() / "calibration.toml");
  expect_refused("calibration.toml", "no such file", "[cam_0]");
}

TEST_F(BadInput, CameraWithoutImages) {
  fs::remove_all(take() / "masks" / cameras_[1]);
  expect_refused(cameras_[1], "no pictures", "expected");
}

TEST_F(BadInput, PicturesOfAnotherSizeThanTheCalibration) {
  set_calibration("size", "[640, 480]");
  expect_refused(cameras_[0], "320 x 240", "640 x 480");
}

TEST_F(BadInput, MatrixThatIsNotFinite) {
  set_calibration("matrix", "[[nan, 0.0, 160.0], [0.0, 700.0, 120.0], [0.0, 0.0, 1.0]]");
  expect_refused("calibration.toml", "matrix", "cam_0", "finite");
}

TEST_F(BadInput, SingularMatrix) {
  set_calibration("matrix", "[[0.0, 0.0, 160.0], [0.0, 700.0, 120.0], [0.0, 0.0, 1.0]]");
  expect_refused("calibration.toml", "matrix", "cam_0", "positive");
}

TEST_F(BadInput, TranslationThatIsNotFinite) {
  set_calibration("translation", "[0.0, inf, 1.0]");
  expect_refused("calibration.toml", "translation", "cam_0", "finite");
}

TEST_F(BadInput, RotationThatMirrors) {
  set_calibration("rotation", "[[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]");
  expect_refused("calibration.toml", "rotation", "cam_0", "mirror");
}

TEST_F(BadInput, SingularRotation) {
  set_calibration("rotation", "[[1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]");
  expect_refused("calibration.toml", "rotation", "cam_0", "orthogonal");
}

TEST_F(BadInput, UnknownKey) {
  write_text(take() / "take.toml", "hnad = \"right\"\n");
  expect_refused("take.toml", "hnad", "hand");
}

TEST_F(BadInput, HandThatNothingTells) {
  write_text(take() / "take.toml", "name = \"anonymous\"\n");
  const fs::path file = folder_ / "hand.toml";
  const ProgramRun run =
      run_program({"hand", "personalise", take().string(), "-o", file.string(), "--quiet"});
  EXPECT_EQ(run.exit_code, 1);
  ASSERT_EQ(run.error_lines().size(), 1u) << run.err;
  EXPECT_TRUE(says(run.error_lines().front(), "--side", "take.toml"));
  EXPECT_FALSE(fs::exists(file));
}

TEST_F(BadInput, EmptySilhouettes) {
  for (std::size_t camera = 0; camera < cameras_.size(); ++camera) {
    for (const std::string frame : {"000000", "000001"}) {
      write_picture({Image<std::uint16_t>(320, 240), 8}, mask(camera, frame));
    }
  }
  expect_refused("none of 2 frames", "000000", "hand found in 0 view");
}

TEST_F(BadInput, NoFrameThatTwoCamerasHave) {
  for (std::size_t camera = 1; camera < cameras_.size(); ++camera) {
    const fs::path folder = take() / "masks" / cameras_[camera];
    fs::rename(folder / "000000.png", folder / (std::to_string(camera) + "00000.png"));
    fs::remove(folder / "000001.png");
  }
  expect_refused("masks", "two cameras", "same file names");
}

TEST_F(BadInput, FrameThatOnlyOneCameraHasIsReportedAndSkipped) {
  for (std::size_t camera = 1; camera < cameras_.size(); ++camera) {
    fs::remove(mask(camera, "000001"));
  }
  const ProgramRun run = fit({"--no-report"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("warning: frame 000001"), std::string::npos) << run.err;
  const Result fitted = read_result_json(result() / "result.json");
  ASSERT_EQ(fitted.frames.size(), 2u);
  EXPECT_TRUE(fitted.frames[0].pose.has_value());
  EXPECT_FALSE(fitted.frames[1].pose.has_value());
  EXPECT_NE(fitted.frames[1].status.find("1 camera"), std::string::npos);
  EXPECT_FALSE(fs::exists(result() / "meshes" / "000001.ply"));
}

TEST_F(BadInput, TruncatedPngIsNamedAndLeftOut) {
  fs::resize_file(mask(2, "000001"), fs::file_size(mask(2, "000001")) / 2);
  const ProgramRun run = fit({"--no-report"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  std::vector<std::string> warnings;
  for (const std::string& line : run.error_lines()) {
    if (line.find("warning") != std::string::npos) warnings.push_back(line);
  }
  ASSERT_EQ(warnings.size(), 1u) << run.err;
  EXPECT_TRUE(says(warnings[0], mask(2, "000001").string(), "000001", cameras_[2]));
  const Result fitted = read_result_json(result() / "result.json");
  EXPECT_EQ(fitted.frames[0].views.size(), cameras_.size());
  EXPECT_EQ(fitted.frames[1].views.size(), cameras_.size() - 1);
}

TEST_F(BadInput, OnlyTruncatedPngs) {
  for (std::size_t camera = 0; camera < cameras_.size(); ++camera) {
    for (const std::string frame : {"000000", "000001"}) {
      fs::resize_file(mask(camera, frame), fs::file_size(mask(camera, frame)) / 2);
    }
  }
  expect_refused("none of 2 frames", "0 camera");
}

TEST_F(BadInput, ResultFolderThatExistsIsRefusedWithoutForce) {
  fs::create_directory(result());
  write_text(result() / "result.json", "old");
  const ProgramRun refused = fit({"--quiet"});
  EXPECT_EQ(refused.exit_code, 1);
  ASSERT_EQ(refused.error_lines().size(), 1u) << refused.err;
  EXPECT_TRUE(says(refused.error_lines()[0], result().string(), "exists", "--force"));
  EXPECT_EQ(read_text(result() / "result.json"), "old");
  EXPECT_EQ(names_in(folder_.path()), (std::vector<std::string>{"result", "take"}));

  const ProgramRun forced = fit({"--quiet", "--force", "--no-report"});
  EXPECT_EQ(forced.exit_code, 0) << forced.err;
  EXPECT_NE(read_text(result() / "result.json"), "old");
  EXPECT_EQ(names_in(folder_.path()), (std::vector<std::string>{"result", "take"}));
}

TEST_F(BadInput, FailedFitWithForceKeepsTheOldResult) {
  fs::create_directory(result());
  write_text(result() / "result.json", "old");
  fs::remove(take() / "calibration.toml");
  EXPECT_EQ(fit({"--quiet", "--force"}).exit_code, 1);
  EXPECT_EQ(read_text(result() / "result.json"), "old");
  EXPECT_EQ(names_in(folder_.path()), (std::vector<std::string>{"result", "take"}));
}

TEST_F(BadInput, FitLeavesNothingWhereAFileCannotBeWrittenWhole) {
  // Too small for a hull, for the frames that wait on disk, for a mesh, and for the animation.
  const std::vector<std::pair<std::uint64_t, std::string>> limits = {
      {1000, "hulls"}, {8000, "a temporary file"}, {30000, "meshes"}, {100000, "hand.glb"}};
  for (const auto& [largest, what] : limits) {
    const ProgramRun run = run_program({"fit", take().string(), "-o", result().string(), "--quiet",
                                        "--hulls", "--triangles", "100"},
                                       largest);
    EXPECT_EQ(run.exit_code, 1) << largest;
    ASSERT_EQ(run.error_lines().size(), 1u) << run.err;
    EXPECT_TRUE(says(run.error_lines()[0], "tegata: error: ", folder_.path().string(), what));
    EXPECT_EQ(names_in(folder_.path()), std::vector<std::string>{"take"}) << largest;
  }
}

TEST_F(BadInput, SimulateLeavesNothingWhereAFileCannotBeWrittenWhole) {
  const fs::path other = folder_ / "other";
  for (const std::uint64_t largest : {600u, 5000u}) {
    const ProgramRun run =
        run_program({"simulate", other.string(), "--frames", "1", "--quiet"}, largest);
    EXPECT_EQ(run.exit_code, 1);
    ASSERT_EQ(run.error_lines().size(), 1u) << run.err;
    EXPECT_TRUE(says(run.error_lines()[0], "tegata: error: ", "other"));
    EXPECT_EQ(names_in(folder_.path()), std::vector<std::string>{"take"});
  }
}

TEST_F(BadInput, FullDiskLeavesNothing) {
  const fs::path disk = folder_ / "disk";
  fs::create_directory(disk);
  if (mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=64k") != 0) {
    GTEST_SKIP() << "only root can mount a small disk";
  }
  const ProgramRun run =
      run_program({"fit", take().string(), "-o", (disk / "result").string(), "--quiet"});
  const std::vector<std::string> left = names_in(disk);
  EXPECT_EQ(umount(disk.c_str()), 0);
  EXPECT_EQ(run.exit_code, 1);
  ASSERT_EQ(run.error_lines().size(), 1u) << run.err;
  EXPECT_TRUE(says(run.error_lines()[0], disk.string(), "written"));
  EXPECT_TRUE(left.empty());
}

TEST_F(BadInput, EvaluateNamesTheTruthThatIsMissing) {
  ASSERT_EQ(fit({"--quiet", "--no-report"}).exit_code, 0);
  fs::remove(take() / "truth.json");
  const ProgramRun run = run_program({"evaluate", result().string(), "--truth", take().string()});
  EXPECT_EQ(run.exit_code, 1);
  ASSERT_EQ(run.error_lines().size(), 1u) << run.err;
  EXPECT_TRUE(says(run.error_lines()[0], "tegata: error: ", "truth.json"));
}

TEST_F(BadInput, FramesBeyondTheTake) {
  const ProgramRun run = fit({"--quiet", "--frames", "7:9"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.error_lines().size(), 1u) << run.err;
  EXPECT_EQ(names_in(folder_.path()), std::vector<std::string>{"take"});
}

TEST(Usage, MistakesExitWithTwoAndMakeNothing) {
  const TestFolder folder;
  const std::string made = (folder / "made").string();
  const std::vector<std::vector<std::string>> mistakes = {
      {},
      {"fti"},
      {"fit", "take"},
      {"fit", "take", "-o", made, "--frames", "5"},
      {"fit", "take", "-o", made, "--frames", "5:2"},
      {"fit", "take", "-o", made, "--frames", "0:8:0"},
      {"fit", "take", "-o", made, "--frames", "0:-1"},
      {"fit", "take", "-o", made, "--voxel-mm", "0"},
      {"fit", "take", "-o", made, "--grasp", "loose"},
      {"simulate", made, "--cameras", "1"},
      {"simulate", made, "--size", "640"},
      {"simulate", made, "--bits", "12"},
      {"simulate", made, "--threads", "-1"},
  };
  for (const std::vector<std::string>& arguments : mistakes) {
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 2) << (arguments.empty() ? "" : arguments.back());
    EXPECT_NE(run.err, "");
    EXPECT_TRUE(names_in(folder.path()).empty());
  }
}

TEST(Usage, EveryCommandExplainsItselfWithAnExample) {
  for (const std::string command : {"simulate", "fit", "evaluate", "info", "picture"}) {
    const ProgramRun run = run_program({command, "--help"});
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_NE(run.out.find("Example: tegata " + command), std::string::npos) << run.out;
  }
  EXPECT_EQ(run_program({"--version"}).out.substr(0, 7), "tegata ");
}

}  // namespace
}  // namespace tegata
