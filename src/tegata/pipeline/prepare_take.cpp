// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/prepare_take.h"

#include <utility>

#include "tegata/base/error.h"
#include "tegata/pipeline/in_world.h"

namespace tegata {
namespace {

FrameStore prepare_frames(Take& take, const SceneFrame& scene,
                          const std::vector<std::size_t>& indices, const PrepareOptions& options,
                          const Observer& observer) {
  const Segmenter segmenter(take, options.segmentation, observer, scene);
  const HullOptions hull = in_scene(options.hull, scene);
  FrameStore stored(options.scratch_folder);
  std::vector<PreparedFrame> ahead(kFramesAtOnce);
  for_each_frame(take, indices, options.threads,
                 {.work =
                      [&](std::size_t i, const TakeFrame& pictures) {
                        ahead[i % kFramesAtOnce] = prepare_frame(segmenter, pictures, hull);
                      },
                  .finish =
                      [&](std::size_t i) {
                        PreparedFrame frame = std::exchange(ahead[i % kFramesAtOnce], {});
                        for (const std::string& note : frame.notes) observer.warn(note);
                        if (!frame.refusal.empty()) {
                          observer.warn(text("frame ", frame.name, ": ", frame.refusal));
                        } else if (options.on_hull) {
                          options.on_hull(frame.name, in_world(scene, frame.hull));
                        }
                        stored.add(std::move(frame));
                      }},
                 observer);
  return stored;
}

}  // namespace

SceneFrame scene_of(const Take& take, const PrepareOptions& options) {
  return scene_frame(take.rig(), options.scale.value_or(1.0));
}

HullOptions in_scene(HullOptions options, const SceneFrame& scene) {
  options.voxel_size /= scene.metres_per_unit;
  options.largest_error /= scene.metres_per_unit;
  return options;
}

std::optional<StartLandmarks> start_landmarks(const Take& take, const SceneFrame& scene,
                                              bool from_first_frame, const Observer& observer) {
  if (!take.info().initial_landmarks) return std::nullopt;
  if (!from_first_frame) {
    observer.warn("[initial_pose] is of the take's first frame, which is not fitted: not used");
    return std::nullopt;
  }
  const InitialLandmarks& landmarks = *take.info().initial_landmarks;
  return StartLandmarks{scene.in_scene(landmarks.wrist), scene.in_scene(landmarks.index_mcp),
                        scene.in_scene(landmarks.little_mcp)};
}

PreparedTake::PreparedTake(const Take& take, const SceneFrame& scene, FrameStore frames)
    : scene_(scene), frames_(std::move(frames)) {
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    if (frames_.brief(i).refusal.empty()) usable_.push_back(i);
  }
  if (usable_.empty()) {
    throw Error(take.folder().string(), ": none of ", frames_.size(),
                " frames can be fitted; the first, ", frames_.brief(0).name, ": ",
                frames_.brief(0).refusal);
  }
}

std::shared_ptr<const FitFrame> PreparedTake::frame(std::size_t i) const {
  return std::make_shared<const FitFrame>(frames_.restored(usable_[i]).frame);
}

void PreparedTake::set_landmarks(std::size_t i, const std::optional<StartLandmarks>& landmarks) {
  frames_.set_landmarks(usable_[i], landmarks);
}

PreparedTake prepare_take(Take& take, const PrepareOptions& options, const Observer& observer) {
  const std::vector<std::size_t> indices = selected_frames(options.frames, take);
  const SceneFrame scene = scene_of(take, options);
  PreparedTake prepared(take, scene, prepare_frames(take, scene, indices, options, observer));
  const bool from_first_frame = indices[prepared.usable().front()] == 0;
  prepared.set_landmarks(0, start_landmarks(take, scene, from_first_frame, observer));
  return prepared;
}

}  // namespace tegata
