// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/known_grasp.h"

#include <vector>

#include "tegata/fit/surroundings.h"

namespace tegata {

FrameFit fit_known(const FitHand& hand, const FitFrame& frame, const HandPose& start,
                   const TriangleMesh& object, const FitSchedule& schedule,
                   AngleDeviations deviations) {
  const FitFrame* const one[] = {&frame};
  const std::vector<FitFrame> surrounded =
      with_surroundings(hand, one, {start.angles, {start.world_from_hand}}, object, 1);
  return fit_frame(hand, surrounded.front(), start,
                   holding({schedule}, start.angles, deviations).front());
}

FrameFit fit_known_from_afar(const FitHand& hand, const FitFrame& frame, const HandPose& start,
                             const TriangleMesh& object, const FitSchedule& schedule) {
  const FrameFit first = fit_known(hand, frame, start, object, schedule);
  return fit_known(hand, frame, first.pose, object, schedule);
}

Rigid3d extrapolated(const Rigid3d& before, const Rigid3d& last) {
  return last * (before.inverse() * last);
}

}  // namespace tegata
