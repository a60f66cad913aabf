// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "tegata/fit/fit_frame.h"
#include "tegata/fit/fit_hand.h"
#include "tegata/fit/solver.h"
#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// What stands before the hand without being seen itself: in infrared something cold. While the
/// grasp is fixed it is rigid in the hand's frame.
struct HiddenObject {
  TriangleMesh surface;           ///< in the hand's frame [m]; empty where nothing was found
  std::vector<float> confidence;  ///< one a vertex, 0 to 1: how much of what speaks of it is for it
};

struct HiddenObjectOptions {
  double voxel_size = 0.004;  ///< [m]
  double reach = 0.06;        ///< how far from the hand it is looked for [m]
  /// How far inside the drawn hand and outside the seen one a pixel must lie to be called hidden:
  /// so much the estimate may be off [px].
  double margin_px = 3.0;
  /// No pixel says more of what lies so near to the hand's surface [m].
  double skin = 0.003;
  /// At least so many pixels, of all frames' views, must speak for a voxel and none in so many
  /// against it.
  double least_blocked = 3.0, blocked_per_free = 8.0;
  /// 1 less the length of the mean direction of the rays that are blocked; rays that spread less
  /// tell less. Rays all over 45 degrees have 0.03.
  double least_spread = 0.03;
};

/// Carves what hides the hand from where the hand would be seen without it: a seen hand pixel
/// proves its ray free up to the hand, a pixel of the drawn hand that stays cold proves that
/// something stands on its ray. Pixels of all frames' views, taken into the hand's frame, vote on
/// voxels there; what was voted for and against by none or few is the object. It reaches no farther
/// than the hand's shadow does.
HiddenObject find_hidden_object(const FitHand& hand, std::span<const FitFrame* const> frames,
                                const HandEstimate& estimate, const HiddenObjectOptions& options,
                                int threads);

}  // namespace tegata
