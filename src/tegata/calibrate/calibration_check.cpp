// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/calibrate/calibration_check.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <optional>

#include "tegata/base/angle.h"
#include "tegata/base/text.h"
#include "tegata/calibrate/calibration_suspicion.h"

namespace tegata {
namespace {

using Severity = CalibrationProblem::Severity;

std::string rounded(double value, int digits) {
  std::ostringstream stream;
  stream << std::fixed << std::setprecision(digits) << value;
  return stream.str();
}

// A length as a person says it.
std::string length_text(double metres) {
  if (metres >= 1000.0) return rounded(1e-3 * metres, 1) + " km";
  if (metres >= 1.0) return rounded(metres, 1) + " m";
  return metres >= 0.01 ? rounded(100.0 * metres, 1) + " cm" : rounded(1e3 * metres, 2) + " mm";
}

std::optional<CalibrationProblem> check_lens(const Camera& camera) {
  const double half = std::max(camera.width / camera.fx, camera.height / camera.fy) / 2.0;
  const double view = 2.0 * std::atan(half) / kDegree;
  if (camera.lens_model == LensModel::perspective && (view < 1.0 || view > 150.0)) {
    return CalibrationProblem{
        Severity::doubt,
        {camera.name},
        text("camera '", camera.name, "': a field of view of ", rounded(view, 1),
             " degrees: the focal length ", camera.fx, " px does not suit a picture of ",
             camera.width, " x ", camera.height)};
  }
  const double off =
      std::max(std::abs(camera.cx / camera.width - 0.5), std::abs(camera.cy / camera.height - 0.5));
  if (off <= 0.3) return std::nullopt;
  return CalibrationProblem{
      Severity::doubt,
      {camera.name},
      text("camera '", camera.name, "': the optical axis meets the picture at (", camera.cx, ", ",
           camera.cy, "), far from its middle: is the calibration that of ", camera.width, " x ",
           camera.height, " pictures?")};
}

void check_distances(const CameraRig& rig, std::vector<CalibrationProblem>& problems) {
  constexpr double kFarthest = 100.0, kFar = 15.0;  // a hand cannot be made out, hardly [m]
  constexpr double kNearest = 1e-3, kNear = 0.01;
  double largest = 0.0;
  for (std::size_t a = 0; a < rig.size(); ++a) {
    for (std::size_t b = a + 1; b < rig.size(); ++b) {
      const double distance = (rig[a].center_in_world() - rig[b].center_in_world()).norm();
      largest = std::max(largest, distance);
      if (rig.size() > 2 && distance < kNearest) {
        problems.push_back(
            {Severity::doubt,
             {rig[a].name, rig[b].name},
             text("cameras '", rig[a].name, "' and '", rig[b].name, "' stand in the same place")});
      }
    }
  }
  if (largest <= kFar && largest >= kNear) return;
  const bool hard = largest > kFarthest || largest < kNearest;
  problems.push_back(
      {hard ? Severity::error : Severity::doubt,
       {},
       text("the cameras stand up to ", length_text(largest),
            " apart: translations are expected in metres; metres_per_unit in take.toml says what "
            "they are in",
            largest > 100.0 ? " (0.001 for millimetres)" : "")});
}

// How large what the silhouettes show is, by the middle rays' nearest point.
double object_size(const CameraRig& rig, const RigOutlines& frames) {
  std::vector<double> sizes;
  for (const auto& frame : frames) {
    const std::optional<Eigen::Vector3d> center = meeting_point(rig, frame);
    if (!center) continue;
    for (std::size_t c = 0; c < rig.size(); ++c) {
      if (!frame[c]) continue;
      double least = 1.0;  // cosine of the widest angle between two corners
      for (const Eigen::Vector3d& a : frame[c]->rays) {
        for (const Eigen::Vector3d& b : frame[c]->rays) least = std::min(least, a.dot(b));
      }
      sizes.push_back((*center - rig[c].center_in_world()).norm() *
                      std::acos(std::clamp(least, -1.0, 1.0)));
    }
  }
  if (sizes.empty()) return 0.0;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

void check_object_size(double size, std::vector<CalibrationProblem>& problems) {
  constexpr double kSmallest = 0.04, kLargest = 1.0;    // fist, hand and arm [m]
  constexpr double kImpossibly = 5.0, kTypical = 0.25;  // factor beyond these; hand and wrist [m]
  if (size == 0.0 || (size >= kSmallest && size <= kLargest)) return;
  const bool hard = size > kImpossibly * kLargest || size < kSmallest / kImpossibly;
  problems.push_back({hard ? Severity::error : Severity::doubt,
                      {},
                      text("by this calibration the hand is about ", length_text(size),
                           " large: are the translations in metres? metres_per_unit in take.toml "
                           "times ",
                           rounded(kTypical / size, 4), " would make it the size of a hand")});
}

}  // namespace

std::vector<CalibrationProblem> check_numbers(const CameraRig& rig) {
  std::vector<CalibrationProblem> problems;
  for (const Camera& camera : rig) {
    if (auto problem = check_lens(camera)) problems.push_back(std::move(*problem));
  }
  check_distances(rig, problems);
  return problems;
}

CalibrationCheck check_calibration(const CameraRig& rig, const RigOutlines& frames) {
  CalibrationCheck check;
  check.problems = check_numbers(rig);
  check.pairs = pair_tangencies(rig, frames);
  if (const std::optional<Suspicion> suspicion = suspect(rig, frames)) {
    check.problems.push_back({Severity::doubt, suspicion->cameras, suspicion->message});
  } else {
    check.object_size = object_size(rig, frames);
    check_object_size(check.object_size, check.problems);
  }
  return check;
}

}  // namespace tegata
