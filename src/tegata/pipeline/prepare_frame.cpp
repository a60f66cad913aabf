// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/prepare_frame.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tegata/base/error.h"
#include "tegata/base/stopwatch.h"
#include "tegata/pipeline/frame_views.h"

namespace tegata {
namespace {

// With fewer views it would be two that are left, of which nobody knows whether they agree.
constexpr std::size_t kLeastViewsToLeaveOneOut = 4;

// Where the views have nothing in common but all without one have, that one is left out: of several
// such the one without which most remains. False where there is none.
bool leave_out_emptying_view(const std::vector<HullView>& views, const HullOptions& options,
                             PreparedFrame& prepared) {
  if (views.size() < kLeastViewsToLeaveOneOut) return false;
  std::optional<std::size_t> emptying;
  double largest = 0.0;
  for (std::size_t i = 0; i < views.size(); ++i) {
    std::vector<HullView> others = views;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    try {
      HullReport report;
      TriangleMesh hull = visual_hull(others, options, &report);
      if (emptying && report.volume <= largest) continue;
      largest = report.volume;
      prepared.hull = std::move(hull);
      emptying = i;
    } catch (const Error&) {
      continue;
    }
  }
  if (!emptying) return false;
  const std::string& camera = views[*emptying].camera.name;
  constexpr const char* kWhy = "it has nothing in common with the other cameras";
  prepared.notes.push_back(
      text("frame ", prepared.name, ", camera '", camera, "': ", kWhy, ", the view is left out"));
  prepared.left_out[camera] = kWhy;
  prepared.frame.views.erase(prepared.frame.views.begin() + static_cast<std::ptrdiff_t>(*emptying));
  return true;
}

}  // namespace

PreparedFrame prepare_views(const Segmenter& segmenter, const TakeFrame& pictures) {
  FrameViews seen = frame_views(segmenter, pictures);
  PreparedFrame prepared;
  prepared.name = seen.name;
  prepared.time = seen.time;
  prepared.refusal = seen.refusal;
  prepared.notes = seen.notes;
  prepared.left_out = seen.left_out;
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
  std::vector<HullView> views;
  for (const FitView& view : prepared.frame.views) views.push_back({view.camera, view.silhouette});
  try {
    prepared.hull = visual_hull(views, options);
  } catch (const Error& error) {
    if (!leave_out_emptying_view(views, options, prepared)) prepared.refusal = error.what();
  }
  if (prepared.refusal.empty()) prepared.frame.hull.emplace(prepared.hull);
  prepared.hull_seconds = watch.seconds();
}

PreparedFrame prepare_frame(const Segmenter& segmenter, const TakeFrame& pictures,
                            const HullOptions& options) {
  PreparedFrame prepared = prepare_views(segmenter, pictures);
  add_hull(prepared, options);
  return prepared;
}

}  // namespace tegata
