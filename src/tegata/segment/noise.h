// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tegata/image/image.h"

namespace tegata {

/// The standard deviation of the noise of single pixels (first channel), measured by a mask that is
/// blind to planes and edges (Immerkaer 1996), by its median so that few textured places do not
/// count.
double pixel_noise(const Image<float>& image);

/// The middle value (the upper one of two). There must be one.
float median(std::vector<float> values);

}  // namespace tegata
