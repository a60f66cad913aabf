// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// The same cameras, written here as each tool writes them, come back through every importer.
#include "tegata/take/calibration_import.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <opencv2/core.hpp>

#include "tegata/math/so3.h"
#include "tegata/take/calibration_file.h"
#include "tegata/take/staged_folder.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

// 17 digits: what reads back as the same number.
std::string digits(double value) {
  std::array<char, 40> written;
  std::snprintf(written.data(), written.size(), "%.17g", value);
  return written.data();
}

template <typename... Values>
std::string row(const Values&... values) {
  std::string line;
  ((line += (line.empty() ? "" : ", ") + digits(values)), ...);
  return line;
}

Camera camera(const std::string& name, double turn) {
  Camera made;
  made.name = name;
  made.width = 1280;
  made.height = 720;
  made.fx = 901.0 + turn;
  made.fy = 899.0 - turn / 3.0;
  made.cx = 641.2 + turn;
  made.cy = 357.1 / 0.999;
  made.distortion = {-0.2 + 0.01 * turn, 0.05 / 3.0, 1e-3, -2e-3 / 7.0};
  made.camera_from_world = {so3_exp({0.3 * turn, -1.1, 2.0 / (1.0 + turn)}),
                            {0.1 / 3.0, -0.7 * turn, 1.4}};
  return made;
}

CameraRig rig() { return {camera("01", 0.0), camera("02", 1.0), camera("10", 2.0)}; }

CameraRig with_coefficients(std::size_t count) {
  CameraRig cameras = rig();
  for (Camera& c : cameras) {
    for (std::size_t i = 4; i < count; ++i)
      c.distortion[i] = 0.001 / (3.0 + static_cast<double>(i));
  }
  return cameras;
}

CameraRig fisheye() {
  CameraRig cameras = rig();
  for (Camera& c : cameras) c.lens_model = LensModel::fisheye;
  return cameras;
}

void expect_same(const CameraRig& got, const CameraRig& expected) {
  constexpr double kTolerance = 1e-9;
  ASSERT_EQ(got.size(), expected.size());
  for (std::size_t i = 0; i < got.size(); ++i) {
    const Camera &a = got[i], &b = expected[i];
    SCOPED_TRACE(b.name);
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    EXPECT_EQ(a.lens_model, b.lens_model);
    const Eigen::Vector4d ours(a.fx, a.fy, a.cx, a.cy), theirs(b.fx, b.fy, b.cx, b.cy);
    EXPECT_LT((ours - theirs).norm(), kTolerance);
    for (std::size_t k = 0; k < a.distortion.size(); ++k) {
      EXPECT_NEAR(a.distortion[k], b.distortion[k], kTolerance) << k;
    }
    EXPECT_LT((a.camera_from_world.translation - b.camera_from_world.translation).norm(),
              kTolerance);
    EXPECT_LT((a.camera_from_world.rotation.toRotationMatrix() -
               b.camera_from_world.rotation.toRotationMatrix())
                  .norm(),
              kTolerance);
  }
}

class CalibrationImport : public testing::Test {
 protected:
  CameraRig read(const std::string& name, CalibrationFormat format,
                 const CalibrationImportOptions& options = {}) const {
    const ImportedCalibration imported =
        import_calibration(name.empty() ? folder_.path() : folder_ / name, options);
    EXPECT_EQ(imported.format, format) << calibration_format_name(imported.format);
    return imported.rig;
  }
  void write(const std::string& name, const std::string& content) const {
    write_file(folder_ / name, content);
  }
  TestFolder folder_;
};

Eigen::Matrix3d matrix_of(const Camera& c) {
  Eigen::Matrix3d k;
  k << c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1;
  return k;
}

cv::Mat to_cv(const Eigen::MatrixXd& matrix) {
  cv::Mat mat(static_cast<int>(matrix.rows()), static_cast<int>(matrix.cols()), CV_64F);
  for (int y = 0; y < mat.rows; ++y) {
    for (int x = 0; x < mat.cols; ++x) mat.at<double>(y, x) = matrix(y, x);
  }
  return mat;
}

cv::Mat distortion_to_cv(const Camera& c, int count) {
  return cv::Mat(1, count, CV_64F, const_cast<double*>(c.distortion.data())).clone();
}

TEST_F(CalibrationImport, TomlOfEveryLensComesBack) {
  for (const CameraRig& cameras :
       {rig(), with_coefficients(5), with_coefficients(8), with_coefficients(12), fisheye()}) {
    write_calibration(cameras, folder_ / "any.toml");
    expect_same(read("any.toml", CalibrationFormat::toml), cameras);
  }
}

