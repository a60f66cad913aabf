// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// For tests: pictures of boards.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include "tegata/base/random.h"
#include "tegata/calibrate/board.h"
#include "tegata/camera/camera.h"
#include "tegata/image/image.h"
#include "tegata/math/rigid3d.h"

namespace tegata {

/// How bright a board is at a place on it [m]: 1 white, 0 black, and between them what lies around.
using BoardPaint = std::function<double(double x, double y)>;

inline BoardPaint chessboard_paint(const Board& board) {
  return [board](double x, double y) {
    const double column = std::floor(x / board.spacing), row = std::floor(y / board.spacing);
    const bool outside = column < -1 || row < -1 || column >= board.columns || row >= board.rows;
    const bool black = std::fmod(column + row + 2.0, 2.0) == 0.0;
    return outside || !black ? 1.0 : 0.0;
  };
}

/// Dark circles, 0.6 of the distance between rows wide; bright ones where the board is inverted.
inline BoardPaint circles_paint(const Board& board) {
  return [board](double x, double y) {
    const double row = std::round(y / board.spacing), shift = std::fmod(std::abs(row), 2.0);
    const double column = std::round((x / board.spacing - shift) / 2.0);
    const bool exists = row >= 0 && row < board.rows && column >= 0 && column < board.columns;
    const double across = x / board.spacing - shift - 2.0 * column, down = y / board.spacing - row;
    const bool in_circle = exists && std::hypot(across, down) < 0.3;
    return in_circle != board.inverted ? 0.0 : 1.0;
  };
}

/// Grey from `dark` to `bright` of so many bits, with noise. The board's plane fills the picture.
struct BoardPicture {
  int dark = 40, bright = 210, bits = 8;
  double noise = 1.0;
};

inline CameraImage render_board(const BoardPaint& paint, const Camera& camera,
                                const Rigid3d& camera_from_board, const BoardPicture& look = {}) {
  constexpr int kSamples = 3;  // a side of a pixel
  const Rigid3d board_from_camera = camera_from_board.inverse();
  Camera at_origin = camera;
  at_origin.camera_from_world = {};
  Random random(11);
  CameraImage picture{Image<std::uint16_t>(camera.width, camera.height), look.bits};
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      double sum = 0.0;
      for (int i = 0; i < kSamples * kSamples; ++i) {
        const Eigen::Vector2d pixel(x - 0.5 + (i % kSamples + 0.5) / kSamples,
                                    y - 0.5 + (static_cast<int>(i / kSamples) + 0.5) / kSamples);
        const Eigen::Vector3d ray = board_from_camera.rotation * pixel_direction(at_origin, pixel);
        const Eigen::Vector3d& from = board_from_camera.translation;
        const Eigen::Vector3d at = from - from.z() / ray.z() * ray;
        sum += paint(at.x(), at.y());
      }
      const double share = sum / (kSamples * kSamples);
      const double value = look.dark + share * (look.bright - look.dark);
      picture.values(x, y) =
          static_cast<std::uint16_t>(std::max(0.0, value + random.normal(0.0, look.noise) + 0.5));
    }
  }
  return picture;
}

}  // namespace tegata
