// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>

#include "tegata/hand/hand_model.h"

namespace tegata {

/// The hand's surface cut into one closed piece a bone, as rigid links need them: each triangle
/// goes with the bone that moves its corners most; pieces meet only at joints, where they are
/// closed towards the joint's centre, other holes towards their middle. At the hand's rest angles
/// the pieces are the hand again; here each lies where its bone is at zero angles, in the hand's
/// frame [m]. A piece is empty where no triangle goes with its bone. No normals.
std::array<TriangleMesh, kBoneCount> bone_pieces(const HandModel& hand);

/// Of a solid of even density.
struct MassProperties {
  double mass = 0.0;                                  ///< [kg]
  Eigen::Vector3d center = Eigen::Vector3d::Zero();   ///< of mass [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centre of mass [kg m^2]
};
/// Of what a closed surface encloses, `density` in kg/m^3: sums over the tetrahedra between its
/// triangles and one point.
MassProperties solid_mass(const TriangleMesh& surface, double density);
/// Of a ball.
MassProperties ball_mass(const Eigen::Vector3d& center, double mass, double density);

}  // namespace tegata
