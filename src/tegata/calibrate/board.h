// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace tegata {

enum class BoardKind {
  charuco,     ///< a chessboard with ArUco markers in its white squares: parts of it will do
  chessboard,  ///< seen whole; columns plus rows of inner corners must be odd
  circles,     ///< asymmetric grid, seen whole; the number of rows must be odd
};
std::string_view board_kind_name(BoardKind kind);
BoardKind board_kind_from_name(std::string_view name);

/// A calibration board.
struct Board {
  BoardKind kind = BoardKind::charuco;
  /// Squares of a ChArUco board, inner corners of a chessboard, circles of an asymmetric grid (as
  /// OpenCV counts them: 4 columns and 11 rows).
  int columns = 0, rows = 0;
  /// The side of a square; of circles, half the distance between neighbours in a row [m].
  double spacing = 0.0;
  double marker = 0.0;                     ///< side of an ArUco marker [m]
  std::string dictionary = "DICT_4X4_50";  ///< of the markers, as OpenCV names it
  /// White where the board is black elsewhere: inverted prints, circles that are warmer than their
  /// board in a thermal picture.
  bool inverted = false;
};

/// Throws Error where there can be no such board, or where it looks the same upside down.
void check_board(const Board& board);

/// The points of a board by index [m], z = 0.
std::vector<Eigen::Vector3d> board_points(const Board& board);

/// What one camera sees of a board in one picture.
struct BoardView {
  std::vector<int> points;  ///< indices
  std::vector<Eigen::Vector2d> pixels;
};

}  // namespace tegata
