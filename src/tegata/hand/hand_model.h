// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "tegata/hand/skeleton.h"
#include "tegata/math/rigid3d.h"
#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// Which bones move a vertex and how much each; unused entries have weight 0, weights sum to 1.
struct SkinLinks {
  std::array<int, 4> bones = {};
  std::array<double, 4> weights = {};
};

/// A hand of given size: skeleton, surface and what ties the one to the other. Fixed once made.
struct HandModel {
  std::string name;
  Skeleton skeleton;
  JointAngles rest_angles = JointAngles::Zero();  ///< at which the surface is given
  TriangleMesh rest_surface;                      ///< in the hand's frame [m], with normals
  std::vector<SkinLinks> links;                   ///< one a vertex
};

/// Where a hand is and how it is bent.
struct HandPose {
  Rigid3d world_from_hand;
  JointAngles angles = JointAngles::Zero();
};

/// The other hand: surface mirrored and turned right side out again.
HandModel mirrored(const HandModel& model);

/// Throws Error naming what does not fit: links or normals that are not one a vertex, weights that
/// are negative or do not sum to 1, a surface without triangles, axes that are not unit vectors,
/// numbers that are not finite.
void check_hand(const HandModel& model);

/// The bone that moves a vertex most.
int main_bone(const SkinLinks& links);

/// The 21 keypoints in world coordinates.
std::array<Eigen::Vector3d, kKeypointCount> posed_keypoints(const Skeleton& skeleton,
                                                            const HandPose& pose);

/// 3 x 26: by rotation (turn about the hand's origin, world axes), translation (world) and angles.
using PointJacobian = Eigen::Matrix<double, 3, kHandParameterCount>;

/// The pose after a step of the 26 parameters: rotation exp(step 0..2) from the left, translation
/// and angles added.
HandPose advanced(const HandPose& pose, const Eigen::Matrix<double, kHandParameterCount, 1>& step);

class SkinRows;
class PosedRows;

/// A hand model put into a pose: world vertices and normals by linear blend skinning (with two
/// links a vertex the weighted interior division of the paper, III-B-2), and their derivatives.
class PosedHand {
 public:
  /// Keeps a reference to the model, which must outlive it. Who poses a model often makes its
  /// SkinRows once and hands them in.
  PosedHand(const HandModel& model, const HandPose& pose,
            std::shared_ptr<const SkinRows> rows = nullptr);

  const HandModel& model() const { return *model_; }
  const HandPose& pose() const { return pose_; }
  const std::vector<Eigen::Vector3d>& vertices() const { return vertices_; }
  const std::vector<Eigen::Vector3d>& normals() const { return normals_; }
  const std::array<Eigen::Vector3d, kKeypointCount>& keypoints() const { return keypoints_; }
  /// Vertices, normals and their derivatives in the order in which loops over all of them are
  /// fast.
  const PosedRows& rows() const { return *rows_; }
  /// The surface in world coordinates, with normals.
  TriangleMesh surface() const;
  /// d vertex / d parameters.
  PointJacobian vertex_jacobian(std::size_t vertex) const;
  /// d normal / d parameters.
  PointJacobian normal_jacobian(std::size_t vertex) const;
  /// d keypoint / d parameters.
  PointJacobian keypoint_jacobian(int keypoint) const;

 private:
  const HandModel* model_;
  HandPose pose_;
  std::shared_ptr<const PosedRows> rows_;
  std::vector<Eigen::Vector3d> vertices_;
  std::vector<Eigen::Vector3d> normals_;
  std::array<Eigen::Vector3d, kKeypointCount> keypoints_;
};

}  // namespace tegata
