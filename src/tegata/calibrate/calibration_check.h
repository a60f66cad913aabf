// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tegata/calibrate/outline_rays.h"
#include "tegata/calibrate/tangency.h"
#include "tegata/camera/camera.h"

namespace tegata {

/// Something that is wrong or in doubt with a calibration, in one line.
struct CalibrationProblem {
  enum class Severity {
    doubt,  ///< results will be off
    error,  ///< nothing can come out
  };
  Severity severity = Severity::doubt;
  std::vector<std::string> cameras;  ///< that are to blame; empty: all of them or the units
  std::string message;
};

struct CalibrationCheck {
  std::vector<CalibrationProblem> problems;
  std::vector<PairTangency> pairs;  ///< of the silhouettes, where there are any
  double object_size = 0.0;         ///< how large the silhouettes' object is [m]; 0: not known
  bool agrees() const { return problems.empty(); }
};

/// What the numbers alone say: cameras in one place, further apart or nearer together than a hand's
/// recording has them, principal points outside the picture, fields of view that no lens has.
std::vector<CalibrationProblem> check_numbers(const CameraRig& rig);

/// What the silhouettes say as well: tangent planes that do not agree, rays that part, an object of
/// another size than a hand. Where they contradict the calibration, the likeliest of these is
/// named, if it makes the contradiction go away: pictures of two cameras exchanged, a camera's
/// pictures mirrored or upside down, poses that are inverses, a camera that has been turned since;
/// else the camera without which the others agree. Of two cameras alone, both may be to blame.
CalibrationCheck check_calibration(const CameraRig& rig, const RigOutlines& frames);

}  // namespace tegata
