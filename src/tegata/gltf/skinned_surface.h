// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "tegata/gltf/hand_joints.h"
#include "tegata/gltf/node_tree.h"
#include "tegata/gltf/webxr_joints.h"
#include "tegata/hand/hand_model.h"
#include "tegata/mesh/triangle_mesh.h"

namespace tinygltf {
class Model;
}

namespace tegata {

/// What a glTF file says of a hand, in the file's world frame [m].
struct SkinnedSurface {
  std::array<Eigen::Vector3d, kWebxrJointCount> joints;
  TriangleMesh surface;
  std::vector<SkinLinks> links;
};

/// Where the nodes of the file put a hand's joints and every mesh that is bound to one of its
/// skins. Joints of other names move with the nearest ancestor that has one, else with the palm;
/// weights need not sum to 1. Vertices that lie on each other (where texture coordinates split) are
/// joined, those of no triangle left out; triangles turned inside out by a mirroring transform are
/// turned back; there are no normals. Throws Error saying what is missing or out of range.
SkinnedSurface skinned_surface(const tinygltf::Model& model, const NodeTree& tree,
                               const HandJoints& hand);

}  // namespace tegata
