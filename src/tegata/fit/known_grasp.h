// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/fit/frame_fit.h"
#include "tegata/math/rigid3d.h"
#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// The pose of a frame of a grasp that is known, from about where it is, by the terms of `schedule`
/// among what hides the hand: `object`, in the hand's frame, may be empty. The angles are held near
/// those of the start.
FrameFit fit_known(const FitHand& hand, const FitFrame& frame, const HandPose& start,
                   const TriangleMesh& object, const FitSchedule& schedule,
                   AngleDeviations deviations = kKnownDeviations);

/// The same from farther away. Twice: what stands about the hand is drawn where a fit begins, the
/// second time nearly where it ends.
FrameFit fit_known_from_afar(const FitHand& hand, const FitFrame& frame, const HandPose& start,
                             const TriangleMesh& object, const FitSchedule& schedule);

/// Where the hand would be if it went on as it went from one pose to the next.
Rigid3d extrapolated(const Rigid3d& before, const Rigid3d& last);

}  // namespace tegata
