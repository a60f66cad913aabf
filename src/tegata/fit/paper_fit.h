// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// The method of K. Ogawara, K. Hashimoto, J. Takamatsu, K. Ikeuchi, "Grasp Recognition using a 3D
// Articulated Model and Infrared Images" (2003), sections IV and V, and nothing else: the visual
// hull alone, no contours, no priors. docs/paper.md maps the paper to these files.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "tegata/base/observer.h"
#include "tegata/fit/conjugate_gradient.h"
#include "tegata/fit/fit_frame.h"
#include "tegata/fit/fit_hand.h"
#include "tegata/fit/grasp_fit.h"
#include "tegata/mesh/closest_point.h"

namespace tegata {

/// One moment as the paper knows it: the surface of the visual hull. What exists only because a
/// pixel was unknown is cut out of it; `frame` gives landmarks and views for the start and must
/// outlive it. Throws Error where nothing of the hull is proven.
struct PaperFrame {
  PaperFrame(std::shared_ptr<const FitFrame> known, const TriangleMesh& hull);

  std::shared_ptr<const FitFrame> frame;
  NearestSurface surface;
};

struct PaperFitOptions {
  /// sigma of the Lorentzian (IV-A) [m, of a hand of FitHand::scale 1], from a start that is 1 to 2
  /// cm off down to the roughness of the hull; the energy settles at each before the next.
  std::vector<double> sigmas = {0.02, 0.01, 0.005};
  /// The energy has settled when p and theta in turn gain less than this share of it.
  double energy_tolerance = 2e-3;
  int most_alternations = 20;  ///< of p and theta, at each sigma
  ConjugateGradientOptions minimisation;
  GraspConstraint grasp = GraspConstraint::fixed;  ///< free: IV alone, without V
  int threads = 0;
};

/// One weight a bone, 0 to 1.
using BoneWeights = std::array<double, kBoneCount>;

struct PaperFit {
  std::vector<HandPose> single_poses;  ///< of each frame on its own (IV)
  std::vector<HandPose> poses;         ///< of all frames with one theta (V); else the same as those
  JointAngles angles;                  ///< theta; of free frames the mean
  JointAngles spread;                  ///< standard deviation of the single frames' angles [rad]
  /// Of each frame and bone the mean of the weights (1 + (z / sigma)^2 / 2)^-1 of its vertices,
  /// with the last sigma (the paper, figure 4): frames in which the object hides a bone have little
  /// say.
  std::vector<BoneWeights> weights;
  int alternations = 0;
  Termination termination = Termination::iteration_limit;
  double frame_seconds = 0.0, all_frames_seconds = 0.0;
};

/// E of IV-A over its vertices, their mean, by the pose p with theta fixed (`pose`: a turn about
/// the hand's centre [rad], a shift [hand's radii]) or by theta with p fixed.
struct PaperEnergy {
  const FitHand& hand;
  const PaperFrame& frame;
  double sigma;  ///< [m]

  EnergySlope by_pose(const HandPose& pose) const;
  EnergySlope by_angles(const HandPose& pose) const;
  HandPose moved(const HandPose& pose, const Eigen::VectorXd& step) const;
};

/// `frames` must not be empty; throws Error otherwise.
PaperFit fit_paper(const FitHand& hand, std::span<const PaperFrame> frames,
                   const PaperFitOptions& options, const Observer& observer);

}  // namespace tegata
