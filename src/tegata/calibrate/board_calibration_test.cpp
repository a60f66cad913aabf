// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/calibrate/board_calibration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tegata/base/error.h"
#include "tegata/base/random.h"
#include "tegata/base/text.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

constexpr std::size_t kFrames = 24;

Board board() {
  Board made;
  made.columns = 7;
  made.rows = 5;
  made.spacing = 0.04;
  made.marker = 0.03;
  return made;
}

// Three cameras on an arc; neighbours overlap.
CameraRig truth() {
  CameraRig rig;
  for (int i = 0; i < 3; ++i) {
    Camera camera;
    camera.name = text("cam_", i);
    camera.width = 640;
    camera.height = 480;
    camera.fx = camera.fy = 700.0 + 20.0 * i;
    camera.cx = 322.0;
    camera.cy = 238.0;
    camera.distortion = {-0.1, 0.05};
    camera.camera_from_world = {so3_exp({0.0, 0.5 * i, 0.0}), {0.0, 0.0, 0.9}};
    rig.push_back(camera);
  }
  return rig;
}

// Cameras 0 and 2 never see the board at the same moment. One view may be blurred in two, and the
// board be moved and tilted less.
BoardRecording recorded(const CameraRig& rig, bool broken_view, double spread = 1.0) {
  Random random(5);
  BoardRecording recording;
  recording.board = board();
  for (const Camera& camera : rig) {
    Camera seen;
    seen.name = camera.name;
    seen.width = camera.width;
    seen.height = camera.height;
    recording.cameras.push_back(seen);
  }
  const std::vector<Eigen::Vector3d> points = board_points(recording.board);
  for (std::size_t f = 0; f < kFrames; ++f) {
    recording.frame_names.push_back(text("frame_", f));
    const Rigid3d pose = {
        so3_exp({spread * random.uniform(-0.6, 0.6), -0.5 + spread * random.uniform(-0.6, 0.6),
                 spread * random.uniform(-1.5, 1.5)}),
        spread * Eigen::Vector3d(random.uniform(-0.2, 0.2), random.uniform(-0.15, 0.15),
                                 random.uniform(-0.15, 0.15))};
    std::vector<BoardView> views(rig.size());
    for (std::size_t c = 0; c < rig.size(); ++c) {
      if (c == (f % 2 == 0 ? 0u : 2u)) continue;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const auto pixel = project(rig[c], pose * points[i]);
        if (!pixel || !rig[c].contains(*pixel)) continue;
        const Eigen::Vector2d noise(random.normal(0.0, 0.1), random.normal(0.0, 0.1));
        // No pose of the board explains points that part.
        const double apart = i % 2 == 0 ? 12.0 : -12.0;
        const double shift = broken_view && f == 3 && c == 1 ? apart : 0.0;
        views[c].points.push_back(static_cast<int>(i));
        views[c].pixels.push_back(*pixel + noise + Eigen::Vector2d(shift, -shift));
      }
    }
    recording.views.push_back(std::move(views));
  }
  return recording;
}

double distance_error(const CameraRig& a, const CameraRig& b, std::size_t i, std::size_t j) {
  const double got = (a[i].center_in_world() - a[j].center_in_world()).norm();
  const double expected = (b[i].center_in_world() - b[j].center_in_world()).norm();
  return std::abs(got / expected - 1.0);
}

TEST(BoardCalibration, FindsCamerasThatNeverSeeTheBoardTogether) {
  const CameraRig expected = truth();
  const BoardCalibration found = calibrate_rig(recorded(expected, false), {});
  EXPECT_LT(found.rms, 0.2);
  EXPECT_TRUE(found.outliers.empty());
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(found.rig[i].fx / expected[i].fx, 1.0, 0.01);
    const Rigid3d got = found.rig[i].camera_from_world * found.rig[0].camera_from_world.inverse();
    const Rigid3d wanted = expected[i].camera_from_world * expected[0].camera_from_world.inverse();
    EXPECT_LT(got.rotation.angularDistance(wanted.rotation), 0.5 / 57.3);
    if (i > 0) {
      EXPECT_LT(distance_error(found.rig, expected, 0, i), 0.01);
    }
  }
}

