// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "tegata/camera/camera.h"
#include "tegata/fit/fit_hand.h"
#include "tegata/fit/normal_equations.h"
#include "tegata/hand/hand_model.h"
#include "tegata/image/silhouette.h"

namespace tegata {

/// A camera's picture of the posed hand.
class HandPicture {
 public:
  HandPicture(const PosedHand& posed, const Camera& camera);
  /// 1 where the hand is, 0 beside it, bilinear between the pixels' centres.
  double cover(const Eigen::Vector2d& pixel) const;

 private:
  Silhouette silhouette_;
};

/// A short piece of the line on the posed hand where its surface turns away from a camera.
struct OutlinePiece {
  Triangle corners = {};  ///< of the triangle that it crosses
  /// Of the corners, in the piece's middle.
  Eigen::Vector3d fractions = Eigen::Vector3d::Zero();
  Eigen::Vector3d point = Eigen::Vector3d::Zero();   ///< its middle, world [m]
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();   ///< its middle
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();  ///< in the picture, unit, away from the hand
  double length_px = 0.0;
  /// Its length as far as it is the border of what the camera sees of the hand [px]: falls to
  /// nothing towards where other parts of the hand are before or behind it.
  double weight_px = 0.0;
  bool beyond_wrist = true;
};

/// The outline of the hand in a camera without distortion, sorted by the pixels' x. As the hand
/// moves, pieces shrink to nothing before they vanish and grow from nothing where they appear, so
/// that sums over the weights have no jumps but those of single pixels of the drawn hand.
std::vector<OutlinePiece> outline_pieces(const FitHand& hand, const PosedHand& posed,
                                         const Camera& camera, const HandPicture& drawn);

/// d (along . point) / d pose and angles.
HandRow outline_row(const PosedHand& posed, const OutlinePiece& piece,
                    const Eigen::RowVector3d& along);

}  // namespace tegata
