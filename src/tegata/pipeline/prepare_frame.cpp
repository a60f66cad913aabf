// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/prepare_frame.h"

#include <utility>

#include "tegata/base/error.h"
#include "tegata/base/stopwatch.h"

namespace tegata {
namespace {

constexpr std::size_t kLeastViews = 2;

// The views in which any pixel may be the hand; the others are noted and left out: one camera that
// looks elsewhere must not empty the hull.
std::vector<HullView> useful_views(const Take& take, const TakeFrame& pictures,
                                   SegmentationMethod method, PreparedFrame& prepared) {
  std::vector<std::optional<Silhouette>> silhouettes = segment_frame(take, pictures, method);
  std::vector<HullView> views;
  for (std::size_t c = 0; c < silhouettes.size(); ++c) {
    if (!silhouettes[c]) continue;
    const Camera& camera = take.rig()[c];
    if (count_pixels(*silhouettes[c], PixelLabel::hand) == 0) {
      prepared.notes.push_back(text("frame ", pictures.name, ", camera '", camera.name,
                                    "': no hand was found in the picture, the view is left out"));
      continue;
    }
    views.push_back({camera.undistorted(), undistort(*silhouettes[c], camera)});
  }
  return views;
}

}  // namespace

PreparedFrame prepare_frame(const Take& take, const TakeFrame& pictures, SegmentationMethod method,
                            const HullOptions& options) {
  PreparedFrame prepared;
  prepared.name = pictures.name;
  prepared.time = pictures.time;
  if (pictures.view_count() < kLeastViews) {
    prepared.refusal =
        text("pictures from ", pictures.view_count(), " camera, 2 or more are needed");
    return prepared;
  }
  const Stopwatch segment_watch;
  std::vector<HullView> views = useful_views(take, pictures, method, prepared);
  prepared.segment_seconds = segment_watch.seconds();
  if (views.size() < kLeastViews) {
    prepared.refusal = text("hand found in ", views.size(), " view, 2 or more are needed");
    return prepared;
  }
  try {
    const Stopwatch hull_watch;
    prepared.hull = visual_hull(views, options);
    prepared.frame.hull.emplace(prepared.hull);
    for (HullView& view : views) {
      prepared.frame.views.push_back(make_fit_view(view.camera, std::move(view.silhouette)));
    }
    prepared.hull_seconds = hull_watch.seconds();
  } catch (const Error& error) {
    prepared.refusal = error.what();
  }
  return prepared;
}

}  // namespace tegata
