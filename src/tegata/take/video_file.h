// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include "tegata/image/image.h"

namespace tegata {

/// A video that is decoded forwards through FFmpeg, 8 bits, 3 channels.
class VideoFile {
 public:
  /// Throws Error naming the file where it is missing, cut short before its index or no video.
  explicit VideoFile(std::filesystem::path file);
  ~VideoFile();
  VideoFile(VideoFile&&) noexcept;
  VideoFile& operator=(VideoFile&&) noexcept;

  const std::filesystem::path& file() const;
  /// What the file says of itself, or by counting where it says nothing.
  std::size_t frame_count() const;
  /// Asking again for the last picture costs nothing, going back starts the file anew. Throws Error
  /// naming the file where the picture cannot be decoded.
  const CameraImage& read(std::size_t index);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tegata