TEST(BoardCalibration, SaysHowFarABoardThatHardlyMovedLeavesDirectionsOpen) {
  const BoardCalibration well = calibrate_rig(recorded(truth(), false), {});
  const BoardCalibration poorly = calibrate_rig(recorded(truth(), false, 0.2), {});
  for (const Camera& camera : truth()) {
    const double good = well.cameras.at(camera.name).direction_deviation;
    const double open = poorly.cameras.at(camera.name).direction_deviation;
    EXPECT_GT(good, 0.0);
    EXPECT_LT(good, 0.5 / 57.3);
    EXPECT_GT(open, 1.3 * good);
    const auto found = std::find_if(poorly.rig.begin(), poorly.rig.end(),
                                    [&](const Camera& c) { return c.name == camera.name; });
    const double off = std::hypot(found->cx - camera.cx, found->cy - camera.cy) / camera.fx;
    EXPECT_LT(off, 3.0 * open);
  }
  BoardRecording recording = recorded(truth(), false);
  recording.cameras = truth();
  BoardCalibrationOptions options;
  options.known_intrinsics = true;
  EXPECT_EQ(calibrate_rig(recording, options).cameras.at("cam_0").direction_deviation, 0.0);
}

TEST(BoardCalibration, NamesTheViewThatContradictsTheOthers) {
  const BoardCalibration found = calibrate_rig(recorded(truth(), true), {});
  ASSERT_EQ(found.outliers.size(), 1u);
  EXPECT_EQ(found.outliers[0].camera, "cam_1");
  EXPECT_EQ(found.outliers[0].frame, "frame_3");
  EXPECT_LT(found.rms, 0.2);
}

TEST(BoardCalibration, DoesNotDependOnTheOrderOfTheCameras) {
  const BoardRecording recording = recorded(truth(), false);
  BoardRecording turned = recording;
  std::reverse(turned.cameras.begin(), turned.cameras.end());
  for (auto& frame : turned.views) std::reverse(frame.begin(), frame.end());
  const BoardCalibration a = calibrate_rig(recording, {}), b = calibrate_rig(turned, {});
  for (std::size_t i = 0; i < 3; ++i) {
    const Camera &first = a.rig[i], &second = b.rig[2 - i];
    EXPECT_EQ(first.name, second.name);
    EXPECT_NEAR(first.fx, second.fx, 1e-5 * first.fx);
    EXPECT_LT((first.camera_from_world.translation - second.camera_from_world.translation).norm(),
              1e-5);
  }
}

TEST(BoardCalibration, NamesCamerasThatNothingLinks) {
  BoardRecording recording = recorded(truth(), false);
  for (std::size_t f = 0; f < kFrames; ++f) {
    if (f % 2 == 0) recording.views[f][1] = {};  // camera 2 is alone in these
  }
  try {
    calibrate_rig(recording, {});
    FAIL() << "expected an Error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'cam_2'"), std::string::npos) << error.what();
  }
}

TEST(Board, BoardsThatLookTheSameUpsideDownAreRefused) {
  Board chessboard{BoardKind::chessboard, 9, 7, 0.02, 0.0, "", false};
  EXPECT_THROW(check_board(chessboard), Error);
  chessboard.rows = 6;
  EXPECT_NO_THROW(check_board(chessboard));
  EXPECT_THROW(check_board({BoardKind::circles, 4, 10, 0.02, 0.0, "", true}), Error);
  EXPECT_NO_THROW(check_board({BoardKind::circles, 4, 11, 0.02, 0.0, "", true}));
}

}  // namespace
}  // namespace tegata
