// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "peers/hand_pairs.h"
#include "tegata/fit/solver.h"
#include "tegata/fit/surface_pairs.h"

namespace tegata::bench {

/// A grasping hand in some frames with planes that draw its vertices, and a start that is off.
struct PairFit {
  HandModel model;
  std::shared_ptr<const SkinRows> rows;
  std::vector<std::vector<SurfacePair>> frames;
  HandEstimate start;
  int iterations = 0;
};

/// Of each frame so many vertices, at random, with the planes of the true surface a millimetre off.
/// The start has angles off by 6 degrees, poses by 9 degrees and 10 mm.
PairFit make_pair_fit(std::size_t frame_count, std::size_t pairs_a_frame);

/// The same for the peers; refers to `fit`.
FlatFit flat_fit(const PairFit& fit);

struct FitEnd {
  HandEstimate estimate;
  int steps = 0;  ///< that lowered the cost
};
/// So many damped Gauss-Newton steps as the options say, whether they gain or not.
FitEnd run_pair_fit(const PairFit& fit);
/// The same residual by residual, in double precision: what the fit has where pairs are few.
FitEnd run_plainly(const PairFit& fit);

/// Half the sum of the weighted squares at an estimate, in double precision.
double cost_of(const PairFit& fit, const HandEstimate& estimate);

}  // namespace tegata::bench
