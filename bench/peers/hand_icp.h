// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hand_pairs.h"

namespace tegata::bench {

/// A hand's surface at rest: of each vertex its place, normal and weights.
struct FlatHand {
  std::vector<FlatPair> vertices;    ///< by part
  std::size_t part_end[kFlatParts];  ///< where each part's vertices end
};

/// Points with normals; three numbers each [m].
struct FlatHull {
  std::vector<double> points, normals;
};

/// How the hand is drawn to a hull: what was fastest of all that follows the hand.
struct IcpOptions {
  int most_rounds = 3;            ///< of nearest points and a fit to their planes
  int iterations_a_round = 1;     ///< of Ceres
  double settled = 1e-4;          ///< a round that moves no vertex by more is the last one [m]
  std::size_t samples = 600;      ///< of the hand and of the hull, that ask for the nearest point
  double sigma = 0.005;           ///< of the Lorentzian weight of a pair [m]
  double farthest = 0.03;         ///< no pair is farther apart [m]
  double deviation = 0.004;       ///< of all that the pairs say together, times the root of 30 [m]
  double angle_deviation = 0.02;  ///< of an angle from the frame before [rad]
};

/// Iterated closest points: nearest points both ways by nanoflann, planes and the change of the
/// angles by Ceres with derivatives in closed form. `pose` is a rotation vector and a shift from
/// where `motion_at` has its start; `previous_angles` hold the angles. Returns the rounds.
int fit_to_hull(const FlatHand& hand, const FlatMotionAt& motion_at, const FlatHull& hull,
                const IcpOptions& options, const double* previous_angles, double* pose,
                double* angles);

}  // namespace tegata::bench
