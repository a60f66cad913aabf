// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tegata/camera/camera.h"

namespace tegata {

/// The two files of COLMAP's text model, and what to call them in messages.
struct ColmapText {
  std::string cameras, images;
  std::string cameras_file = "cameras.txt", images_file = "images.txt";
};

/// One camera for each image: its folder's name where each image has a folder of its own, else its
/// name without ending. COLMAP's pixel (0.5, 0.5) is the centre of the first one: principal points
/// move by half a pixel. Models: SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, RADIAL, OPENCV,
/// FULL_OPENCV, OPENCV_FISHEYE, SIMPLE_RADIAL_FISHEYE, RADIAL_FISHEYE.
CameraRig read_colmap(const ColmapText& content, double metres_per_unit);

}  // namespace tegata
