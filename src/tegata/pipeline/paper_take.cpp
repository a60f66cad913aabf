// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/paper_take.h"

#include <utility>

#include "tegata/base/error.h"

namespace tegata {

std::vector<PaperFrame> paper_frames(const PreparedTake& take) {
  std::vector<PaperFrame> frames;
  for (std::size_t k = 0; k < take.size(); ++k) {
    frames.emplace_back(take.frame(k), take.frames().hull(take.usable()[k]));
  }
  return frames;
}

GraspFit fit_grasp_by_paper(const FitHand& hand, const PreparedTake& take,
                            const GraspFitOptions& options, const Observer& observer) {
  if (options.grasp == GraspConstraint::soft) {
    throw Error(
        "paper method: got a soft grasp, expected a fixed or a free one: the paper has no other");
  }
  PaperFitOptions paper_options;
  paper_options.grasp = options.grasp;
  paper_options.threads = options.threads;
  PaperFit fit = fit_paper(hand, paper_frames(take), paper_options, observer);
  GraspFit grasp;
  grasp.poses = std::move(fit.poses);
  grasp.left_out.resize(grasp.poses.size());
  grasp.angles = fit.angles;
  grasp.standard_deviations = fit.spread;
  grasp.iterations = fit.alternations;
  grasp.termination = fit.termination;
  grasp.frame_seconds = fit.frame_seconds;
  grasp.all_frames_seconds = fit.all_frames_seconds;
  return grasp;
}

}  // namespace tegata
