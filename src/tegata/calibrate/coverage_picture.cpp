// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/calibrate/coverage_picture.h"

#include <algorithm>
#include <cmath>

#include "tegata/calibrate/rig_start.h"
#include "tegata/image/overlay.h"

namespace tegata {
namespace {

constexpr int kWidth = 480;
constexpr Colour kPaper = {255, 255, 255}, kCell = {232, 232, 232}, kFrame = {150, 150, 150};
constexpr Colour kGood = {30, 150, 60}, kFair = {225, 170, 0}, kBad = {210, 40, 40};

void set(CameraImage& picture, int x, int y, const Colour& colour) {
  if (!picture.values.contains(x, y)) return;
  for (int channel = 0; channel < 3; ++channel) {
    picture.values(x, y, channel) = colour[static_cast<std::size_t>(channel)];
  }
}

CameraImage empty_cell(int height) {
  constexpr int kColumns = 8, kRows = 6;
  CameraImage picture{Image<std::uint16_t>(kWidth, height, 0, 3), 8};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool edge = x == 0 || y == 0 || x == kWidth - 1 || y == height - 1;
      const bool dark = (x * kColumns / kWidth + y * kRows / height) % 2 == 0;
      set(picture, x, y, edge ? kFrame : dark ? kCell : kPaper);
    }
  }
  return picture;
}

void dot(CameraImage& picture, const Eigen::Vector2d& at, const Colour& colour) {
  const int x = static_cast<int>(std::lround(at.x())), y = static_cast<int>(std::lround(at.y()));
  for (int v = -1; v <= 1; ++v) {
    for (int u = -1; u <= 1; ++u) set(picture, x + u, y + v, colour);
  }
}

Colour colour_of(double error) {
  constexpr double kGoodError = 0.5, kFairError = 1.5;  // [px]
  return error <= kGoodError ? kGood : error <= kFairError ? kFair : kBad;
}

}  // namespace

CameraImage coverage_picture(const BoardRecording& recording, const BoardCalibration& calibration) {
  const std::vector<Eigen::Vector3d> board = board_points(recording.board);
  std::vector<CameraImage> cells;
  for (std::size_t c = 0; c < calibration.rig.size(); ++c) {
    const Camera& camera = calibration.rig[c];
    const double scale = static_cast<double>(kWidth) / camera.width;
    cells.push_back(empty_cell(std::max(1, static_cast<int>(camera.height * scale))));
    for (std::size_t f = 0; f < recording.views.size(); ++f) {
      if (!calibration.frame_used[f]) continue;
      const BoardView& view = recording.views[f][c];
      const std::vector<Eigen::Vector3d> points = points_of(view, board);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const auto seen = project(camera, calibration.world_from_board[f] * points[i]);
        dot(cells.back(), scale * view.pixels[i],
            seen ? colour_of((*seen - view.pixels[i]).norm()) : kBad);
      }
    }
  }
  const int columns = std::min(3, static_cast<int>(cells.size()));
  return contact_sheet(cells, columns, kPaper);
}

}  // namespace tegata
