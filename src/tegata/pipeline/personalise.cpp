// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/personalise.h"

#include "tegata/base/error.h"
#include "tegata/base/stopwatch.h"
#include "tegata/hand/scaled_hand.h"
#include "tegata/pipeline/size_hand.h"

namespace tegata {

PersonalHand personalise(std::span<Take> takes, Side side, const PersonaliseOptions& options,
                         const Observer& observer) {
  if (takes.empty()) throw Error("personalise: got no take, expected at least one");
  const Stopwatch stopwatch;
  PersonalHand person;
  std::vector<PreparedTake> prepared;
  for (Take& take : takes) {
    prepared.push_back(prepare_take(take, options, observer));
    person.frame_count += prepared.back().size();
  }
  std::vector<const FrameSource*> sources;
  for (const PreparedTake& take : prepared) sources.push_back(&take);
  const ShapedHand shapes(side);
  GraspFitOptions fit_options = options.fit;
  fit_options.threads = options.threads;
  const SizedHand sized = size_hand(shapes.model(HandShape()), sources, fit_options, observer);
  person.scale = sized.scale;
  // What hides the hand is known from here on, as far as a hand of the right size shows it.
  const HandModel hand = scaled(shapes.model(HandShape()), sized.scale.scale);
  KeptGrasps kept;
  for (const PreparedTake& take : prepared) {
    kept.add(fit_grasp(FitHand(hand), take, fit_options, observer), take, fit_options.grasp);
  }
  observer.progress("shape", 0, 1);
  ShapeFitOptions shape_options;
  shape_options.threads = options.threads;
  ShapeParameters start = shape_prior().mean;
  start[0] *= sized.scale.scale;
  person.fit = fit_shape(shapes, start, kept.grasps, shape_options);
  observer.progress("shape", 1, 1);
  person.seconds = stopwatch.seconds();
  return person;
}

}  // namespace tegata
