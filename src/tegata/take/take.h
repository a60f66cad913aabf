// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tegata/base/observer.h"
#include "tegata/camera/camera.h"
#include "tegata/hand/skeleton.h"
#include "tegata/image/image.h"

namespace tegata {

/// Three landmarks of the first frame in world coordinates [m], rough (1-2 cm) is enough.
struct InitialLandmarks {
  Eigen::Vector3d wrist, index_mcp, little_mcp;
};

enum class SegmentationMethod { infrared, background, skin, mask };
std::string_view segmentation_method_name(SegmentationMethod method);
/// Throws Error listing the names that would do.
SegmentationMethod segmentation_method_from_name(std::string_view name);

/// What take.toml says; everything is optional there.
struct TakeInfo {
  std::string name;                    ///< the folder's name where the file does not say
  std::optional<Side> side;
  double fps = 30.0;
  double metres_per_unit = 1.0;        ///< already applied to the rig and not to the landmarks
  std::optional<InitialLandmarks> initial_landmarks;
  std::optional<SegmentationMethod> segmentation;
};

/// Where the pictures of a take lie.
enum class PictureSource { images, videos, masks };

/// One moment: a picture per camera of the rig, in its order; empty where a camera has none.
struct TakeFrame {
  std::string name;
  double time = 0.0;  ///< [s]
  std::vector<std::optional<CameraImage>> pictures;
  std::size_t view_count() const;
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
  /// Names of the frames in order: file names without ending, or six-digit video indices.
  const std::vector<std::string>& frame_names() const;
  /// The picture of the empty scene, where the take has one for this camera.
  std::optional<CameraImage> background(std::size_t camera) const;

  /// Decodes one frame. Masks come as 8-bit pictures of 0, 128 and 255. A picture that cannot be
  /// decoded, or whose size is not the calibration's, is left out and said to the observer. Videos
  /// are decoded forwards: asking in ascending order is fast, going back starts the file anew.
  TakeFrame read_frame(std::size_t index, const Observer& observer);

 private:
  struct State;
  explicit Take(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Writes take.toml.
void write_take_info(const TakeInfo& info, const std::filesystem::path& file);

}  // namespace tegata
