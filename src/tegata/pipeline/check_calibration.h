// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>

#include "tegata/base/observer.h"
#include "tegata/calibrate/calibration_check.h"
#include "tegata/pipeline/prepare_take.h"
#include "tegata/take/take.h"

namespace tegata {

struct CheckTakeOptions {
  FrameSelection frames;
  std::size_t most_frames = 24;  ///< spread evenly over the selected ones
  std::optional<SegmentationMethod> segmentation;
  int threads = 0;
};

struct TakeCheck {
  CalibrationCheck calibration;
  std::size_t frame_count = 0;  ///< in which two or more cameras saw the hand
  /// How much of each camera's silhouettes the visual hull of all covers, mean over the frames: 1
  /// where the cameras agree; by camera.
  std::map<std::string, double> hull_coverage;
};

/// Checks the calibration of a take against its own numbers and its silhouettes.
TakeCheck check_take(Take& take, const CheckTakeOptions& options, const Observer& observer);

/// Throws Error where nothing can come of the calibration's numbers.
void refuse_bad_numbers(const Take& take);

/// prepare_take() between checks: numbers that nothing can come of are an Error before, doubts are
/// said to the observer, and where no frame can be fitted the Error says what the silhouettes say
/// of the calibration.
PreparedTake prepare_checked_take(Take& take, const PrepareOptions& options,
                                  const Observer& observer);

}  // namespace tegata
