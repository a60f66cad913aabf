// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/sim/hand_motion.h"

#include <cmath>
#include <numbers>

#include "tegata/base/angle.h"
#include "tegata/base/random.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;

// A sine of the time with a period and phase of its own.
struct Swing {
  double amplitude, frames_per_period, phase;
  Swing(double amplitude_, Random& random)
      : amplitude(amplitude_),
        frames_per_period(random.uniform(12.0, 24.0)),
        phase(random.uniform(0.0, kFullTurn)) {}
  double at(int frame) const {
    return amplitude * std::sin(kFullTurn * frame / frames_per_period + phase);
  }
};

// Fingers point up and towards one of the room's corners, turned about the forearm as it comes.
Eigen::Quaterniond first_rotation(Random& random) {
  const double quadrant = static_cast<double>(random.index(4)) * std::numbers::pi / 2.0;
  const double azimuth = quadrant + (45.0 + random.uniform(-12.0, 12.0)) * kDegree;
  const double elevation = (38.0 + random.uniform(-8.0, 8.0)) * kDegree;
  const Eigen::Vector3d fingers(std::cos(elevation) * std::cos(azimuth),
                                std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
  const Eigen::Quaterniond along =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitY(), fingers);
  return along * so3_exp({0.0, random.uniform(0.0, kFullTurn), 0.0});
}

}  // namespace

std::vector<Rigid3d> hand_motion(const Eigen::Vector3d& center_in_hand,
                                 const HandMotionOptions& options) {
  Random random(options.seed);
  Eigen::Quaterniond rotation = first_rotation(random);
  const double way = random.index(2) == 0 ? 1.0 : -1.0;
  const Swing axis_x(0.3, random), axis_z(0.3, random);
  const Swing x(0.011, random), y(0.011, random), z(0.011, random);
  std::vector<Rigid3d> world_from_hand;
  for (int frame = 0; frame < options.frame_count; ++frame) {
    if (frame > 0) {
      const Eigen::Vector3d axis_in_hand(axis_x.at(frame), way, axis_z.at(frame));
      rotation =
          (rotation * so3_exp(options.turn_deg * kDegree * axis_in_hand.normalized())).normalized();
    }
    const Eigen::Vector3d center_in_world(x.at(frame), y.at(frame), z.at(frame));
    world_from_hand.push_back({rotation, center_in_world - rotation * center_in_hand});
  }
  return world_from_hand;
}

}  // namespace tegata
