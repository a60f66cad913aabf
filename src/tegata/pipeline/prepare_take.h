// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tegata/base/observer.h"
#include "tegata/camera/scene_frame.h"
#include "tegata/fit/frame_source.h"
#include "tegata/hull/visual_hull.h"
#include "tegata/mesh/triangle_mesh.h"
#include "tegata/pipeline/frame_selection.h"
#include "tegata/pipeline/frame_store.h"
#include "tegata/pipeline/prepare_frame.h"
#include "tegata/take/take.h"

namespace tegata {

/// How a take's pictures become what the fit needs.
struct PrepareOptions {
  FrameSelection frames;
  std::optional<SegmentationMethod> segmentation;  ///< absent: what the take says, or chosen
  HullOptions hull;                                ///< lengths in the world
  /// The hand's lengths are multiplied by it; absent: it is to be estimated.
  std::optional<double> scale = 1.0;
  int threads = 0;
  /// Frames wait in a nameless file in it (FrameStore); empty: in memory, which grows with them.
  std::filesystem::path scratch_folder;
  /// Called in the order of the frames with each frame's simplified hull, in the world.
  std::function<void(const std::string& frame, const TriangleMesh& hull)> on_hull;
};

/// The frame that a take is prepared and fitted in.
SceneFrame scene_of(const Take& take, const PrepareOptions& options);

/// Lengths of the world as those of a scene.
HullOptions in_scene(HullOptions options, const SceneFrame& scene);

/// The frames of a take; the usable ones as a source for the fit.
class PreparedTake final : public FrameSource {
 public:
  /// Throws Error naming the folder where no frame is usable.
  PreparedTake(const Take& take, const SceneFrame& scene, FrameStore frames);

  /// What all poses, cameras and hulls of the frames are in.
  const SceneFrame& scene() const { return scene_; }

  const FrameStore& frames() const { return frames_; }
  /// Which frames are without a refusal; never empty.
  const std::vector<std::size_t>& usable() const { return usable_; }

  std::size_t size() const override { return usable_.size(); }
  std::shared_ptr<const FitFrame> frame(std::size_t i) const override;
  void set_landmarks(std::size_t i, const std::optional<StartLandmarks>& landmarks);

 private:
  SceneFrame scene_;
  FrameStore frames_;
  std::vector<std::size_t> usable_;
};

/// Where in the scene the take says that the hand is in its first frame; nothing, with a warning
/// where it says so in vain, if that is not the first one that is used.
std::optional<StartLandmarks> start_landmarks(const Take& take, const SceneFrame& scene,
                                              bool from_first_frame, const Observer& observer);

/// Prepares the selected frames and gives the first one its landmarks, where the take has them.
/// Throws Error where no frame can be fitted.
PreparedTake prepare_take(Take& take, const PrepareOptions& options, const Observer& observer);

}  // namespace tegata
