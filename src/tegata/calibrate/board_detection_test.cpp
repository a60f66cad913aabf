// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/calibrate/board_detection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/aruco/charuco.hpp>

#include "tegata/base/error.h"
#include "tegata/calibrate/rendered_board_for_tests.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

const Board kChessboard = {BoardKind::chessboard, 7, 6, 0.03, 0.0, "", false};
const Board kCircles = {BoardKind::circles, 4, 11, 0.02, 0.0, "", false};
const Board kCharuco = {BoardKind::charuco, 6, 5, 0.04, 0.03, "DICT_4X4_50", false};

Camera camera(int width) {
  Camera made;
  made.name = "c";
  made.width = width;
  made.height = 3 * width / 4;
  made.fx = made.fy = 1.1 * width;
  made.cx = 0.5 * width;
  made.cy = 0.375 * width;
  return made;
}

// The middle of the board before the camera, tilted, as near as it fits into the picture.
Rigid3d pose_of(const Board& board, const Eigen::Vector3d& turn) {
  const auto points = board_points(board);
  const Eigen::Vector3d middle = 0.5 * (points.front() + points.back());
  const Rigid3d turned = {so3_exp(turn), {0.0, 0.0, 0.0}};
  return {turned.rotation, Eigen::Vector3d(0.0, 0.0, 0.55) - turned * middle};
}

BoardPaint charuco_paint(const Board& board) {
  constexpr int kScale = 60;  // pixels of the drawing a square
  const auto printed = cv::aruco::CharucoBoard::create(
      board.columns, board.rows, static_cast<float>(board.spacing),
      static_cast<float>(board.marker), cv::aruco::getPredefinedDictionary(0));
  cv::Mat drawing;
  printed->draw({board.columns * kScale, board.rows * kScale}, drawing);
  // Points are counted from the first inner corner. Squares are painted to the point, of the
  // drawing only the markers are taken.
  return [drawing, board](double x, double y) {
    const double column = x / board.spacing + 1.0, row = y / board.spacing + 1.0;
    double white = 1.0;
    if (column >= 0.0 && row >= 0.0 && column < board.columns && row < board.rows) {
      const int square = static_cast<int>(column) + static_cast<int>(row);
      white = square % 2 == 0 ? 0.0
                              : drawing.at<std::uint8_t>(static_cast<int>(row * kScale),
                                                         static_cast<int>(column * kScale)) /
                                    255.0;
    }
    return board.inverted ? 1.0 - white : white;
  };
}

// The distance of the detected points from where they are projected, rms [px].
double rms_error(const Board& board, const Camera& seen_by, const Rigid3d& pose,
                 const BoardView& view) {
  const auto points = board_points(board);
  double sum = 0.0;
  for (std::size_t i = 0; i < view.points.size(); ++i) {
    const auto& point = points.at(static_cast<std::size_t>(view.points[i]));
    const Eigen::Vector2d expected = project_camera_point(seen_by, pose * point).value();
    sum += (view.pixels[i] - expected).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(view.points.size()));
}

// Tilts, and the board upside down.
const std::vector<Eigen::Vector3d> kTurns = {{0.4, -0.3, 0.2}, {0.2, 0.2, 3.0}};

void expect_found(const Board& board, const BoardPaint& paint, const Camera& seen_by,
                  const BoardPicture& look, double tolerance) {
  const BoardDetector detector(board);
  for (const Eigen::Vector3d& turn : kTurns) {
    const Rigid3d pose = pose_of(board, turn);
    const BoardView view = detector.detect(render_board(paint, seen_by, pose, look));
    EXPECT_EQ(view.points.size(), board_points(board).size()) << turn.transpose();
    EXPECT_LT(rms_error(board, seen_by, pose, view), tolerance) << turn.transpose();
  }
}

TEST(BoardDetection, ChessboardsAreFoundTheRightWayRound) {
  expect_found(kChessboard, chessboard_paint(kChessboard), camera(480), {}, 0.2);
}

TEST(BoardDetection, CharucoBoardsAreFound) {
  expect_found(kCharuco, charuco_paint(kCharuco), camera(640), {}, 0.2);
}

TEST(BoardDetection, CharucoBoardsInInvertedPrintAreFound) {
  Board inverted = kCharuco;
  inverted.inverted = true;
  expect_found(inverted, charuco_paint(inverted), camera(640), {}, 0.2);
}

TEST(BoardDetection, APartOfACharucoBoardWillDo) {
  const Camera seen_by = camera(640);
  Rigid3d pose = pose_of(kCharuco, {0.0, 0.2, 0.1});
  pose.translation.x() += 0.2;
  const BoardView view =
      BoardDetector(kCharuco).detect(render_board(charuco_paint(kCharuco), seen_by, pose));
  EXPECT_GE(view.points.size(), 6u);
  EXPECT_LT(view.points.size(), board_points(kCharuco).size());
  EXPECT_LT(rms_error(kCharuco, seen_by, pose, view), 0.2);
}

TEST(BoardDetection, CirclesAreFound) {
  expect_found(kCircles, circles_paint(kCircles), camera(320), {}, 0.2);
}

// Holes in a cold plate before something warm, as raw counts of a microbolometer.
TEST(BoardDetection, WarmCirclesAreFoundInSmallThermalPictures) {
  Board warm = kCircles;
  warm.inverted = true;
  for (const int width : {320, 200}) {
    expect_found(warm, circles_paint(warm), camera(width), {29500, 30400, 16, 12.0}, 0.2);
  }
}

TEST(BoardDetection, NothingIsFoundWhereThereIsNoBoardOrItsContrastIsTheOther) {
  const Camera seen_by = camera(320);
  const auto nothing = [](double, double) { return 0.5; };
  const Rigid3d pose = pose_of(kCircles, {0.0, 0.0, 0.0});
  for (const Board& board : {kChessboard, kCircles, kCharuco}) {
    EXPECT_TRUE(BoardDetector(board).detect(render_board(nothing, seen_by, pose)).points.empty());
  }
  Board warm = kCircles;
  warm.inverted = true;
  const CameraImage dark_circles = render_board(circles_paint(kCircles), seen_by, pose);
  EXPECT_TRUE(BoardDetector(warm).detect(dark_circles).points.empty());
}

TEST(BoardDetection, DictionariesThatOpenCvDoesNotHaveAreErrors) {
  Board board = kCharuco;
  board.dictionary = "DICT_9X9";
  EXPECT_THROW(BoardDetector{board}, Error);
}

}  // namespace
}  // namespace tegata
