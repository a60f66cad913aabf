// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/calibration_file.h"

#include <gtest/gtest.h>

#include <string>

#include "tegata/math/so3.h"
#include "tegata/take/staged_folder.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

const std::string kLeft = R"([cam_0]
name = "left"
size = [640, 480]
matrix = [[1450.0, 0.0, 320.0], [0.0, 1440.0, 240.0], [0.0, 0.0, 1.0]]
distortions = [0.1, 0.2, 0.3, 0.4, 0.5]
rotation = [0.1, -0.2, 0.3]
translation = [10.0, 0.0, 100]
)";
const std::string kRight = R"([cam_1]
name = "right"
size = [640.0, 480.0]
matrix = [[1450, 0, 320], [0, 1450, 240], [0, 0, 1]]
distortions = []
rotation = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]
translation = [0.0, 0.0, 1.0]
)";

std::string replaced(std::string content, const std::string& from, const std::string& to) {
  const std::size_t at = content.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? content : content.replace(at, from.size(), to);
}

CameraRig read(const std::string& content, double metres_per_unit = 1.0) {
  const TestFolder folder;
  write_file(folder / "calibration.toml", content);
  return read_calibration(folder / "calibration.toml", metres_per_unit);
}

// The message for the left camera with a line's part replaced.
std::string error_with(const std::string& from, const std::string& to) {
  return error_of([&] { read(replaced(kLeft, from, to) + kRight); });
}

TEST(Calibration, EveryNumberArrivesWhereItBelongs) {
  const CameraRig rig = read(kLeft + kRight, 0.01);
  ASSERT_EQ(rig.size(), 2u);
  EXPECT_EQ(rig[0].name, "left");
  EXPECT_EQ(rig[0].width, 640);
  EXPECT_EQ(rig[0].height, 480);
  EXPECT_EQ(rig[0].fx, 1450.0);
  EXPECT_EQ(rig[0].fy, 1440.0);
  EXPECT_EQ(rig[0].cx, 320.0);
  EXPECT_EQ(rig[0].cy, 240.0);
  EXPECT_EQ(rig[0].distortion, (Distortion{0.1, 0.2, 0.3, 0.4, 0.5}));
  EXPECT_LT(rig[0].camera_from_world.rotation.angularDistance(so3_exp({0.1, -0.2, 0.3})), 1e-12);
  EXPECT_LT((rig[0].camera_from_world.translation - Eigen::Vector3d(0.1, 0.0, 1.0)).norm(), 1e-12);
  EXPECT_LT(
      (rig[1].camera_from_world.rotation * Eigen::Vector3d(0, 0, 1) - Eigen::Vector3d(0, 1, 0))
          .norm(),
      1e-12);
}

TEST(Calibration, CamerasKeepTheOrderOfTheFileNotOfTheAlphabet) {
  std::string content;
  for (const int i : {10, 9, 2}) {
    content += replaced(replaced(kLeft, "cam_0", text("cam_", i)), "left", text("camera", i));
  }
  const CameraRig rig = read(content);
  ASSERT_EQ(rig.size(), 3u);
  EXPECT_EQ(rig[0].name, "camera10");
  EXPECT_EQ(rig[1].name, "camera9");
  EXPECT_EQ(rig[2].name, "camera2");
}

TEST(Calibration, WhatIsWrittenReadsBackTheSame) {
  CameraRig rig = read(kLeft + kRight, 1.0 / 3.0);
  rig[1].distortion = {1e-5, 0, 0, 0, 0, 0, 0, 0, 0, 1.0 / 7.0};
  rig[1].name = "quo\"te\\";
  const TestFolder folder;
  write_calibration(rig, folder / "a.toml");
  const CameraRig back = read_calibration(folder / "a.toml");
  ASSERT_EQ(back.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back[i].name, rig[i].name);
    EXPECT_EQ(back[i].fy, rig[i].fy);
    EXPECT_EQ(back[i].distortion, rig[i].distortion);
    EXPECT_EQ(back[i].camera_from_world.translation, rig[i].camera_from_world.translation);
    EXPECT_LT(back[i].camera_from_world.rotation.angularDistance(rig[i].camera_from_world.rotation),
              1e-12);
  }
  write_calibration(back, folder / "b.toml");
  EXPECT_EQ(read_file(folder / "a.toml"), read_file(folder / "b.toml"));
}

TEST(Calibration, OtherToolsKeysAndTablesDoNotMatter) {
  const CameraRig rig = read(kLeft + "fisheye = false\nerror = 0.3\ngrid_count = 24\n" + kRight +
                             "[metadata]\nadjusted = false\nerror = 0.5\n"
                             "[charuco]\ncolumns = 4\nsize = [1, 2]\n");
  EXPECT_EQ(rig.size(), 2u);
}

