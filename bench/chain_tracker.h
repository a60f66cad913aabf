// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "flat.h"
#include "hand_stream.h"
#include "pair_fit.h"
#include "peers/hand_icp.h"

namespace tegata::bench {

/// Follows the hand of a stream by public parts: the naive loop over a cube about the hand,
/// FlyingEdges, meshoptimizer or every so manieth vertex, then nearest points and fits to their
/// planes in turns.
class ChainTracker {
 public:
  /// Takes over what it needs of the stream in its own form, which must outlive it.
  ChainTracker(const HandStream& stream, bool simplifies);

  /// What the stream's frames but the first one are: from the first one's true pose on.
  struct Run {
    double keypoint_error = 0.0;  ///< mean [m]
    double rounds = 0.0;          ///< of nearest points a frame
    double hull_seconds = 0.0, fit_seconds = 0.0;
  };
  Run run(int threads);

  IcpOptions icp;

 private:
  FlatHull hull(std::size_t frame, const Eigen::Vector3d& center, int threads);
  Eigen::Vector3d center_of(const HandPose& pose);
  HandPose followed(const HandPose& expected, const JointAngles& before, const FlatHull& hull,
                    double& rounds);

  const HandStream& stream_;
  bool simplifies_;
  std::vector<std::vector<FlatView>> frames_;
  PairFit pair_fit_;
  FlatHand hand_;
  std::vector<std::uint8_t> inside_;
};

}  // namespace tegata::bench
