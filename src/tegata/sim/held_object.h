// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// A rigid thing to hold, in its own frame: its centre is the origin, a cylinder's axis is z.
struct HeldObject {
  enum class Shape { cylinder, sphere, block };
  Shape shape = Shape::sphere;
  /// Half its size along each axis [m]. A sphere has three times its radius, a cylinder twice its
  /// radius and then half its length.
  Eigen::Vector3d half_size = Eigen::Vector3d::Ones();
};

/// The distance [m] of a point to the object's surface, negative inside. Exact.
double signed_distance(const HeldObject& object, const Eigen::Vector3d& point_in_object);

/// The surface, closed, without normals, no edge longer than `longest_edge` [m]: a camera that
/// draws straight edges between projected corners needs small triangles.
TriangleMesh object_surface(const HeldObject& object, double longest_edge);

}  // namespace tegata
