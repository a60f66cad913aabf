// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tegata/fit/fit_hand.h"
#include "tegata/fit/normal_equations.h"
#include "tegata/fit/shape_motion.h"
#include "tegata/hand/hand_model.h"
#include "tegata/mesh/closest_point.h"
#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// A visual hull made ready for closest-point queries.
struct HullTarget {
  /// The mesh needs normals; vertices marked as unproven attract nothing and are left out. Throws
  /// Error where none remain.
  explicit HullTarget(const TriangleMesh& hull);

  /// Where nobody knows whether the hull goes on: at the pictures' edges, and behind unknown
  /// pixels.
  std::vector<Eigen::Vector3d> unproven;
  std::vector<Eigen::Vector3d> normals;
  NearestPoint nearest;
  /// Points all over the surface, a few hundred: so many ask for the nearest one of the hand.
  std::vector<std::uint32_t> samples;
};

struct HullTermOptions {
  double sigma = 0.02;                ///< of the Lorentzian kernel [m]
  double standard_deviation = 0.004;  ///< of a hull vertex off the hand's surface [m]
  double weight = 1.0;                ///< of the whole term
};

/// The surface of the hull, both ways: for vertices of the hand the closest vertex of the hull
/// (3DTM; the paper, IV-A) and for vertices of the hull the closest one of the hand. The step
/// takes the distance to the tangent plane, the Lorentzian weight the distance of the points. Pairs
/// whose normals point apart are left out, as is the forearm. With a `shape`, equations are by that
/// as well.
void add_hull_term(const FitHand& hand, const PosedHand& posed, const HullTarget& hull,
                   const HullTermOptions& options, FrameEquations& equations,
                   const ShapeMotion* shape = nullptr);

}  // namespace tegata