TEST_F(CalibrationImport, EasyMocapsVectorsAndMatricesComeBack) {
  const CameraRig cameras = with_coefficients(5);
  for (const bool with_matrix : {true, false}) {
    cv::FileStorage intri((folder_ / "intri.yml").string(), cv::FileStorage::WRITE);
    cv::FileStorage extri((folder_ / "extri.yml").string(), cv::FileStorage::WRITE);
    for (cv::FileStorage* file : {&intri, &extri}) {
      *file << "names"
            << "[";
      for (const Camera& c : cameras) *file << c.name;
      *file << "]";
    }
    for (const Camera& c : cameras) {
      intri << "K_" + c.name << to_cv(matrix_of(c)) << "dist_" + c.name << distortion_to_cv(c, 5);
      intri << "H_" + c.name << c.height << "W_" + c.name << c.width;
      extri << "R_" + c.name << to_cv(so3_log(c.camera_from_world.rotation));
      if (with_matrix) {
        extri << "Rot_" + c.name << to_cv(c.camera_from_world.rotation.toRotationMatrix());
      }
      extri << "T_" + c.name << to_cv(c.camera_from_world.translation);
    }
    intri.release();
    extri.release();
    expect_same(read("", CalibrationFormat::easymocap), cameras);
    expect_same(read("extri.yml", CalibrationFormat::easymocap), cameras);
  }
}

TEST_F(CalibrationImport, EasyMocapsNamesKeepTheirZerosAndSizesAreAskedFor) {
  const std::string one =
      "K_007: [900.0, 0, 640, 0, 900.0, 360, 0, 0, 1]\ndist_007: [0,0,0,0,0]\n"
      "R_007: [0.0, 0.1, 0.0]\nT_007: [0,0,100]\n";
  const std::string two =
      "K_08: [900.0, 0, 640, 0, 900.0, 360, 0, 0, 1]\ndist_08: [0,0,0,0,0]\n"
      "R_08: [0.0, 0.2, 0.0]\nT_08: [0,0,100]\n";
  write("intri.yml", one + two);
  EXPECT_TRUE(says(error_of([&] { import_calibration(folder_ / "intri.yml"); }), "intri.yml",
                   "W_007", "--size"));
  const CameraRig cameras = read("intri.yml", CalibrationFormat::easymocap,
                                 {.metres_per_unit = 0.01, .size = PictureSize{1280, 720}});
  ASSERT_EQ(cameras.size(), 2u);
  EXPECT_EQ(cameras[0].name, "007");
  EXPECT_EQ(cameras[1].camera_from_world.translation.z(), 1.0);
  write("intri.yml", one + two + "Rot_08: [1, 0, 0, 0, 1, 0, 0, 0, 1]\n");
  EXPECT_TRUE(says(error_of([&] {
                     import_calibration(folder_ / "intri.yml", {1.0, PictureSize{1280, 720}});
                   }),
                   "Rot_08", "R_08"));
}

std::string kalibr(const CameraRig& cameras) {
  std::string content;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const Camera& c = cameras[i];
    content += text(
        "cam", i, ":\n  cam_overlaps: [0, 1]\n  camera_model: pinhole\n", "  distortion_coeffs: [",
        row(c.distortion[0], c.distortion[1], c.distortion[2], c.distortion[3]),
        "]\n  distortion_model: ", c.lens_model == LensModel::fisheye ? "equidistant" : "radtan",
        "\n  intrinsics: [", row(c.fx, c.fy, c.cx, c.cy), "]\n  resolution: [", c.width, ", ",
        c.height, "]\n  rostopic: /cam", i, "/image_raw\n");
    if (i == 0) continue;
    const Rigid3d step = c.camera_from_world * cameras[i - 1].camera_from_world.inverse();
    const Eigen::Matrix3d r = step.rotation.toRotationMatrix();
    content += "  T_cn_cnm1:\n";
    for (int k = 0; k < 3; ++k) {
      content += "  - [" + row(r(k, 0), r(k, 1), r(k, 2), step.translation[k]) + "]\n";
    }
    content += "  - [0.0, 0.0, 0.0, 1.0]\n";
  }
  return content;
}

