// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

#include "tegata/image/image.h"

namespace tegata {

/// Writes an MP4 (H.264) of `count` 8-bit colour pictures, which are asked for one after the other.
/// All are as large as the first, an even number of pixels in width and height. Throws Error naming
/// the file where it cannot be written.
void write_video(const std::filesystem::path& file, double pictures_per_second, std::size_t count,
                 const std::function<CameraImage(std::size_t)>& picture);

}  // namespace tegata
