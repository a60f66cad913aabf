// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/export_result.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tegata/base/angle.h"
#include "tegata/base/error.h"
#include "tegata/export/bvh_export.h"
#include "tegata/export/csv_export.h"
#include "tegata/export/npz_export.h"
#include "tegata/export/opensim_export.h"
#include "tegata/export/urdf_export.h"

namespace tegata {
namespace {

constexpr std::array<std::string_view, 6> kFormatNames = {"urdf", "bvh", "csv",
                                                          "trc",  "mot", "npz"};

/// Where the poses of a BVH are not the frames' own.
std::vector<std::string> notes_of_bvh(const Result& result) {
  std::vector<std::string> notes;
  std::string held;
  std::size_t count = 0;
  for (const ResultFrame& frame : result.frames) {
    if (frame.pose) continue;
    held += (count++ == 0 ? "" : ", ") + frame.name;
  }
  if (count > 0) {
    notes.push_back(text("BVH has no way to leave a frame out: ", count,
                         " without a pose show the one before: ", held));
  }
  const double interval = frame_interval(result);
  double most = 0.0;
  for (std::size_t i = 1; i < result.frames.size(); ++i) {
    const double step = result.frames[i].time - result.frames[i - 1].time;
    most = std::max(most, std::abs(step - interval));
  }
  if (most > 0.1 * interval) {
    notes.push_back(text("BVH knows even times only: frames are given every ", decimal(interval, 4),
                         " s, and some are off that by ", decimal(most, 4), " s"));
  }
  return notes;
}

/// Where a robot that keeps to the limits cannot follow.
std::vector<std::string> notes_of_urdf(const Result& result) {
  constexpr double kTolerance = 1e-3;  // [rad]
  const AngleLimits& limits = angle_limits();
  JointAngles beyond = JointAngles::Zero();
  for (const ResultFrame& frame : result.frames) {
    if (!frame.pose) continue;
    const JointAngles& angles = frame.pose->angles;
    beyond = beyond.cwiseMax(angles - limits.upper).cwiseMax(limits.lower - angles);
  }
  std::vector<std::string> notes;
  for (int angle = 0; angle < kAngleCount; ++angle) {
    if (beyond[angle] <= kTolerance) continue;
    notes.push_back(text(angle_names()[static_cast<std::size_t>(angle)], " is up to ",
                         decimal(beyond[angle] * kDegreesPerRadian, 1),
                         " deg beyond its limits in joint_states.csv"));
  }
  return notes;
}

}  // namespace

std::string_view export_format_name(ExportFormat format) {
  return kFormatNames[static_cast<std::size_t>(format)];
}

ExportFormat export_format_from_name(std::string_view name) {
  for (std::size_t i = 0; i < kFormatNames.size(); ++i) {
    if (name == kFormatNames[i]) return static_cast<ExportFormat>(i);
  }
  throw Error("export: got '", name, "', expected urdf, bvh, csv, trc, mot or npz");
}

Export export_result(const Result& result, const HandModel& hand, ExportFormat format,
                     const ExportOptions& options) {
  check_hand(hand);
  check_fitted_hand(result, hand);
  switch (format) {
    case ExportFormat::urdf:
      return {urdf_files(result, hand, options.density), notes_of_urdf(result)};
    case ExportFormat::bvh:
      return {{{"hand.bvh", bvh_text(result, hand)}}, notes_of_bvh(result)};
    case ExportFormat::csv:
      return {{{"hand.csv", csv_text(result)}}, {}};
    case ExportFormat::trc:
      return {{{"hand.trc", trc_text(result)}}, {}};
    case ExportFormat::mot:
      return {{{"hand.mot", mot_text(result)}}, {}};
    case ExportFormat::npz:
      return {{{"hand.npz", npz_bytes(result, hand)}}, {}};
  }
  throw Error("export: got format ", static_cast<int>(format), ", expected one of the six");
}

}  // namespace tegata
