// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/calibrate/board_drawing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tegata/calibrate/board_detection.h"
#include "tegata/calibrate/rendered_board_for_tests.h"

namespace tegata {
namespace {

BoardPaint paint_of(const BoardDrawing& drawing) {
  return [drawing](double x, double y) {
    const Eigen::Vector2d place(x, y);
    bool drawn = false;
    for (const auto& one : drawing.rectangles) {
      const Eigen::Array2d within = place - one.corner;
      drawn = drawn || ((within >= 0.0).all() && (within < one.size.array()).all());
    }
    for (const auto& one : drawing.circles) {
      drawn = drawn || (place - one.center).norm() < one.radius;
    }
    return drawn != drawing.inverted ? 0.0 : 1.0;
  };
}

TEST(BoardDrawing, WhatIsDrawnIsFoundWhole) {
  for (const Board& board : {Board{BoardKind::charuco, 4, 3, 0.05, 0.035, "DICT_4X4_50", true},
                             Board{BoardKind::chessboard, 6, 5, 0.03, 0.0, "", false},
                             Board{BoardKind::circles, 4, 7, 0.025, 0.0, "", true}}) {
    const BoardDrawing drawing = draw_board(board);
    Camera camera;
    camera.width = 400;
    camera.height = 300;
    camera.fx = camera.fy = 500.0;
    camera.cx = 199.5;
    camera.cy = 149.5;
    const double depth = 500.0 * std::max(drawing.sheet.x() / 380.0, drawing.sheet.y() / 280.0);
    const Rigid3d camera_from_board = {Eigen::Quaterniond::Identity(),
                                       {-0.5 * drawing.sheet.x(), -0.5 * drawing.sheet.y(), depth}};
    const BoardView view =
        BoardDetector(board).detect(render_board(paint_of(drawing), camera, camera_from_board));
    EXPECT_EQ(view.points.size(), board_points(board).size()) << board_kind_name(board.kind);
  }
}

TEST(BoardDrawing, IsOfItsTrueSize) {
  const std::string svg = svg_of(draw_board({BoardKind::circles, 4, 11, 0.02, 0.0, "", true}));
  EXPECT_NE(svg.find("width=\"180mm\" height=\"240mm\" viewBox=\"0 0 180 240\""), std::string::npos)
      << svg.substr(0, 200);
  EXPECT_NE(svg.find("<circle cx=\"20\" cy=\"20\" r=\"6\"/>"), std::string::npos);
  EXPECT_NE(svg.find("<circle cx=\"40\" cy=\"40\" r=\"6\"/>"), std::string::npos);
}

}  // namespace
}  // namespace tegata
