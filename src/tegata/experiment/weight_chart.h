// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tegata/hand/skeleton.h"

namespace tegata {

/// What the paper's figure 4 shows: how much each bone counts in each frame.
struct WeightRecord {
  struct Frame {
    std::string name;
    std::array<double, kBoneCount> weights = {};  ///< mean robust weight, 0 to 1
    std::array<double, kBoneCount> support = {};  ///< share that the views show, 0 to 1
  };
  std::vector<Frame> frames;
};

/// One row a frame and bone.
std::string weights_csv(const WeightRecord& record);

/// A panel for each digit: weight (solid) and support (dashed) of its three bones together over the
/// frames.
std::string weights_svg(const WeightRecord& record);

}  // namespace tegata
