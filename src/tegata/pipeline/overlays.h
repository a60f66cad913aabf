// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tegata/base/observer.h"
#include "tegata/hand/hand_model.h"
#include "tegata/image/image.h"
#include "tegata/take/result.h"
#include "tegata/take/take.h"

namespace tegata {

/// A camera's picture with the outlines of the silhouette and of the fitted hand over it.
struct Overlay {
  std::string frame, camera;
  CameraImage picture;  ///< 8 bit, 3 channels
};

/// The overlays of the frames of a result (all, or at most `most_frames` spread evenly), pictures
/// at most `widest` pixels wide.
std::vector<Overlay> draw_overlays(Take& take, const Result& result, const HandModel& hand,
                                   std::size_t most_frames, int widest, const Observer& observer);

}  // namespace tegata
