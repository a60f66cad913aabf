// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "tegata/base/observer.h"
#include "tegata/image/silhouette.h"
#include "tegata/take/take.h"

namespace tegata {

/// The method that suits a take: what it says itself, or else by its pictures: masks where it has
/// them, background where it has pictures of the empty scene, infrared for pictures of one channel
/// or without colour, skin for colour.
SegmentationMethod choose_segmentation(Take& take, const Observer& observer);

/// The silhouettes of a frame, one per camera of the rig in its distorted picture; nothing where a
/// camera has no picture.
std::vector<std::optional<Silhouette>> segment_frame(const Take& take, const TakeFrame& frame,
                                                     SegmentationMethod method);

}  // namespace tegata
