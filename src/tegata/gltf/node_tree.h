// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace tinygltf {
class Model;
}

namespace tegata {

/// How a file's nodes hang together, and where they are without its animations.
struct NodeTree {
  std::vector<int> parent;               ///< -1: none
  std::vector<Eigen::Matrix4d> world;    ///< world from node
  std::vector<std::size_t> roots_first;  ///< all nodes, each after its parent
};

/// Throws Error where a child is absent, has two parents or is its own ancestor, or where a
/// transform is not finite.
NodeTree node_tree(const tinygltf::Model& model);

}  // namespace tegata
