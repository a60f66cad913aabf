// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/landmark_term.h"

#include <utility>

namespace tegata {

void add_landmark_term(const FitHand& hand, const PosedHand& posed, const StartLandmarks& landmarks,
                       const LandmarkTermOptions& options, FrameEquations& equations) {
  const double deviation = options.standard_deviation * hand.scale;
  const double precision = options.weight / (deviation * deviation);
  for (const auto& [keypoint, landmark] :
       {std::pair(kWrist, landmarks.wrist), std::pair(kIndexMcp, landmarks.index_mcp),
        std::pair(kLittleMcp, landmarks.little_mcp)}) {
    const Eigen::Vector3d difference =
        posed.keypoints()[static_cast<std::size_t>(keypoint)] - landmark;
    const PointJacobian jacobian = posed.keypoint_jacobian(keypoint);
    for (int i = 0; i < 3; ++i) {
      equations.add(difference[i], ParameterRow(jacobian.row(i)), precision,
                    0.5 * precision * difference[i] * difference[i]);
    }
  }
}

}  // namespace tegata
