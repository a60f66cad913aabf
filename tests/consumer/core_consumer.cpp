// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Carves a ball out of three silhouettes and bends the built-in hand, with the core library alone.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "tegata/hand/built_in_hand.h"
#include "tegata/hull/visual_hull.h"
#include "tegata/math/so3.h"

namespace {

constexpr double kRadius = 0.05, kDistance = 1.0;

tegata::HullView look_at_ball(const Eigen::Vector3d& axis_angle) {
  tegata::HullView view;
  view.camera = {.name = "camera",
                 .width = 640,
                 .height = 480,
                 .fx = 2000.0,
                 .fy = 2000.0,
                 .cx = 319.5,
                 .cy = 239.5};
  view.camera.camera_from_world.rotation = tegata::so3_exp(axis_angle);
  view.camera.camera_from_world.translation = {0.0, 0.0, kDistance};
  view.silhouette = tegata::Silhouette(640, 480, tegata::PixelLabel::background);
  const double outline = 2000.0 * kRadius / std::sqrt(kDistance * kDistance - kRadius * kRadius);
  for (int y = 0; y < 480; ++y) {
    for (int x = 0; x < 640; ++x) {
      if (std::hypot(x - 319.5, y - 239.5) < outline) {
        view.silhouette(x, y) = tegata::PixelLabel::hand;
      }
    }
  }
  return view;
}

}  // namespace

int main() {
  constexpr double kQuarter = std::numbers::pi / 2.0;
  const std::vector<tegata::HullView> views = {look_at_ball({0.0, 0.0, 0.0}),
                                               look_at_ball({kQuarter, 0.0, 0.0}),
                                               look_at_ball({0.0, kQuarter, 0.0})};
  const tegata::TriangleMesh hull = tegata::visual_hull(views, tegata::HullOptions{});
  const double volume = tegata::enclosed_volume(hull);
  // Three cylinders of the ball's radius at right angles have 8 (2 - sqrt 2) r^3 in common; cones
  // from 1 m come close to that.
  const double expected = 8.0 * (2.0 - std::numbers::sqrt2) * std::pow(kRadius, 3);
  std::printf("visual hull: %.0f cm^3, expected about %.0f\n", 1e6 * volume, 1e6 * expected);

  const tegata::HandModel hand = tegata::built_in_hand({}, tegata::Side::right);
  const tegata::PosedHand posed(hand, {{}, tegata::relaxed_angles()});
  std::printf("index finger tip at y = %.3f m\n", posed.keypoints()[8].y());
  return std::abs(volume / expected - 1.0) < 0.05 && posed.keypoints()[8].y() > 0.1 ? 0 : 1;
}
