// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/overlays.h"

#include <algorithm>
#include <map>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/image/overlay.h"
#include "tegata/image/rasterizer.h"
#include "tegata/pipeline/silhouettes.h"

namespace tegata {
namespace {

constexpr Colour kSilhouetteColour = {70, 200, 255};
constexpr Colour kHandColour = {255, 140, 0};
constexpr int kOutlineWidthPx = 2;

// Evenly spread over those that have a pose, the first and the last among them.
std::vector<const ResultFrame*> spread_frames(const Result& result, std::size_t most) {
  std::vector<const ResultFrame*> posed;
  for (const ResultFrame& frame : result.frames) {
    if (frame.pose) posed.push_back(&frame);
  }
  if (posed.size() <= most) return posed;
  std::vector<const ResultFrame*> chosen;
  for (std::size_t i = 0; i < most; ++i) {
    chosen.push_back(posed[most == 1 ? 0 : i * (posed.size() - 1) / (most - 1)]);
  }
  return chosen;
}

}  // namespace

std::vector<Overlay> draw_overlays(Take& take, const Result& result, const HandModel& hand,
                                   const OverlayOptions& options, const Observer& observer) {
  std::map<std::string, std::size_t> index_of;
  for (std::size_t i = 0; i < take.frame_names().size(); ++i) index_of[take.frame_names()[i]] = i;
  const Segmenter segmenter(take, options.segmentation, observer);

  std::vector<Overlay> overlays;
  for (const ResultFrame* frame : spread_frames(result, options.most_frames)) {
    const auto found = index_of.find(frame->name);
    if (found == index_of.end()) {
      throw Error(take.folder().string(), ": got no frame '", frame->name,
                  "', expected the take that the result was made of");
    }
    const TakeFrame pictures = take.read_frame(found->second, observer);
    const TakeFrame shown = take.read_display_frame(found->second, observer);
    const auto silhouettes = segmenter.segment(pictures);
    const TriangleMesh surface = PosedHand(hand, *frame->pose).surface();
    for (std::size_t c = 0; c < take.rig().size(); ++c) {
      if (!pictures.pictures[c] || !shown.pictures[c]) continue;
      CameraImage picture = for_display(*shown.pictures[c]);
      draw_outline(picture, *silhouettes[c], kSilhouetteColour, kOutlineWidthPx);
      draw_outline(picture, render_silhouette(surface, take.rig()[c]), kHandColour,
                   kOutlineWidthPx);
      overlays.push_back({frame->name, take.rig()[c].name, shrunk(picture, options.widest)});
    }
  }
  return overlays;
}

}  // namespace tegata