TEST(Calibration, UnknownKeysAreSaidWithThoseThatWouldDo) {
  EXPECT_TRUE(says(error_with("distortions", "distorsions"), "calibration.toml", "[cam_0]",
                   "'distorsions'", "'distortions'"));
  EXPECT_TRUE(says(error_of([] { read("metres_per_unit = 1.0\n" + kLeft + kRight); }),
                   "'metres_per_unit'", "cam_0"));
}

TEST(Calibration, MissingKeysAndWrongTypesAreSaid) {
  EXPECT_TRUE(says(error_with("name = \"left\"\n", ""), "[cam_0]", "'name'", "missing"));
  EXPECT_TRUE(says(error_with("[640, 480]", "\"640x480\""), "'size'", "a string", "array"));
  EXPECT_TRUE(says(error_with("[640, 480]", "[640, 480, 3]"), "'size'", "3 numbers"));
  EXPECT_TRUE(says(error_with("[640, 480]", "[640, -480]"), "'size'", "-480"));
  EXPECT_TRUE(says(error_with("[640, 480]", "[640.5, 480]"), "'size'", "640.5"));
  EXPECT_TRUE(says(error_with("translation = [10.0, 0.0, 100]", "translation = [10.0, 0.0]"),
                   "'translation'", "2 numbers"));
  EXPECT_TRUE(says(error_with("0.4, 0.5]", "0.4, nan]"), "'distortions'", "nan", "finite"));
  EXPECT_TRUE(says(error_with("0.4, 0.5]", "0.4, 0.5, 0.6]"), "'distortions'", "6 numbers"));
  EXPECT_TRUE(says(error_with("\"left\"", "\"../left\""), "'name'", "../left"));
  EXPECT_TRUE(says(error_with("[cam_0]", "[cam_0"), "calibration.toml", "line 1", "not TOML"));
}

TEST(Calibration, MatricesThatNoCameraHasAreSaid) {
  EXPECT_TRUE(says(error_with("1450.0, 0.0, 320.0", "0.0, 0.0, 320.0"), "'matrix'", "focal"));
  EXPECT_TRUE(says(error_with("1450.0, 0.0, 320.0", "-1450.0, 0.0, 320.0"), "'matrix'", "-1450"));
  EXPECT_TRUE(
      says(error_with("1450.0, 0.0, 320.0", "1450.0, 2.0, 320.0"), "'matrix'", "skew of 2"));
  EXPECT_TRUE(says(error_with("0.0, 0.0, 1.0]", "0.0, 0.0, 0.0]"), "'matrix'", "last row"));
  EXPECT_TRUE(says(error_with(", [0.0, 0.0, 1.0]]", "]"), "'matrix'", "array of 2"));
  EXPECT_TRUE(says(error_with("0.0, 0.0, 1.0]", "0.0, 1.0]"), "'matrix'", "2 numbers in row 3"));
}

TEST(Calibration, RotationsThatMirrorOrStretchAreSaid) {
  const std::string vector = "[0.1, -0.2, 0.3]";
  EXPECT_TRUE(says(error_with(vector, "[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]]"),
                   "'rotation'", "mirrors"));
  EXPECT_TRUE(says(error_with(vector, "[[1.1, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]"),
                   "'rotation'", "orthogonal"));
  EXPECT_TRUE(says(error_with(vector, "[0.1, -0.2]"), "'rotation'", "2 numbers"));
}

TEST(Calibration, FisheyeLensesHaveFourCoefficients) {
  EXPECT_TRUE(says(error_of([] { read(kLeft + "fisheye = true\n" + kRight); }), "[cam_0]",
                   "'distortions'", "5 numbers", "0 or 4"));
  const CameraRig rig =
      read(kLeft + replaced(kRight, "[]", "[0.1, 0.2, 0.3, 0.4]") + "fisheye = true\n");
  EXPECT_EQ(rig[0].lens_model, LensModel::perspective);
  EXPECT_EQ(rig[1].lens_model, LensModel::fisheye);
}

TEST(Calibration, OneCameraOrTwoOfOneNameAreNoRig) {
  EXPECT_TRUE(says(error_of([] { read(kLeft); }), "calibration.toml", "1 camera"));
  EXPECT_TRUE(says(error_of([] { read(kLeft + replaced(kRight, "right", "left")); }),
                   "calibration.toml", "'left'"));
  EXPECT_TRUE(says(error_of([] { read_calibration("nowhere/calibration.toml"); }),
                   "nowhere/calibration.toml", "No such file"));
}

TEST(Calibration, ReadsACalibrationOfCaliscope) {
  const std::filesystem::path file = TEGATA_DATA_DIR "/board_4cam/camera_array.toml";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the recording board_4cam is not here";
  const CameraRig rig = read_calibration(file);
  ASSERT_EQ(rig.size(), 4u);
  EXPECT_EQ(rig[2].name, "cam_2");
  EXPECT_EQ(rig[0].width, 1280);
  EXPECT_NEAR(rig[0].camera_from_world.rotation.toRotationMatrix()(0, 1), -0.8200005, 1e-6);
}

}  // namespace
}  // namespace tegata
