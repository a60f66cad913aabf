// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/gltf/hand_joints.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

#include "tegata/base/error.h"
#include "tegata/mesh/edge_sides.h"

namespace tegata {
namespace {

/// For each node its place in webxr_joints(), or -1.
std::vector<int> joints_by_name(const tinygltf::Model& model) {
  std::map<std::string_view, int> places;
  for (std::size_t i = 0; i < kWebxrJointCount; ++i) {
    places[webxr_joints()[i].name] = static_cast<int>(i);
  }
  std::vector<int> joints;
  for (const tinygltf::Node& node : model.nodes) {
    const auto found = places.find(node.name);
    joints.push_back(found == places.end() ? -1 : found->second);
  }
  return joints;
}

/// The skins by hand: those that share a joint with a WebXR name, in the order of the file.
std::vector<std::vector<std::size_t>> skins_by_hand(const tinygltf::Model& model,
                                                    const std::vector<int>& joint_of_node) {
  const std::size_t skin_count = model.skins.size();
  DisjointSets sets(skin_count + model.nodes.size());  // skins, then nodes
  std::vector<bool> has_joint(skin_count, false);
  for (std::size_t skin = 0; skin < skin_count; ++skin) {
    for (const int node : model.skins[skin].joints) {
      if (node < 0 || static_cast<std::size_t>(node) >= model.nodes.size()) {
        throw Error("skin ", skin, ": joint ", node, " is not among the file's ",
                    model.nodes.size(), " nodes");
      }
      if (joint_of_node[static_cast<std::size_t>(node)] < 0) continue;
      has_joint[skin] = true;
      sets.unite(static_cast<std::uint32_t>(skin),
                 static_cast<std::uint32_t>(skin_count) + static_cast<std::uint32_t>(node));
    }
  }
  std::map<std::uint32_t, std::vector<std::size_t>> by_root;  // a root is its set's first skin
  for (std::size_t skin = 0; skin < skin_count; ++skin) {
    if (has_joint[skin]) by_root[sets.root(static_cast<std::uint32_t>(skin))].push_back(skin);
  }
  std::vector<std::vector<std::size_t>> hands;
  for (auto& [root, skins] : by_root) hands.push_back(std::move(skins));
  return hands;
}

/// Finds joints that no skin uses.
void add_unskinned_joints(const NodeTree& tree, const std::vector<int>& joint_of_node,
                          const std::vector<bool>& is_skinned, HandJoints& hand) {
  std::vector<bool> is_below(joint_of_node.size(), false);
  for (const int node : hand.nodes) {
    if (node >= 0) is_below[static_cast<std::size_t>(node)] = true;
  }
  std::array<std::vector<int>, kWebxrJointCount> below, anywhere;
  for (const std::size_t node : tree.roots_first) {
    const int above = tree.parent[node];
    if (above >= 0 && is_below[static_cast<std::size_t>(above)]) is_below[node] = true;
    if (joint_of_node[node] < 0 || is_skinned[node]) continue;
    const auto joint = static_cast<std::size_t>(joint_of_node[node]);
    anywhere[joint].push_back(static_cast<int>(node));
    if (is_below[node]) below[joint].push_back(static_cast<int>(node));
  }
  for (std::size_t joint = 0; joint < hand.nodes.size(); ++joint) {
    if (hand.nodes[joint] >= 0) continue;
    if (below[joint].size() == 1) {
      hand.nodes[joint] = below[joint].front();
    } else if (anywhere[joint].size() == 1) {
      hand.nodes[joint] = anywhere[joint].front();
    }
  }
}

}  // namespace

std::vector<HandJoints> hands_in(const tinygltf::Model& model, const NodeTree& tree) {
  const std::vector<int> joint_of_node = joints_by_name(model);
  std::vector<HandJoints> complete;
  std::string missing = "there is no skin with a joint of such a name";
  std::size_t fewest = kWebxrJointCount + 1;
  std::vector<bool> is_skinned(model.nodes.size(), false);
  const auto hands = skins_by_hand(model, joint_of_node);
  for (const tinygltf::Skin& skin : model.skins) {
    for (const int node : skin.joints) is_skinned[static_cast<std::size_t>(node)] = true;
  }
  for (const std::vector<std::size_t>& skins : hands) {
    HandJoints hand;
    hand.nodes.fill(-1);
    hand.skins = skins;
    for (const std::size_t skin : skins) {
      for (const int node : model.skins[skin].joints) {
        const int joint = joint_of_node[static_cast<std::size_t>(node)];
        if (joint < 0) continue;
        int& known = hand.nodes[static_cast<std::size_t>(joint)];
        if (known >= 0 && known != node) {
          throw Error("skin ", skin, ": nodes ", known, " and ", node, " are both named ",
                      webxr_joints()[static_cast<std::size_t>(joint)].name);
        }
        known = node;
      }
    }
    add_unskinned_joints(tree, joint_of_node, is_skinned, hand);
    const auto absent =
        static_cast<std::size_t>(std::count(hand.nodes.begin(), hand.nodes.end(), -1));
    if (absent == 0) {
      complete.push_back(hand);
    } else if (absent < fewest) {
      fewest = absent;
      const auto first = std::find(hand.nodes.begin(), hand.nodes.end(), -1) - hand.nodes.begin();
      missing = text("skin ", skins.front(), " lacks ", absent, ", the first of them ",
                     webxr_joints()[static_cast<std::size_t>(first)].name);
    }
  }
  if (complete.empty()) {
    throw Error("expected a skin with the 25 joints of a WebXR hand, but ", missing);
  }
  return complete;
}

std::vector<int> bones_of_nodes(const HandJoints& hand, const NodeTree& tree) {
  std::vector<int> bones(tree.parent.size(), -1);
  for (std::size_t joint = 0; joint < hand.nodes.size(); ++joint) {
    bones[static_cast<std::size_t>(hand.nodes[joint])] = webxr_joints()[joint].bone;
  }
  for (const std::size_t node : tree.roots_first) {
    if (bones[node] >= 0) continue;
    const int above = tree.parent[node];
    bones[node] = above < 0 ? 0 : bones[static_cast<std::size_t>(above)];
  }
  return bones;
}

}  // namespace tegata
