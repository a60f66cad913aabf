// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/prepare_take.h"

#include "tegata/base/error.h"

namespace tegata {
namespace {

std::vector<PreparedFrame> prepare_frames(Take& take, const std::vector<std::size_t>& indices,
                                          const PrepareOptions& options, const Observer& observer) {
  const Segmenter segmenter(take, options.segmentation, observer);
  std::vector<PreparedFrame> prepared(indices.size());
  for_each_frame(take, indices, options.threads,
                 {.work =
                      [&](std::size_t i, const TakeFrame& pictures) {
                        prepared[i] = prepare_frame(segmenter, pictures, options.hull);
                      },
                  .finish =
                      [&](std::size_t i) {
                        const PreparedFrame& frame = prepared[i];
                        for (const std::string& note : frame.notes) observer.warn(note);
                        if (!frame.refusal.empty()) {
                          observer.warn(text("frame ", frame.name, ": ", frame.refusal));
                        } else if (options.on_hull) {
                          options.on_hull(frame.name, frame.hull);
                        }
                      }},
                 observer);
  return prepared;
}

}  // namespace

std::optional<StartLandmarks> start_landmarks(const Take& take, bool from_first_frame,
                                              const Observer& observer) {
  if (!take.info().initial_landmarks) return std::nullopt;
  if (!from_first_frame) {
    observer.warn("[initial_pose] is of the take's first frame, which is not fitted: not used");
    return std::nullopt;
  }
  const InitialLandmarks& landmarks = *take.info().initial_landmarks;
  return StartLandmarks{landmarks.wrist, landmarks.index_mcp, landmarks.little_mcp};
}

std::vector<const FitFrame*> PreparedTake::fit_frames() const {
  std::vector<const FitFrame*> pointers;
  for (const std::size_t i : usable) pointers.push_back(&frames[i].frame);
  return pointers;
}

PreparedTake prepare_take(Take& take, const PrepareOptions& options, const Observer& observer) {
  const std::vector<std::size_t> indices = selected_frames(options.frames, take);
  PreparedTake prepared;
  prepared.frames = prepare_frames(take, indices, options, observer);
  for (std::size_t i = 0; i < prepared.frames.size(); ++i) {
    if (prepared.frames[i].refusal.empty()) prepared.usable.push_back(i);
  }
  if (prepared.usable.empty()) {
    throw Error(take.folder().string(), ": none of ", prepared.frames.size(),
                " frames can be fitted; the first, ", prepared.frames.front().name, ": ",
                prepared.frames.front().refusal);
  }
  const std::size_t first = prepared.usable.front();
  prepared.frames[first].frame.landmarks = start_landmarks(take, indices[first] == 0, observer);
  return prepared;
}

}  // namespace tegata
