// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/base/observer.h"
#include "tegata/fit/hand_tracker.h"
#include "tegata/hand/hand_model.h"
#include "tegata/pipeline/prepare_take.h"
#include "tegata/take/result.h"
#include "tegata/take/take.h"

namespace tegata {

struct TrackTakeOptions : PrepareOptions {
  TrackOptions track;
};

/// Follows the hand through a take as through a stream: each frame has the pose and the angles that
/// were known when it came, none is looked at again, and of none more is kept than what the result
/// says of it. Hulls are made of frames only in which the hand is sought. Frames in which it is
/// lost have no pose; that it was lost or found again is said to the observer. The result's grasp
/// is what was known at the end. Throws Error where no frame can be fitted.
Result track_take(Take& take, const HandModel& hand, const TrackTakeOptions& options,
                  const Observer& observer);

}  // namespace tegata
