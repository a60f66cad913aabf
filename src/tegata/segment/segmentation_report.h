// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace tegata {

/// How a picture became a silhouette.
struct SegmentationReport {
  double threshold = 0.0;  ///< in the picture's own unit, where there is one
  std::size_t hand_pixels = 0;
  /// The share of the outline on which hand and background are told apart by three times their
  /// spread; 0 without a hand.
  double confidence = 0.0;
};

}  // namespace tegata
