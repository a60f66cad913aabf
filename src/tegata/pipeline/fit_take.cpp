// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/fit_take.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/fit/support.h"
#include "tegata/pipeline/prepare_frame.h"

namespace tegata {
namespace {

// Below this mean overlap of a frame's silhouettes the pose is given, but not called ok. The object
// eats up to half of a hand's silhouette in infrared.
constexpr double kLeastOverlap = 0.5;

std::vector<PreparedFrame> prepare_frames(Take& take, const std::vector<std::size_t>& indices,
                                          SegmentationMethod method, const FitTakeOptions& options,
                                          const Observer& observer) {
  std::vector<PreparedFrame> prepared(indices.size());
  for_each_frame(take, indices, options.threads,
                 {.work =
                      [&](std::size_t i, const TakeFrame& pictures) {
                        prepared[i] = prepare_frame(take, pictures, method, options.hull);
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

ResultFrame describe_frame(const FitHand& hand, const HandPose& pose,
                           const PreparedFrame& prepared) {
  ResultFrame frame;
  frame.name = prepared.name;
  frame.time = prepared.time;
  const PosedHand posed(*hand.model, pose);
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

double sum_of(const std::vector<PreparedFrame>& frames, double PreparedFrame::*seconds) {
  return std::transform_reduce(frames.begin(), frames.end(), 0.0, std::plus<>(),
                               [seconds](const PreparedFrame& frame) { return frame.*seconds; });
}

}  // namespace

Result fit_take(Take& take, const HandModel& hand_model, const FitTakeOptions& options,
                const Observer& observer) {
  check_hand(hand_model);
  const std::vector<std::size_t> indices = selected_frames(options.frames, take);
  const SegmentationMethod method =
      options.segmentation ? *options.segmentation : choose_segmentation(take, observer);
  std::vector<PreparedFrame> prepared = prepare_frames(take, indices, method, options, observer);

  std::vector<const FitFrame*> frames;
  std::vector<std::size_t> usable;
  for (std::size_t i = 0; i < prepared.size(); ++i) {
    if (prepared[i].refusal.empty()) usable.push_back(i);
  }
  if (usable.empty()) {
    throw Error(take.folder().string(), ": none of ", prepared.size(),
                " frames can be fitted; the first, ", prepared.front().name, ": ",
                prepared.front().refusal);
  }
  for (const std::size_t i : usable) frames.push_back(&prepared[i].frame);

  const FitHand hand(hand_model);
  GraspFitOptions fit_options = options.fit;
  fit_options.threads = options.threads;
  PreparedFrame& first = prepared[usable.front()];
  first.frame.landmarks = start_landmarks(take, indices[usable.front()] == 0, observer);
  const GraspFit grasp = fit_grasp(hand, frames, fit_options, observer);

  Result result;
  result.take = take.info().name;
  result.side = hand_model.skeleton.side;
  result.model_name = hand_model.name;
  result.grasp_angles = grasp.angles;
  result.grasp_standard_deviations = grasp.standard_deviations;
  result.iterations = grasp.iterations;
  result.termination = termination_name(grasp.termination);
  for (std::size_t i = 0, next = 0; i < prepared.size(); ++i) {
    if (prepared[i].refusal.empty()) {
      result.frames.push_back(describe_frame(hand, grasp.poses[next++], prepared[i]));
    } else {
      ResultFrame frame;
      frame.name = prepared[i].name;
      frame.time = prepared[i].time;
      frame.status = prepared[i].refusal;
      result.frames.push_back(frame);
    }
  }
  result.seconds["segment"] = sum_of(prepared, &PreparedFrame::segment_seconds);
  result.seconds["hull"] = sum_of(prepared, &PreparedFrame::hull_seconds);
  result.seconds["frames"] = grasp.frame_seconds;
  result.seconds["all_frames"] = grasp.all_frames_seconds;
  return result;
}

}  // namespace tegata
