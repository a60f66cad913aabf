// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>

#include "tegata/base/observer.h"
#include "tegata/hand/hand_model.h"
#include "tegata/take/result.h"

namespace tegata {

/// Writes a video (MP4) of a result's hand in its own frame, which turns once about the palm's long
/// axis while its fingers go through the result's frames. `width` is rounded up to an even number
/// of pixels. Returns the number of pictures. Throws Error where no frame has a pose.
std::size_t write_turning_hand(const Result& result, const HandModel& hand, int width,
                               const std::filesystem::path& file, const Observer& observer);

}  // namespace tegata
