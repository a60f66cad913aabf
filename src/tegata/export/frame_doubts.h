// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tegata/take/result.h"

namespace tegata {

/// What speaks against a frame of a result.
struct FrameDoubt {
  std::size_t frame = 0;  ///< position in Result::frames
  double severity = 0.0;  ///< 0 nothing to say, 1 there is no pose
  bool has_pose = false;
  std::vector<std::string> reasons;  ///< the worst first; empty where the frame is to be trusted
};

/// One for each frame, in the frames' order. A frame is not to be trusted where
/// - it has no pose, or its status is not ok;
/// - in a camera the fitted hand covers less than half of what it and the silhouette cover
/// together; less than a quarter where all that is seen of the hand is covered, as something may
/// hide the rest;
/// - in a camera the border of the seen hand lies 1.5 mm outside the fitted one on average, and
/// three times as far as the most in other frames: the pose or a camera is wrong;
/// - in a camera that overlap is far below what it is in the five frames before and after: by 0.15
///   and by four standard deviations, taken from the median absolute deviation;
/// - it was seen by fewer cameras than most frames and by fewer than three;
/// - the wrist jumps there: it lies 30 mm off the middle of its neighbours', and six times as far
///   as it usually does.
/// The severity also orders the frames that are to be trusted.
std::vector<FrameDoubt> frame_doubts(const Result& result);

/// Where to look first: the most severe of the frames whose pose is not to be trusted; else one
/// without a pose; else the most severe. The first of equals; 0 where there are no frames.
std::size_t worst_frame(const std::vector<FrameDoubt>& doubts);

/// What a person should think of a result: "good", "fair" or "poor".
struct FitVerdict {
  std::string_view word;
  std::string sentence;       ///< "57 of 60 frames can be trusted."
  std::size_t trusted = 0;    ///< frames without a reason against them
  double mean_overlap = 0.0;  ///< of these frames' silhouettes, over all cameras; 0 without any
};
FitVerdict fit_verdict(const Result& result, const std::vector<FrameDoubt>& doubts);

}  // namespace tegata
