// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "tegata/take/picture_sequence.h"
#include "tegata/take/take_info.h"

namespace tegata {

/// By camera of the rig: how many of its frames lie before the take's first one. Throws Error where
/// `info`, read from `file`, has an offset for a camera that the rig does not have.
std::vector<int> camera_offsets(const TakeInfo& info, const CameraRig& rig,
                                const std::filesystem::path& file);

/// The same pictures with each camera's frame k at k - offset. Frames keep their names; those at
/// the end that no camera has any more are gone.
std::unique_ptr<PictureSequence> with_offsets(std::unique_ptr<PictureSequence> pictures,
                                              const std::vector<int>& offsets);

}  // namespace tegata
