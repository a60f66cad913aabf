// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/fit_take.h"

#include "tegata/base/error.h"
#include "tegata/base/parallel.h"
#include "tegata/hand/scaled_hand.h"
#include "tegata/pipeline/check_calibration.h"
#include "tegata/pipeline/describe_frame.h"
#include "tegata/pipeline/in_world.h"
#include "tegata/pipeline/paper_take.h"
#include "tegata/pipeline/size_hand.h"

namespace tegata {
namespace {

double sum_of(const FrameStore& frames, double PreparedFrame::*seconds) {
  double sum = 0.0;
  for (std::size_t i = 0; i < frames.size(); ++i) sum += frames.brief(i).*seconds;
  return sum;
}

// A frame without the views that contradicted its others.
PreparedFrame without(PreparedFrame frame, const std::vector<std::string>& cameras) {
  for (const std::string& camera : cameras) {
    frame.left_out[camera] = "it contradicts the other cameras";
    std::erase_if(frame.frame.views,
                  [&camera](const FitView& view) { return view.camera.name == camera; });
  }
  return frame;
}

}  // namespace

Result fit_take(Take& take, const HandModel& hand_model, const FitTakeOptions& options,
                const Observer& observer) {
  check_hand(hand_model);
  const PreparedTake prepared = prepare_checked_take(take, options, observer);
  GraspFitOptions fit_options = options.fit;
  fit_options.threads = options.threads;
  fit_options.joint.hull = in_scene(options.hull, prepared.scene());
  Result result;
  double scale_in_scene = 1.0;
  if (!options.scale) {
    const FrameSource* const takes[] = {&prepared};
    const SizedHand sized = size_hand(hand_model, takes, fit_options, observer);
    scale_in_scene = sized.scale.scale;
    result.model_scale_standard_deviation = sized.scale.standard_deviation;
    result.seconds["scale"] = sized.seconds;
  }
  const HandModel fitted_model = scaled(hand_model, scale_in_scene);
  const FitHand hand(fitted_model);
  const GraspFit grasp = options.method == FitMethod::paper
                             ? fit_grasp_by_paper(hand, prepared, fit_options, observer)
                             : fit_grasp(hand, prepared, fit_options, observer);

  result.take = take.info().name;
  result.side = hand_model.skeleton.side;
  result.model_name = hand_model.name;
  result.model_scale = options.scale.value_or(scale_in_scene);
  result.grasp_angles = grasp.angles;
  result.grasp_standard_deviations = grasp.standard_deviations;
  result.object = grasp.object.surface;
  result.object_confidence = grasp.object.confidence;
  if (grasp.start) {
    const std::size_t f = prepared.usable()[grasp.start->frame];
    result.start = {prepared.frames().brief(f).name, grasp.start->lead};
  }
  result.iterations = grasp.iterations;
  result.termination = termination_name(grasp.termination);
  for (std::size_t f = 0; f < prepared.frames().size(); ++f) {
    const PreparedFrame& from = prepared.frames().brief(f);
    result.frames.push_back(describe_missing(from, from.refusal));
  }
  parallel_for(prepared.size(), options.threads, [&](std::size_t k) {
    const std::size_t f = prepared.usable()[k];
    result.frames[f] = describe_frame(hand, grasp.poses[k],
                                      without(prepared.frames().restored(f), grasp.left_out[k]));
  });
  result.seconds["segment"] = sum_of(prepared.frames(), &PreparedFrame::segment_seconds);
  result.seconds["hull"] = sum_of(prepared.frames(), &PreparedFrame::hull_seconds);
  result.seconds["frames"] = grasp.frame_seconds;
  result.seconds["all_frames"] = grasp.all_frames_seconds;
  return in_world(prepared.scene(), std::move(result));
}

}  // namespace tegata