TEST_F(CalibrationImport, KalibrsChainComesBackFromTheFirstCamerasFrame) {
  for (CameraRig cameras : {rig(), fisheye()}) {
    write("camchain.yaml", kalibr(cameras));
    const Rigid3d world_from_first = cameras[0].camera_from_world.inverse();
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      cameras[i].name = text("cam", i);
      cameras[i].camera_from_world = cameras[i].camera_from_world * world_from_first;
    }
    expect_same(read("camchain.yaml", CalibrationFormat::kalibr), cameras);
  }
}

TEST_F(CalibrationImport, KalibrsOtherModelsAreSaidNotMisread) {
  std::string content = kalibr(rig());
  content.replace(content.find("pinhole"), 7, "omni");
  write("camchain.yaml", content);
  EXPECT_TRUE(says(error_of([&] { import_calibration(folder_ / "camchain.yaml"); }), "cam0",
                   "'omni'", "'pinhole'"));
}

std::string colmap_images(const CameraRig& cameras, const std::string& ending) {
  std::string images = "# Image list\n";
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const Eigen::Quaterniond& q = cameras[i].camera_from_world.rotation;
    const Eigen::Vector3d& t = cameras[i].camera_from_world.translation;
    images +=
        text(i + 7, " ", digits(q.w()), " ", digits(q.x()), " ", digits(q.y()), " ", digits(q.z()),
             " ", digits(t.x()), " ", digits(t.y()), " ", digits(t.z()), " ", i + 1, " ",
             cameras[i].name, ending, "\n", i == 0 ? "" : "103.5 20.25 -1 4.5 8.5 12", "\n");
  }
  return images;
}

TEST_F(CalibrationImport, ColmapsModelsComeBackWithTheirHalfPixel) {
  struct Case {
    CameraRig rig;
    std::string model;
    std::size_t coefficients;
  };
  CameraRig ideal = rig();
  for (Camera& c : ideal) c.distortion = {};
  for (const Case& one : {Case{rig(), "OPENCV", 4}, Case{with_coefficients(8), "FULL_OPENCV", 8},
                          Case{fisheye(), "OPENCV_FISHEYE", 4}, Case{ideal, "PINHOLE", 0}}) {
    SCOPED_TRACE(one.model);
    std::string cameras = "# Camera list\n";
    for (std::size_t i = 0; i < one.rig.size(); ++i) {
      const Camera& c = one.rig[i];
      cameras += text(i + 1, " ", one.model, " ", c.width, " ", c.height, " ", digits(c.fx), " ",
                      digits(c.fy), " ", digits(c.cx + 0.5), " ", digits(c.cy + 0.5));
      for (std::size_t k = 0; k < one.coefficients; ++k) cameras += " " + digits(c.distortion[k]);
      cameras += "\n";
    }
    write("cameras.txt", cameras);
    write("images.txt", colmap_images(one.rig, "/000000.png"));
    expect_same(read("", CalibrationFormat::colmap), one.rig);
    write("images.txt", colmap_images(one.rig, ".png"));
    expect_same(read("images.txt", CalibrationFormat::colmap), one.rig);
  }
}

TEST_F(CalibrationImport, ColmapsModelsOfOneFocalLengthAreReadInTheirOrder) {
  write("cameras.txt",
        "1 SIMPLE_PINHOLE 640 480 500 320.5 240.5\n2 SIMPLE_RADIAL 640 480 501 320.5 240.5 -0.1\n"
        "3 RADIAL 640 480 502 320.5 240.5 -0.1 0.02\n");
  write("images.txt", colmap_images(rig(), ".jpg"));
  const CameraRig cameras = read("", CalibrationFormat::colmap);
  ASSERT_EQ(cameras.size(), 3u);
  EXPECT_EQ(cameras[0].fy, 500.0);
  EXPECT_EQ(cameras[1].cx, 320.0);
  EXPECT_EQ(cameras[1].distortion, (Distortion{-0.1}));
  EXPECT_EQ(cameras[2].distortion, (Distortion{-0.1, 0.02}));
  write("cameras.txt", "1 THIN_PRISM_FISHEYE 640 480 500 320.5 240.5\n");
  EXPECT_TRUE(says(error_of([&] { import_calibration(folder_.path()); }), "cameras.txt", "line 1",
                   "THIN_PRISM_FISHEYE", "OPENCV_FISHEYE"));
}

