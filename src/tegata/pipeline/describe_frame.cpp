// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/describe_frame.h"

#include <optional>

#include "tegata/fit/support.h"

namespace tegata {
namespace {

// With a lower mean overlap of a frame's silhouettes or more of the seen hand beside the fitted one
// [m], on average, the pose is given but not called ok. In infrared an object eats half of a hand's
// silhouette and more.
constexpr double kLeastOverlap = 0.35, kMostUncovered = 0.003;

}  // namespace

ResultFrame describe_frame(const FitHand& hand, const HandPose& pose,
                           const PreparedFrame& prepared) {
  ResultFrame frame;
  frame.name = prepared.name;
  frame.time = prepared.time;
  const PosedHand posed = hand.posed(pose);
  frame.pose = pose;
  frame.keypoints = posed.keypoints();
  frame.support = bone_support(hand, posed, prepared.frame.views);
  frame.left_out = prepared.left_out;
  double sum = 0.0, uncovered_sum = 0.0;
  std::size_t seen_by = 0;
  for (const FitView& view : prepared.frame.views) {
    const double overlap = silhouette_overlap(hand, posed, view);
    frame.views.push_back(view.camera.name);
    frame.silhouette_iou[view.camera.name] = overlap;
    if (const std::optional<double> uncovered = uncovered_distance(hand, posed, view)) {
      frame.uncovered[view.camera.name] = *uncovered;
      uncovered_sum += *uncovered;
    }
    sum += overlap;
    if (overlap >= kLeastSeenOverlap) seen_by += 1;
  }
  if (sum < kLeastOverlap * static_cast<double>(frame.views.size())) {
    frame.status = "poor overlap with the silhouettes";
  } else if (seen_by < 2) {
    frame.status = "no second camera sees a hand where it is fitted";
  } else if (uncovered_sum >
             kMostUncovered * hand.scale * static_cast<double>(frame.uncovered.size())) {
    frame.status = "the seen hand reaches beyond the fitted one";
  }
  return frame;
}

ResultFrame describe_missing(const PreparedFrame& prepared, const std::string& why) {
  ResultFrame frame;
  frame.name = prepared.name;
  frame.time = prepared.time;
  frame.status = why;
  frame.left_out = prepared.left_out;
  return frame;
}

}  // namespace tegata
