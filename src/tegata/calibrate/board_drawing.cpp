// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/calibrate/board_drawing.h"

#include <cmath>
#include <sstream>

#include "tegata/calibrate/charuco_board.h"

namespace tegata {
namespace {

// OpenCV draws the board in pixels: its squares end at whole ones, its markers nearly.
void draw_charuco(const Board& board, BoardDrawing& drawing) {
  constexpr int kPixels = 200;  // of a square's side
  cv::Mat picture;
  charuco_board(board)->draw({board.columns * kPixels, board.rows * kPixels}, picture);
  const double pixel = board.spacing / kPixels;
  const auto same_rows = [&](int a, int b) {
    for (int x = 0; x < picture.cols; ++x) {
      if (picture.at<std::uint8_t>(a, x) != picture.at<std::uint8_t>(b, x)) return false;
    }
    return true;
  };
  for (int y = 0; y < picture.rows;) {
    int below = y + 1;
    while (below < picture.rows && same_rows(y, below)) ++below;
    for (int x = 0; x < picture.cols;) {
      int end = x;
      while (end < picture.cols && picture.at<std::uint8_t>(y, end) < 128) ++end;
      if (end > x) {
        drawing.rectangles.push_back(
            {Eigen::Vector2d::Constant(board.spacing) + pixel * Eigen::Vector2d(x, y),
             pixel * Eigen::Vector2d(end - x, below - y)});
      }
      x = end + 1;
    }
    y = below;
  }
}

void draw_chessboard(const Board& board, BoardDrawing& drawing) {
  for (int y = 0; y <= board.rows; ++y) {
    for (int x = y % 2; x <= board.columns; x += 2) {
      drawing.rectangles.push_back({board.spacing * Eigen::Vector2d(x + 1, y + 1),
                                    Eigen::Vector2d::Constant(board.spacing)});
    }
  }
}

void draw_circles(const Board& board, BoardDrawing& drawing) {
  constexpr double kRadius = 0.3;  // of the spacing
  for (const Eigen::Vector3d& point : board_points(board)) {
    drawing.circles.push_back(
        {point.head<2>() + Eigen::Vector2d::Constant(board.spacing), kRadius * board.spacing});
  }
}

}  // namespace

BoardDrawing draw_board(const Board& board) {
  check_board(board);
  BoardDrawing drawing;
  drawing.inverted = board.inverted;
  Eigen::Vector2d squares(board.columns, board.rows);
  if (board.kind == BoardKind::chessboard) squares.array() += 1.0;
  if (board.kind == BoardKind::circles) squares = {2.0 * board.columns - 1.0, board.rows - 1.0};
  drawing.sheet = board.spacing * (squares.array() + 2.0).matrix();
  switch (board.kind) {
    case BoardKind::charuco:
      draw_charuco(board, drawing);
      break;
    case BoardKind::chessboard:
      draw_chessboard(board, drawing);
      break;
    case BoardKind::circles:
      draw_circles(board, drawing);
      break;
  }
  return drawing;
}

std::string svg_of(const BoardDrawing& drawing) {
  constexpr double kMillimetres = 1000.0;
  const Eigen::Vector2d sheet = kMillimetres * drawing.sheet;
  std::ostringstream svg;
  svg.imbue(std::locale::classic());
  svg.precision(9);
  svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << sheet.x() << "mm\" height=\""
      << sheet.y() << "mm\" viewBox=\"0 0 " << sheet.x() << " " << sheet.y() << "\">\n"
      << "<rect width=\"100%\" height=\"100%\" fill=\"" << (drawing.inverted ? "black" : "white")
      << "\"/>\n<g fill=\"" << (drawing.inverted ? "white" : "black")
      << "\" shape-rendering=\"crispEdges\">\n";
  for (const BoardDrawing::Rectangle& one : drawing.rectangles) {
    const Eigen::Vector2d corner = kMillimetres * one.corner, size = kMillimetres * one.size;
    svg << "<rect x=\"" << corner.x() << "\" y=\"" << corner.y() << "\" width=\"" << size.x()
        << "\" height=\"" << size.y() << "\"/>\n";
  }
  for (const BoardDrawing::Circle& one : drawing.circles) {
    const Eigen::Vector2d center = kMillimetres * one.center;
    svg << "<circle cx=\"" << center.x() << "\" cy=\"" << center.y() << "\" r=\""
        << kMillimetres * one.radius << "\"/>\n";
  }
  svg << "</g>\n</svg>\n";
  return svg.str();
}

}  // namespace tegata
