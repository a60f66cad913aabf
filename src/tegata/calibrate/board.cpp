// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/calibrate/board.h"

#include <array>
#include <cmath>

#include "tegata/base/error.h"

namespace tegata {
namespace {

constexpr std::array<std::string_view, 3> kNames = {"charuco", "chessboard", "circles"};

}  // namespace

std::string_view board_kind_name(BoardKind kind) {
  return kNames.at(static_cast<std::size_t>(kind));
}

BoardKind board_kind_from_name(std::string_view name) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (name == kNames[i]) return static_cast<BoardKind>(i);
  }
  throw Error("board: got '", name, "', expected charuco, chessboard or circles");
}

void check_board(const Board& board) {
  constexpr int kMost = 200;
  if (board.columns < 2 || board.rows < 2 || board.columns > kMost || board.rows > kMost) {
    throw Error("board: got ", board.columns, " columns and ", board.rows, " rows, expected 2 to ",
                kMost, " of each");
  }
  if (!(board.spacing > 0.0) || !std::isfinite(board.spacing)) {
    throw Error("board: got a spacing of ", board.spacing, " m, expected more than 0");
  }
  if (board.kind == BoardKind::charuco && !(board.marker > 0.0 && board.marker < board.spacing)) {
    throw Error("board: got markers of ", board.marker, " m in squares of ", board.spacing,
                " m, expected smaller ones");
  }
  if (board.kind == BoardKind::chessboard && (board.columns + board.rows) % 2 == 0) {
    throw Error("board: a chessboard of ", board.columns, " x ", board.rows,
                " inner corners looks the same upside down, expected an even number one way and an "
                "odd one the other");
  }
  if (board.kind == BoardKind::circles && board.rows % 2 == 0) {
    throw Error("board: an asymmetric grid of ", board.rows,
                " rows of circles looks the same upside down, expected an odd number of rows");
  }
}

std::vector<Eigen::Vector3d> board_points(const Board& board) {
  const bool charuco = board.kind == BoardKind::charuco;
  const int columns = board.columns - (charuco ? 1 : 0), rows = board.rows - (charuco ? 1 : 0);
  std::vector<Eigen::Vector3d> points;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const int across = board.kind == BoardKind::circles ? 2 * x + y % 2 : x;
      points.emplace_back(board.spacing * across, board.spacing * y, 0.0);
    }
  }
  return points;
}

}  // namespace tegata
