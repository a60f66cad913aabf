// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "tegata/calibrate/board.h"

namespace tegata {

/// What of a board differs from its sheet: black, or white where the board is inverted. Lengths in
/// metres, y down, from the sheet's corner.
struct BoardDrawing {
  struct Rectangle {
    Eigen::Vector2d corner, size;
  };
  struct Circle {
    Eigen::Vector2d center;
    double radius = 0.0;
  };
  Eigen::Vector2d sheet;
  bool inverted = false;
  std::vector<Rectangle> rectangles;
  std::vector<Circle> circles;
};

/// A board with a margin of one spacing all around. Circles are 0.6 of the spacing wide. Throws
/// Error as check_board() does.
BoardDrawing draw_board(const Board& board);

/// The drawing in its true size as SVG, to print, cut or drill.
std::string svg_of(const BoardDrawing& drawing);

}  // namespace tegata
