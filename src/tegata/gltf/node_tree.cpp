// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/gltf/node_tree.h"

#include <tiny_gltf.h>

#include <Eigen/Geometry>

#include "tegata/base/error.h"

namespace tegata {
namespace {

Eigen::Matrix4d local_matrix(const tinygltf::Node& node) {
  if (node.matrix.size() == 16) return Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (node.translation.size() == 3) {
    transform.translate(Eigen::Map<const Eigen::Vector3d>(node.translation.data()));
  }
  if (node.rotation.size() == 4) {
    transform.rotate(Eigen::Quaterniond(node.rotation.data()).normalized());
  }
  if (node.scale.size() == 3) {
    transform.scale(Eigen::Map<const Eigen::Vector3d>(node.scale.data()));
  }
  return transform.matrix();
}

std::vector<int> parents(const tinygltf::Model& model) {
  std::vector<int> parent(model.nodes.size(), -1);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    for (const int child : model.nodes[i].children) {
      if (child < 0 || static_cast<std::size_t>(child) >= parent.size()) {
        throw Error("node ", i, ": child ", child, " is not among the file's ", parent.size(),
                    " nodes");
      }
      int& above = parent[static_cast<std::size_t>(child)];
      if (above >= 0) throw Error("node ", child, " is a child of both ", above, " and ", i);
      above = static_cast<int>(i);
    }
  }
  return parent;
}

}  // namespace

NodeTree node_tree(const tinygltf::Model& model) {
  NodeTree tree;
  tree.parent = parents(model);
  tree.world.resize(model.nodes.size());
  std::vector<std::size_t>& order = tree.roots_first;
  std::vector<bool> is_reached(model.nodes.size(), false);
  const auto reach = [&](std::size_t node) {
    is_reached[node] = true;
    order.push_back(node);
  };
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    if (tree.parent[i] < 0) reach(i);
  }
  for (std::size_t done = 0; done < order.size(); ++done) {
    const std::size_t node = order[done];
    tree.world[node] = local_matrix(model.nodes[node]);
    if (const int above = tree.parent[node]; above >= 0) {
      tree.world[node] = tree.world[static_cast<std::size_t>(above)] * tree.world[node];
    }
    if (!tree.world[node].allFinite()) throw Error("node ", node, ": its transform is not finite");
    for (const int child : model.nodes[node].children) reach(static_cast<std::size_t>(child));
  }
  for (std::size_t i = 0; i < is_reached.size(); ++i) {
    if (!is_reached[i]) throw Error("node ", i, " is its own ancestor");
  }
  return tree;
}

}  // namespace tegata
