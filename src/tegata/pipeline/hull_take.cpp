// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/hull_take.h"

#include "tegata/base/error.h"
#include "tegata/image/rasterizer.h"
#include "tegata/pipeline/frame_views.h"

namespace tegata {
namespace {

TakeHull hull_of(const FrameViews& frame, const HullOptions& options) {
  TakeHull hull;
  hull.frame = frame.name;
  hull.refusal = frame.refusal;
  hull.segment_seconds = frame.seconds;
  if (!hull.refusal.empty()) return hull;
  try {
    hull.mesh = visual_hull(frame.views, options, &hull.report);
  } catch (const Error& error) {
    hull.refusal = error.what();
    return hull;
  }
  for (const HullView& view : frame.views) {
    hull.overlaps[view.camera.name] =
        intersection_over_union(render_silhouette(hull.mesh, view.camera), view.silhouette);
  }
  return hull;
}

}  // namespace

void hull_take(Take& take, const HullTakeOptions& options,
               const std::function<void(const TakeHull& hull)>& on_hull, const Observer& observer) {
  const std::vector<std::size_t> indices = selected_frames(options.frames, take);
  const Segmenter segmenter(take, options.segmentation, observer);
  std::vector<TakeHull> hulls(indices.size());
  std::vector<std::vector<std::string>> notes(indices.size());
  for_each_frame(take, indices, options.threads,
                 {.work =
                      [&](std::size_t i, const TakeFrame& pictures) {
                        const FrameViews frame = frame_views(segmenter, pictures);
                        notes[i] = frame.notes;
                        hulls[i] = hull_of(frame, options.hull);
                      },
                  .finish =
                      [&](std::size_t i) {
                        for (const std::string& note : notes[i]) observer.warn(note);
                        if (!hulls[i].refusal.empty()) {
                          observer.warn(text("frame ", hulls[i].frame, ": ", hulls[i].refusal));
                        }
                        on_hull(hulls[i]);
                        hulls[i].mesh = {};
                      }},
                 observer);
}

}  // namespace tegata
