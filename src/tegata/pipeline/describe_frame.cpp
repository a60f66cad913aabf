// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/describe_frame.h"

#include "tegata/fit/support.h"

namespace tegata {
namespace {

// Below this mean overlap of a frame's silhouettes the pose is given, but not called ok. The object
// eats up to half of a hand's silhouette in infrared.
constexpr double kLeastOverlap = 0.5;

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
  double sum = 0.0;
  for (const FitView& view : prepared.frame.views) {
    const double overlap = silhouette_overlap(hand, posed, view);
    frame.views.push_back(view.camera.name);
    frame.silhouette_iou[view.camera.name] = overlap;
    sum += overlap;
  }
  if (sum < kLeastOverlap * static_cast<double>(frame.views.size())) {
    frame.status = "poor overlap with the silhouettes";
  }
  return frame;
}

ResultFrame describe_missing(const PreparedFrame& prepared, const std::string& why) {
  ResultFrame frame;
  frame.name = prepared.name;
  frame.time = prepared.time;
  frame.status = why;
  return frame;
}

}  // namespace tegata
