// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/prepare_frame.h"

#include <utility>

#include "tegata/base/error.h"
#include "tegata/base/stopwatch.h"
#include "tegata/pipeline/frame_views.h"

namespace tegata {

PreparedFrame prepare_frame(const Take& take, const TakeFrame& pictures, SegmentationMethod method,
                            const HullOptions& options) {
  FrameViews seen = frame_views(take, pictures, method);
  PreparedFrame prepared;
  prepared.name = seen.name;
  prepared.time = seen.time;
  prepared.refusal = seen.refusal;
  prepared.notes = seen.notes;
  prepared.segment_seconds = seen.seconds;
  if (!prepared.refusal.empty()) return prepared;
  try {
    const Stopwatch hull_watch;
    prepared.hull = visual_hull(seen.views, options);
    prepared.frame.hull.emplace(prepared.hull);
    for (HullView& view : seen.views) {
      prepared.frame.views.push_back(make_fit_view(view.camera, std::move(view.silhouette)));
    }
    prepared.hull_seconds = hull_watch.seconds();
  } catch (const Error& error) {
    prepared.refusal = error.what();
  }
  return prepared;
}

}  // namespace tegata
