// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "tegata/image/image.h"
#include "tegata/image/silhouette.h"

namespace tegata {

/// Decodes PNG, JPEG or TIFF, 8 or 16 bit, one channel or colour (alpha is dropped). Throws Error
/// naming the file where it is missing, truncated or not a picture.
CameraImage read_picture(const std::filesystem::path& file);

/// Encodes by the file's ending. Throws Error naming the file where it cannot be written whole.
void write_picture(const CameraImage& picture, const std::filesystem::path& file);

/// The bytes of a JPEG (8-bit), for pages that carry their pictures.
std::vector<std::uint8_t> encode_jpeg(const CameraImage& picture, int quality);

/// 0, 128 and 255, other values snapped to the nearest of the three.
Silhouette silhouette_from_mask(const CameraImage& mask);
/// Of a label image: the pixels of one label are hand, those of 0 background; what carries another
/// label may stand in front of the hand and is unknown. Throws Error for pictures in colour.
Silhouette silhouette_from_labels(const CameraImage& labels, int hand);
CameraImage mask_from_silhouette(const Silhouette& silhouette);

}  // namespace tegata