TEST_F(CalibrationImport, FileStorageOfAllThreeKindsComesBack) {
  for (const std::string name : {"rig.yml", "rig.xml", "rig.json"}) {
    for (const int count : {4, 5, 8, 12, 0}) {
      const CameraRig cameras =
          count == 0 ? fisheye() : with_coefficients(static_cast<std::size_t>(count));
      cv::FileStorage file((folder_ / name).string(), cv::FileStorage::WRITE);
      for (const Camera& c : cameras) {
        file << "cam_" + c.name << "{";
        file << "name" << c.name << "image_width" << c.width << "image_height" << c.height;
        file << "camera_matrix" << to_cv(matrix_of(c));
        file << "distortion_coefficients" << distortion_to_cv(c, count == 0 ? 4 : count);
        file << "fisheye" << (count == 0 ? 1 : 0);
        file << "R" << to_cv(c.camera_from_world.rotation.toRotationMatrix());
        file << "T" << to_cv(c.camera_from_world.translation) << "}";
      }
      file.release();
      SCOPED_TRACE(text(name, " with ", count));
      expect_same(read(name, CalibrationFormat::opencv), cameras);
    }
  }
}

TEST_F(CalibrationImport, OpenCvsStereoFilesComeBack) {
  CameraRig cameras = with_coefficients(5);
  cameras.pop_back();
  const Rigid3d step = cameras[1].camera_from_world * cameras[0].camera_from_world.inverse();
  for (const std::string ending : {"yml", "xml"}) {
    cv::FileStorage in((folder_ / ("intrinsics." + ending)).string(), cv::FileStorage::WRITE);
    in << "M1" << to_cv(matrix_of(cameras[0])) << "D1" << distortion_to_cv(cameras[0], 5);
    in << "M2" << to_cv(matrix_of(cameras[1])) << "D2" << distortion_to_cv(cameras[1], 5);
    in.release();
    cv::FileStorage ex((folder_ / ("extrinsics." + ending)).string(), cv::FileStorage::WRITE);
    ex << "R" << to_cv(step.rotation.toRotationMatrix()) << "T" << to_cv(step.translation);
    ex.release();
    CameraRig expected = cameras;
    expected[0].name = "left";
    expected[0].camera_from_world = {};
    expected[1].name = "right";
    expected[1].camera_from_world = step;
    expect_same(
        read("intrinsics." + ending, CalibrationFormat::opencv, {.size = PictureSize{1280, 720}}),
        expected);
  }
}

TEST_F(CalibrationImport, WhatIsNoCalibrationIsSaidInOneLine) {
  const auto message = [&](const std::string& content) {
    write("some.yml", content);
    return error_of([&] { import_calibration(folder_ / "some.yml"); });
  };
  EXPECT_TRUE(says(message(""), "some.yml", "0 cameras"));
  EXPECT_TRUE(says(message("a: [1, 2"), "some.yml", "not YAML"));
  EXPECT_TRUE(says(message("<opencv_storage><a></b></opencv_storage>"), "some.yml", "'b'"));
  EXPECT_TRUE(says(message("<opencv_storage"), "some.yml", "XML"));
  EXPECT_TRUE(says(message("camera_matrix: [1, 0, 0]\n"), "some.yml", "one camera"));
  EXPECT_TRUE(says(message("c: {K: &a [*a]}"), "some.yml"));
  EXPECT_TRUE(says(message("c: {K: [1, 0, 0, 0, 1, 0, 0, 0, .nan]}"), "c.K", ".nan", "finite"));
  EXPECT_TRUE(says(error_of([&] { import_calibration(folder_.path()); }), "without a calibration"));
  EXPECT_TRUE(says(error_of([&] { import_calibration(folder_ / "no.yml"); }), "no.yml"));
}

TEST_F(CalibrationImport, ThisIsWhatOtherToolsAddToTheirToml) {
  write_calibration(rig(), folder_ / "a.toml");
  const std::string own = read_file(folder_ / "a.toml");
  // Anipose and Pose2Sim; FreeMoCap; Caliscope, and keys that a later version may add.
  for (const std::string extra :
       {"fisheye = false\n[metadata]\nadjusted = false\nerror = 0.43\n",
        "world_position = [0.0, 1.0, 2.0]\nsomething_new = 3\n[metadata]\ngroundplane = true\n",
        "error = 0.2\ngrid_count = 20\nport = 2\nrotation_count = -1\nnewer = \"yes\"\n"}) {
    write("b.toml", own + extra);
    expect_same(read("b.toml", CalibrationFormat::toml), rig());
  }
  write("b.toml", own + "distorsions = []\n");
  EXPECT_TRUE(says(error_of([&] { import_calibration(folder_ / "b.toml"); }), "distorsions"));
}

}  // namespace
}  // namespace tegata
