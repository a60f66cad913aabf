// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "turning_hand.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "hand_view.h"
#include "tegata/base/error.h"
#include "tegata/take/write_video.h"

namespace tegata {
namespace {

constexpr std::size_t kPictures = 150;  // of a turn
constexpr double kPicturesPerSecond = 30.0;

}  // namespace

std::size_t write_turning_hand(const Result& result, const HandModel& hand, int width,
                               const std::filesystem::path& file, const Observer& observer) {
  std::vector<TriangleMesh> surfaces;
  Ball ball;
  for (const ResultFrame& frame : result.frames) {
    if (!frame.pose) continue;
    surfaces.push_back(PosedHand(hand, {Rigid3d(), frame.pose->angles}).surface());
    const Ball needed = ball_around(surfaces.back());
    if (surfaces.size() == 1) ball.middle = needed.middle;
    ball.radius = std::max(ball.radius, (needed.middle - ball.middle).norm() + needed.radius);
  }
  if (surfaces.empty()) throw Error(file.string(), ": no frame of the result has a pose to draw");
  const auto picture = [&](std::size_t i) {
    observer.progress("video", i + 1, kPictures);
    const double turn =
        2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(kPictures);
    const View view{{std::sin(turn), 0.0, -std::cos(turn)}, Eigen::Vector3d::UnitY()};
    return draw_hand(surfaces[i * surfaces.size() / kPictures], view, ball, width + width % 2);
  };
  write_video(file, kPicturesPerSecond, kPictures, picture);
  return kPictures;
}

}  // namespace tegata
