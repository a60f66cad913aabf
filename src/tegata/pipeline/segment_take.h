// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tegata/base/observer.h"
#include "tegata/image/image.h"
#include "tegata/pipeline/frame_selection.h"
#include "tegata/take/take.h"

namespace tegata {

struct SegmentTakeOptions {
  FrameSelection frames;
  std::optional<SegmentationMethod> segmentation;  ///< absent: what the take says, or chosen
  int threads = 0;
  std::size_t sheet_rows = 6;  ///< frames on the contact sheet, spread evenly
  int sheet_widest = 320;      ///< width of a picture on it [px]
};

/// How sure a silhouette is.
struct SegmentedView {
  std::string camera;
  std::size_t hand_pixels = 0;
  double confidence = 0.0;  ///< as of SegmentationReport
};

struct SegmentedFrame {
  std::string name;
  std::vector<SegmentedView> views;  ///< of the cameras that have a picture, in the rig's order
  std::map<std::string, std::string> left_out;  ///< why, by camera of the others
};

struct SegmentedTake {
  SegmentationMethod method = SegmentationMethod::mask;
  std::vector<SegmentedFrame> frames;
  /// A row a frame, a column a camera: what was cut out bright and outlined, the rest dimmed.
  CameraImage contact_sheet;
};

/// Segments a take and writes it into an existing folder as a take of masks: calibration.toml in
/// metres, take.toml and masks/<camera>/<frame>.png. Landmarks of the first frame are kept where
/// that frame is. Throws Error where a file cannot be written.
SegmentedTake segment_take(Take& take, const std::filesystem::path& folder,
                           const SegmentTakeOptions& options, const Observer& observer);

}  // namespace tegata
