// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/gltf/hand_joints.h"

#include <limits>

#include "tegata/gltf/gltf_for_tests.h"

namespace tegata {
namespace {

using NodeTrees = SmallGltfHand;
using HandJointsIn = SmallGltfHand;

TEST_F(NodeTrees, MatricesAndTheirPartsPutANodeAtTheSamePlace) {
  const NodeTree parts = node_tree(model_);
  for (tinygltf::Node& node : model_.nodes) {
    Eigen::Affine3d local = Eigen::Affine3d::Identity();
    if (!node.translation.empty()) local.translate(Eigen::Vector3d(node.translation.data()));
    if (!node.rotation.empty()) local.rotate(Eigen::Quaterniond(node.rotation.data()));
    node.translation.clear();
    node.rotation.clear();
    node.matrix.assign(local.data(), local.data() + 16);
  }
  const NodeTree whole = node_tree(model_);
  for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
    EXPECT_LT((whole.world[i] - parts.world[i]).cwiseAbs().maxCoeff(), 1e-12) << i;
  }
}

TEST_F(NodeTrees, ACycleIsRefused) {
  joint(4).children = {1};  // the thumb's tip: the wrist
  model_.nodes[0].children.clear();
  expect_refused([&] { read(); }, "changed.glb", "its own ancestor");
}

TEST_F(NodeTrees, ANodeThatIsItsOwnChildIsRefused) {
  joint(4).children = {5};
  joint(3).children.clear();
  expect_refused([&] { read(); }, "changed.glb", "its own ancestor");
}

TEST_F(NodeTrees, ANodeWithTwoParentsIsRefused) {
  joint(4).children = {9};
  expect_refused([&] { read(); }, "changed.glb", "node 9 is a child of both");
}

TEST_F(NodeTrees, ChildrenThatAreNotThereAreRefused) {
  for (const int child : {-1, 1000}) {
    joint(4).children = {child};
    expect_refused([&] { node_tree(model_); }, "child " + std::to_string(child));
  }
}

TEST_F(NodeTrees, TransformsThatAreNotFiniteAreRefused) {
  joint(2).rotation = {0.0, 0.0, 0.0, 0.0};
  EXPECT_NO_THROW(node_tree(model_));  // Eigen leaves it as it is: no turn
  joint(2).translation = {0.0, std::numeric_limits<double>::quiet_NaN(), 0.0};
  expect_refused([&] { node_tree(model_); }, "node 3", "not finite");
}

// As deep as a file likes, without calling itself.
TEST_F(NodeTrees, AChainOfManyNodesIsRead) {
  constexpr int kLength = 200'000;
  model_.nodes.assign(kLength, tinygltf::Node());
  for (int i = 0; i + 1 < kLength; ++i) {
    model_.nodes[static_cast<std::size_t>(i)].children = {i + 1};
  }
  EXPECT_EQ(node_tree(model_).roots_first.size(), static_cast<std::size_t>(kLength));
}

TEST_F(HandJointsIn, TipsThatNoSkinUsesAreFoundByName) {
  for (const int tip : {4, 9, 14, 19, 24}) {
    auto& joints = model_.skins[0].joints;
    joints.erase(std::find(joints.begin(), joints.end(), 1 + tip));
  }
  const auto hands = hands_in(model_, node_tree(model_));
  ASSERT_EQ(hands.size(), 1U);
  for (int i = 0; i < kWebxrJointCount; ++i) {
    EXPECT_EQ(hands[0].nodes[static_cast<std::size_t>(i)], 1 + i);
  }
}

TEST_F(HandJointsIn, OfTwoHandsInAFileTheAskedOneIsRead) {
  // The left hand after the right one, in the same file.
  const std::size_t node_count = model_.nodes.size();
  const tinygltf::Model right = model_;
  for (tinygltf::Node node : right.nodes) {
    for (int& child : node.children) child += static_cast<int>(node_count);
    if (node.skin >= 0) node.skin = 1;
    model_.nodes.push_back(node);
  }
  model_.nodes[node_count].scale = {-1.0, 1.0, 1.0};
  model_.skins.push_back(right.skins[0]);
  for (int& joint : model_.skins[1].joints) joint += static_cast<int>(node_count);
  for (const int root : right.scenes[0].nodes) {
    model_.scenes[0].nodes.push_back(root + static_cast<int>(node_count));
  }
  ASSERT_EQ(hands_in(model_, node_tree(model_)).size(), 2U);
  const HandModel left = read_plain(Side::left), first = read_plain(Side::right);
  EXPECT_EQ(left.links.size(), hand_.links.size());
  EXPECT_LT(left.skeleton.keypoints[17].x(), 0.0);
  EXPECT_GT(first.skeleton.keypoints[17].x(), 0.0);
}

TEST_F(HandJointsIn, MissingJointsAreCountedAndNamed) {
  joint(19).name = "ring-finger-nail";
  joint(24).name = "";
  expect_refused([&] { read(); }, "changed.glb", "lacks 2", "ring-finger-tip");
}

TEST_F(HandJointsIn, AFileWithoutASkinIsRefused) {
  model_.skins.clear();
  expect_refused([&] { read(); }, "changed.glb", "25 joints", "no skin");
}

TEST_F(HandJointsIn, ANameThatTwoJointsHaveIsRefused) {
  joint(5).name = "wrist";
  expect_refused([&] { read(); }, "changed.glb", "both named wrist");
}

TEST_F(HandJointsIn, AJointBeyondTheNodesIsRefused) {
  for (const int node : {-1, 1000}) {
    model_.skins[0].joints[3] = node;
    expect_refused([&] { hands_in(model_, node_tree(model_)); }, "joint " + std::to_string(node));
  }
}

}  // namespace
}  // namespace tegata
