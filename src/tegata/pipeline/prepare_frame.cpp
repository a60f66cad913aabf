// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/prepare_frame.h"

#include <utility>

#include "tegata/base/error.h"
#include "tegata/base/stopwatch.h"
#include "tegata/pipeline/frame_views.h"

namespace tegata {

PreparedFrame prepare_views(const Segmenter& segmenter, const TakeFrame& pictures) {
  FrameViews seen = frame_views(segmenter, pictures);
  PreparedFrame prepared;
  prepared.name = seen.name;
  prepared.time = seen.time;
  prepared.refusal = seen.refusal;
  prepared.notes = seen.notes;
  if (prepared.refusal.empty()) {
    const Stopwatch watch;
    for (HullView& view : seen.views) {
      prepared.frame.views.push_back(make_fit_view(view.camera, std::move(view.silhouette)));
    }
    seen.seconds += watch.seconds();
  }
  prepared.segment_seconds = seen.seconds;
  return prepared;
}

void add_hull(PreparedFrame& prepared, const HullOptions& options) {
  if (!prepared.refusal.empty()) return;
  const Stopwatch watch;
  try {
    std::vector<HullView> views;
    for (const FitView& view : prepared.frame.views) {
      views.push_back({view.camera, view.silhouette});
    }
    prepared.hull = visual_hull(views, options);
    prepared.frame.hull.emplace(prepared.hull);
  } catch (const Error& error) {
    prepared.refusal = error.what();
  }
  prepared.hull_seconds = watch.seconds();
}

PreparedFrame prepare_frame(const Segmenter& segmenter, const TakeFrame& pictures,
                            const HullOptions& options) {
  PreparedFrame prepared = prepare_views(segmenter, pictures);
  add_hull(prepared, options);
  return prepared;
}

}  // namespace tegata
