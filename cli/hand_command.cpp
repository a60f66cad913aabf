// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "hand_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "tegata/base/angle.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/hand/scaled_hand.h"

namespace tegata {
namespace {

HandShape shape_of(const HandSource& source) {
  HandShape shape;
  if (source.percentile) {
    shape =
        HandShape::percentile(*source.percentile, source.sex == "male" ? Sex::male : Sex::female);
  }
  if (source.length_mm) shape.length = 1e-3 * *source.length_mm;
  if (source.palm_breadth_mm) shape.palm_breadth = 1e-3 * *source.palm_breadth_mm;
  if (source.palm_thickness_mm) shape.palm_thickness = 1e-3 * *source.palm_thickness_mm;
  if (source.finger_thickness) shape.finger_thickness = *source.finger_thickness;
  return shape;
}

/// NAME=DEGREES.
std::pair<int, double> parse_angle(const std::string& value) {
  const std::size_t equals = value.find('=');
  const std::string name = value.substr(0, equals);
  const auto found = std::find(angle_names().begin(), angle_names().end(), name);
  if (equals == std::string::npos || found == angle_names().end()) {
    throw CLI::ValidationError("--angle", "got '" + value +
                                              "', expected NAME=DEGREES with a name that `tegata "
                                              "hand info` lists, as index_pip_flexion=60");
  }
  double degrees = 0.0;
  const char* end = value.data() + value.size();
  const auto [last, problem] = std::from_chars(value.data() + equals + 1, end, degrees);
  if (problem != std::errc() || last != end || !(std::abs(degrees) <= 180.0)) {
    throw CLI::ValidationError("--angle", "got '" + value + "', expected -180 to 180 degrees");
  }
  return {static_cast<int>(found - angle_names().begin()), degrees * kDegree};
}

Result read_result(const AngleSource& source) {
  return read_result_json(std::filesystem::path(source.result) / "result.json");
}

HandPose pose_of_result(const AngleSource& source, const HandModel& hand) {
  const Result result = read_result(source);
  if (result.side != hand.skeleton.side) {
    throw Error(source.result, ": it is of a ", side_name(result.side), " hand, got a ",
                side_name(hand.skeleton.side), " one; give --side ", side_name(result.side));
  }
  HandPose pose;
  pose.angles = result.grasp_angles;
  if (source.frame.empty()) return pose;
  for (const ResultFrame& frame : result.frames) {
    if (frame.name != source.frame) continue;
    if (!frame.pose) throw Error(source.result, ": frame ", frame.name, ": ", frame.status);
    return *frame.pose;
  }
  throw Error(source.result, ": there is no frame '", source.frame, "' among its ",
              result.frames.size());
}

}  // namespace

void add_hand_source(CLI::App& command, HandSource& source) {
  command.add_option(
      "HAND", source.file,
      "A hand from a file (GLB, glTF, TOML); else the built-in one of the mean adult");
  command.add_option("--side", source.side, "Which hand; else the file's own, or the right one")
      ->check(CLI::IsMember({"right", "left"}));
  const std::string group = "The built-in hand's size";
  command
      .add_option("--percentile", source.percentile,
                  "All sizes at one percentile of adults (1 to 99)")
      ->check(CLI::Range(1.0, 99.0))
      ->group(group);
  command.add_option("--sex", source.sex, "Whose percentile")
      ->check(CLI::IsMember({"female", "male"}))
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--length-mm", source.length_mm, "Wrist crease to the tip of the middle finger")
      ->group(group);
  command.add_option("--palm-breadth-mm", source.palm_breadth_mm, "At the knuckles")->group(group);
  command.add_option("--palm-thickness-mm", source.palm_thickness_mm, "At the knuckles")
      ->group(group);
  command.add_option("--finger-thickness", source.finger_thickness, "Factor on the digits' radii")
      ->group(group);
}

HandModel load_hand(const HandSource& source) {
  const std::optional<Side> side =
      source.side.empty() ? std::nullopt : std::optional(side_from_name(source.side));
  if (source.file.empty()) return built_in_hand(shape_of(source), side.value_or(Side::right));
  if (source.percentile || source.length_mm || source.palm_breadth_mm || source.palm_thickness_mm ||
      source.finger_thickness) {
    throw Error(source.file, ": got a size as well, which only the built-in hand can be given");
  }
  return load_hand(source.file, side);
}

void add_angle_source(CLI::App& command, AngleSource& source) {
  command
      .add_option("--from", source.from,
                  "Angles that are not given: all zero, as the file has the hand, or relaxed")
      ->check(CLI::IsMember({"flat", "rest", "relaxed"}))
      ->capture_default_str();
  CLI::Option* result =
      command.add_option("--result", source.result, "The grasp of a folder that fit made");
  command.add_option("--frame", source.frame, "A frame of that folder, and where it has the hand")
      ->needs(result);
  command
      .add_option_function<std::vector<std::string>>(
          "--angle",
          [&source](const std::vector<std::string>& values) {
            for (const std::string& value : values) source.angles.push_back(parse_angle(value));
          },
          "NAME=DEGREES, as index_pip_flexion=60; any number of times")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

HandModel load_hand(const HandSource& source, const AngleSource& angles) {
  if (angles.result.empty()) return load_hand(source);
  const Result result = read_result(angles);
  HandSource known = source;
  if (source.file.empty() && source.side.empty()) known.side = side_name(result.side);
  return scaled(load_hand(known), result.model_scale);
}

HandPose pose_of(const AngleSource& source, const HandModel& hand) {
  HandPose pose;
  if (!source.result.empty()) {
    pose = pose_of_result(source, hand);
  } else if (source.from == "rest") {
    pose.angles = hand.rest_angles;
  } else if (source.from == "relaxed") {
    pose.angles = relaxed_angles();
  }
  for (const auto& [angle, value] : source.angles) pose.angles[angle] = value;
  return pose;
}

void warn_of_limits(const JointAngles& angles) {
  constexpr double kTolerance = 0.1 * kDegree;
  const AngleLimits& limits = angle_limits();
  for (int angle = 0; angle < kAngleCount; ++angle) {
    if (angles[angle] >= limits.lower[angle] - kTolerance &&
        angles[angle] <= limits.upper[angle] + kTolerance) {
      continue;
    }
    std::cerr << fmt::format("warning: {} is {:.1f} deg, beyond its limits of {:.0f} to {:.0f}\n",
                             angle_names()[static_cast<std::size_t>(angle)],
                             angles[angle] / kDegree, limits.lower[angle] / kDegree,
                             limits.upper[angle] / kDegree);
  }
}

}  // namespace tegata
