// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "tegata/fit/fit_hand.h"
#include "tegata/fit/normal_equations.h"
#include "tegata/hand/hand_model.h"

namespace tegata {

/// Three landmarks in world coordinates [m], rough (1-2 cm) is enough.
struct StartLandmarks {
  Eigen::Vector3d wrist, index_mcp, little_mcp;
};

struct LandmarkTermOptions {
  double standard_deviation = 0.015;  ///< of each coordinate [m]
  double weight = 1.0;                ///< of the whole term
};

/// Keeps the wrist and the outer knuckles near rough landmarks, so that a hull that lacks the
/// fingers cannot pull the hand along the forearm.
void add_landmark_term(const FitHand& hand, const PosedHand& posed, const StartLandmarks& landmarks,
                       const LandmarkTermOptions& options, FrameEquations& equations);

}  // namespace tegata
