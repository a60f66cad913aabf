// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/built_in_hand.h"

#include "tegata/base/error.h"
#include "tegata/hand/hand_solid.h"
#include "tegata/hand/skin_links.h"
#include "tegata/hull/marching_cubes.h"
#include "tegata/hull/octree.h"
#include "tegata/mesh/simplify.h"

namespace tegata {
namespace {

TriangleMesh meshed(const HandSolid& solid, const BuiltInHandOptions& options) {
  FieldSource source;
  // The field is not steeper than 1, so half a cube's diagonal bounds it over the cube.
  source.classify = [&](const Eigen::AlignedBox3d& cube) {
    const double field = solid.field(cube.center());
    const double reach = 0.5 * cube.diagonal().norm() * (1.0 + 1e-6);
    if (field > reach) return Occupancy::inside;
    return field < -reach ? Occupancy::outside : Occupancy::mixed;
  };
  source.sample = [&](const Eigen::Vector3d& point, bool&) {
    return static_cast<float>(solid.field(point));
  };
  const TriangleMesh fine =
      extract_isosurface(build_octree(solid.box(), options.cell_size, source));
  return simplify(fine, options.triangle_count);
}

}  // namespace

HandModel built_in_hand(const HandShape& shape, Side side, const BuiltInHandOptions& options) {
  if (!(options.cell_size >= 0.0005 && options.cell_size <= 0.005)) {
    throw Error("built-in hand: cell_size is ", options.cell_size, " m, expected 0.0005 to 0.005");
  }
  HandModel model;
  model.name = "built-in";
  model.skeleton = right_skeleton(shape);
  model.rest_angles = meshing_angles(shape);
  model.rest_surface = meshed(HandSolid(shape, model.skeleton, model.rest_angles), options);
  const BoneSegments segments = bone_segments(model.skeleton, model.rest_angles,
                                              shape.forearm_length, 0.35 * shape.palm_breadth);
  model.links.reserve(model.rest_surface.vertices.size());
  for (const Eigen::Vector3d& vertex : model.rest_surface.vertices) {
    model.links.push_back(link_to_bones(segments, vertex));
  }
  check_hand(model);
  return side == Side::right ? model : mirrored(model);
}

}  // namespace tegata
