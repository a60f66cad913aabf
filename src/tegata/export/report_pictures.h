// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tegata/base/observer.h"
#include "tegata/export/outline_trace.h"
#include "tegata/hand/hand_model.h"
#include "tegata/image/silhouette.h"
#include "tegata/take/result.h"
#include "tegata/take/take.h"

namespace tegata {

/// A part of a camera's picture [px].
struct PictureWindow {
  int left = 0, top = 0, width = 0, height = 0;
};

/// What a camera saw of a frame, and what lies over it.
struct ReportPicture {
  std::size_t frame = 0, camera = 0;      ///< positions in Result::frames and in the take's rig
  std::vector<std::uint8_t> jpeg;         ///< the camera's window, perhaps downsized
  std::vector<Outline> hand, silhouette;  ///< in pixels of the camera's whole picture
};

struct ReportPictures {
  std::vector<PictureWindow> windows;   ///< one a camera
  std::vector<ReportPicture> pictures;  ///< by frame, then by camera
  std::vector<std::string> limits;      ///< what was left out or made smaller, for people to read
};

/// The silhouettes of a frame, one per camera of the rig; nothing where a camera has no picture.
using SegmentFrame =
    std::function<std::vector<std::optional<Silhouette>>(const TakeFrame& pictures)>;

struct ReportPictureOptions {
  std::size_t most_frames = 300;        ///< beyond, the most doubtful ones and others evenly
  std::size_t most_bytes = 11'000'000;  ///< of the page, for all pictures and outlines
  std::size_t usual_bytes = 24'000;     ///< of one JPEG, where there are few
  int threads = 0;
};

/// The pictures of a result's frames: of each camera what surrounds the hand over all frames, in
/// one size. A camera that disagrees with the fit in some frame is shown whole. What does not fit
/// is made smaller first, then left out, the frames to doubt last. Throws Error where the take
/// lacks a frame of the result.
ReportPictures make_report_pictures(Take& take, const Result& result, const HandModel& hand,
                                    const SegmentFrame& segment,
                                    const ReportPictureOptions& options, const Observer& observer);

}  // namespace tegata
