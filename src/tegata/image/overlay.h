// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tegata/camera/camera.h"
#include "tegata/image/image.h"
#include "tegata/image/silhouette.h"
#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// Red, green, blue.
using Colour = std::array<std::uint8_t, 3>;

/// The picture as 8 bit and 3 channels; the values' range is stretched from the 1st to the 99.9th
/// percentile where it has one channel, so that raw infrared counts can be seen.
CameraImage for_display(const CameraImage& picture);

/// Draws the border of the hand's pixels, one or more pixels wide, onto an 8-bit colour picture.
void draw_outline(CameraImage& picture, const Silhouette& silhouette, Colour colour, int width_px);

/// The picture reduced by a whole factor (box average) to at most `widest` pixels in width.
CameraImage shrunk(const CameraImage& picture, int widest);

/// Pictures side by side in rows of `columns`, each in a cell of the largest one's size.
CameraImage contact_sheet(const std::vector<CameraImage>& pictures, int columns, Colour paper);

/// Draws a mesh, lit from the camera, onto an 8-bit colour picture of the camera's size.
void draw_shaded(CameraImage& picture, const TriangleMesh& mesh, const Camera& camera,
                 Colour colour);

}  // namespace tegata
