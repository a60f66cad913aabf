// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "tegata/gltf/node_tree.h"
#include "tegata/gltf/webxr_joints.h"

namespace tegata {

/// A hand in a file: the nodes of its joints and what is bound to them.
struct HandJoints {
  std::array<int, kWebxrJointCount> nodes;  ///< in the order of webxr_joints()
  std::vector<std::size_t> skins;
};

/// The hands whose 25 joints are all there. Skins that share a joint are of one hand; a joint that
/// no skin uses, as often a fingertip, is the node of that name below the hand's other joints, or
/// the file's only one. Throws Error where there is none, saying what is missing in the one that is
/// most complete, and where two joints of a hand have the same name.
std::vector<HandJoints> hands_in(const tinygltf::Model& model, const NodeTree& tree);

/// For each node the bone that moves it: that of the nearest of the hand's joints among the node
/// itself and those above, else the palm.
std::vector<int> bones_of_nodes(const HandJoints& hand, const NodeTree& tree);

}  // namespace tegata
