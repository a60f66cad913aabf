// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "tegata/fit/normal_equations.h"

namespace tegata {

/// The normal equations of frames with one set of angles.
struct GraspEquations {
  std::vector<FrameEquations> frames;
  FrameEquations prior;  ///< of the angles
};

/// A step of all grasps' poses and angles; of each the shape's is the same.
struct ShapeStep {
  std::vector<ArrowStep> grasps;
  Eigen::VectorXd shape;
};

/// Normal equations of several grasps of one hand whose shape is sought: an arrow of arrows. Poses
/// are eliminated from each grasp's, then its angles, and what is left for the shape is summed.
class ShapeSystem {
 public:
  /// `prior_precision` and `prior_gradient` are of the shape's own, independent residuals.
  ShapeSystem(const std::vector<GraspEquations>& grasps, const Eigen::VectorXd& prior_precision,
              const Eigen::VectorXd& prior_gradient);

  /// Solves (H + damping diag(H)) step = -g.
  ShapeStep solve(double damping) const;
  /// The covariance of the shape with poses and angles free, up to the scale of the residuals.
  Eigen::MatrixXd covariance() const;

 private:
  std::vector<ArrowSystem> grasps_;
  Eigen::VectorXd prior_precision_, prior_gradient_;
};

}  // namespace tegata
