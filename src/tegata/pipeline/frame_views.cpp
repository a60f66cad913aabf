// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/frame_views.h"

#include <optional>

#include "tegata/base/stopwatch.h"
#include "tegata/base/text.h"

namespace tegata {

FrameViews frame_views(const Segmenter& segmenter, const TakeFrame& pictures) {
  constexpr std::size_t kLeastViews = 2;
  FrameViews frame;
  frame.name = pictures.name;
  frame.time = pictures.time;
  for (std::size_t c = 0; c < pictures.pictures.size(); ++c) {
    const std::string& camera = segmenter.rig()[c].name;
    if (!pictures.pictures[c]) frame.left_out[camera] = pictures.why_missing(camera);
  }
  if (pictures.view_count() < kLeastViews) {
    frame.refusal = text("pictures from ", pictures.view_count(), " camera, 2 or more are needed");
    return frame;
  }
  const Stopwatch watch;
  const std::vector<std::optional<Silhouette>> silhouettes = segmenter.segment(pictures);
  for (std::size_t c = 0; c < silhouettes.size(); ++c) {
    const Camera& camera = segmenter.rig()[c];
    if (!silhouettes[c]) continue;
    if (count_pixels(*silhouettes[c], PixelLabel::hand) == 0) {
      frame.notes.push_back(text("frame ", pictures.name, ", camera '", camera.name,
                                 "': no hand was found in the picture, the view is left out"));
      frame.left_out[camera.name] = "no hand was found in the picture";
      continue;
    }
    frame.views.push_back(segmenter.undistorted(*silhouettes[c], c));
  }
  frame.seconds = watch.seconds();
  if (frame.views.size() < kLeastViews) {
    frame.refusal = text("hand found in ", frame.views.size(), " view, 2 or more are needed");
  }
  return frame;
}

}  // namespace tegata
