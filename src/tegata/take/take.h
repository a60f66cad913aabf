// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tegata/base/observer.h"
#include "tegata/camera/camera.h"
#include "tegata/image/image.h"
#include "tegata/take/take_info.h"

namespace tegata {

/// Where the silhouettes of a take come from.
enum class PictureSource { images, videos, masks };

/// One moment: a picture per camera of the rig, in its order; empty where a camera has none.
struct TakeFrame {
  std::string name;
  double time = 0.0;  ///< [s]
  std::vector<std::optional<CameraImage>> pictures;
  std::vector<std::string> broken;  ///< cameras whose picture of it is there, but of no use
  std::size_t view_count() const;
  /// Why a camera has no picture.
  std::string why_missing(const std::string& camera) const;
};

/// A recording: a folder as docs/formats.md describes it.
class Take {
 public:
  /// Reads take.toml, the calibration and the list of frames, and no picture but the first. Throws
  /// Error naming file and key for anything missing, unknown or inconsistent.
  static Take open(const std::filesystem::path& folder);
  ~Take();
  Take(Take&&) noexcept;
  Take& operator=(Take&&) noexcept;

  const std::filesystem::path& folder() const;
  const TakeInfo& info() const;
  /// Cameras in metres.
  const CameraRig& rig() const;
  PictureSource source() const;
  /// Whether there are pictures: true but for takes of masks alone.
  bool has_pictures() const;
  /// Names of the frames in order: file names without ending, or six-digit video indices.
  const std::vector<std::string>& frame_names() const;
  /// The picture of the empty scene, where the take has one for this camera.
  std::optional<CameraImage> background(std::size_t camera) const;
  /// What a user should know of the folder although it stops nothing (a video that no camera of the
  /// calibration has, say), one line each. The first read_frame() says it to the observer.
  const std::vector<std::string>& notes() const;

  /// Decodes one frame. Masks come as 8-bit pictures of 0, 128 and 255. A picture that cannot be
  /// decoded, or whose size is not the calibration's, is left out and said to the observer. Videos
  /// are decoded forwards: asking in ascending order is fast, going back starts the file anew.
  TakeFrame read_frame(std::size_t index, const Observer& observer);
  /// The same for people to look at: where the source is masks, the pictures that lie beside them,
  /// and the mask itself for a camera that has none.
  TakeFrame read_display_frame(std::size_t index, const Observer& observer);

 private:
  struct State;
  explicit Take(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace tegata
