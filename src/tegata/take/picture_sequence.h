// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tegata/camera/camera.h"
#include "tegata/image/image.h"

namespace tegata {

/// The pictures of all cameras of a rig, frame by frame.
class PictureSequence {
 public:
  virtual ~PictureSequence() = default;
  /// Of the frames, in order.
  const std::vector<std::string>& names() const { return names_; }
  /// What lies there and belongs to no camera, one line each.
  const std::vector<std::string>& notes() const { return notes_; }
  /// Whether a camera should have a picture of a frame.
  virtual bool has(std::size_t camera, std::size_t frame) const = 0;
  /// Throws Error naming the file where the picture cannot be decoded.
  virtual CameraImage read(std::size_t camera, std::size_t frame) = 0;

 protected:
  std::vector<std::string> names_, notes_;
};

/// What is to be done about a camera without pictures.
enum class Completeness { every_camera, some_cameras };

/// <folder>/<camera>/<frame>.png|jpg|tif. Frames pair up by name. Throws Error for a camera without
/// pictures (unless some cameras are enough) and for two files of one name.
std::unique_ptr<PictureSequence> open_picture_folders(const std::filesystem::path& folder,
                                                      const CameraRig& rig,
                                                      Completeness completeness);

/// <folder>/<camera>.mp4|avi|mkv. Frames pair up by index; there are as many as in the longest.
std::unique_ptr<PictureSequence> open_videos(const std::filesystem::path& folder,
                                             const CameraRig& rig, Completeness completeness);

/// The picture file <folder>/<stem>.png|jpg|tif, or an empty path where there is none.
std::filesystem::path find_picture(const std::filesystem::path& folder, const std::string& stem);

/// Whether a comes before b, with runs of digits compared as numbers: "a2" before "a10".
bool natural_less(std::string_view a, std::string_view b);

}  // namespace tegata
