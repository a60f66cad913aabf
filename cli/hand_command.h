// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// What the subcommands of `tegata hand` share.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "command.h"
#include "tegata/hand/hand_shape.h"

namespace tegata {

void add_hand_info_command(CLI::App& hand);
void add_hand_convert_command(CLI::App& hand);
void add_hand_pose_command(CLI::App& hand);
void add_hand_picture_command(CLI::App& hand);
void add_hand_personalise_command(CLI::App& hand);

/// Which hand a subcommand is about: a file, or the built-in hand in some size.
struct HandSource {
  std::string file, side;
  std::optional<double> percentile, length_mm, palm_breadth_mm, palm_thickness_mm, finger_thickness;
  std::string sex = "female";
};
void add_hand_source(CLI::App& command, HandSource& source);
/// Throws Error where a file comes with sizes.
HandModel load_hand(const HandSource& source);

/// How a hand is bent: angles that --angle names over those of --from or of a result.
struct AngleSource {
  std::string from = "flat", result, frame;
  std::vector<std::pair<int, double>> angles;  ///< which angle, value [rad]
};
void add_angle_source(CLI::App& command, AngleSource& source);
/// The hand to bend: where nothing says which side, that of the result, and at its scale.
HandModel load_hand(const HandSource& source, const AngleSource& angles);
/// The pose of a hand; without a frame of a result it is in the hand's own frame. Throws Error
/// where the result is one of the other hand or has no such frame.
HandPose pose_of(const AngleSource& source, const HandModel& hand);
/// One line for each angle beyond its limits, on stderr.
void warn_of_limits(const JointAngles& angles);

}  // namespace tegata
