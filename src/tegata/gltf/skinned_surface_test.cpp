// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Hands of other makes: all that glTF allows and that write_hand_gltf does not do.
#include "tegata/gltf/skinned_surface.h"

#include <limits>

#include "tegata/gltf/accessor.h"
#include "tegata/gltf/gltf_for_tests.h"

namespace tegata {
namespace {

constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();

class OtherHands : public SmallGltfHand {
 protected:
  std::vector<float> numbers(int accessor, int components) const {
    const auto read = read_accessor(model_, accessor, components, "numbers");
    return {read.begin(), read.end()};
  }
  std::vector<float> attribute(const std::string& name, int components) {
    return numbers(primitive().attributes.at(name), components);
  }
  void set_attribute(const std::string& name, const std::vector<float>& values, int components) {
    primitive().attributes[name] = append_floats(model_, values, components, 0, name == "POSITION");
  }

  static Eigen::Matrix<double, kBoneCount, 1> by_bone(const SkinLinks& links) {
    Eigen::Matrix<double, kBoneCount, 1> weights = Eigen::Matrix<double, kBoneCount, 1>::Zero();
    for (std::size_t i = 0; i < links.bones.size(); ++i)
      weights[links.bones[i]] += links.weights[i];
    return weights;
  }

  /// Expects the vertices and links that were written.
  void expect_same(const HandModel& read) const {
    ASSERT_EQ(read.rest_surface.vertices.size(), hand_.rest_surface.vertices.size());
    for (std::size_t i = 0; i < read.links.size(); ++i) {
      EXPECT_LT((read.rest_surface.vertices[i] - hand_.rest_surface.vertices[i]).norm(), 1e-5);
      EXPECT_LT((by_bone(read.links[i]) - by_bone(hand_.links[i])).cwiseAbs().maxCoeff(), 1e-6);
    }
    EXPECT_EQ(read.rest_surface.triangles, hand_.rest_surface.triangles);
  }
};

TEST_F(OtherHands, WeightsThatDoNotSumToOneAreDivided) {
  std::vector<float> weights = attribute("WEIGHTS_0", 4);
  for (float& weight : weights) weight *= 3.5F;
  set_attribute("WEIGHTS_0", weights, 4);
  expect_same(read());
}

TEST_F(OtherHands, ASecondSetOfWeightsCounts) {
  std::vector<float> weights = attribute("WEIGHTS_0", 4), second(weights.size(), 0.0F);
  const std::vector<float> joints = attribute("JOINTS_0", 4);
  std::vector<std::uint8_t> second_joints(weights.size(), 0);
  for (std::size_t i = 0; i < weights.size(); i += 4) {
    std::swap(weights[i + 1], second[i]);
    second_joints[i] = static_cast<std::uint8_t>(joints[i + 1]);
  }
  set_attribute("WEIGHTS_0", weights, 4);
  set_attribute("WEIGHTS_1", second, 4);
  primitive().attributes["JOINTS_1"] = append_byte_quads(model_, second_joints);
  expect_same(read());
}

TEST_F(OtherHands, WithoutInverseBindMatricesVerticesAreInEachJointsFrame) {
  // All vertices on one joint, moved into its frame.
  const HandModel before = read();
  const auto tree = node_tree(model_);
  const Eigen::Matrix4d joint_from_world = tree.world[1].inverse(), world = tree.world[0];
  std::vector<float> places = attribute("POSITION", 3), weights = attribute("WEIGHTS_0", 4);
  for (std::size_t i = 0; i < places.size(); i += 3) {
    const Eigen::Vector4d place(places[i], places[i + 1], places[i + 2], 1.0);
    const Eigen::Vector4d moved = joint_from_world * (world * place);
    for (int axis = 0; axis < 3; ++axis) {
      places[i + static_cast<std::size_t>(axis)] = static_cast<float>(moved[axis]);
    }
  }
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = i % 4 == 0 ? 1.0F : 0.0F;
  set_attribute("POSITION", places, 3);
  set_attribute("WEIGHTS_0", weights, 4);
  primitive().attributes["JOINTS_0"] =
      append_byte_quads(model_, std::vector<std::uint8_t>(weights.size(), 0));
  model_.skins[0].inverseBindMatrices = -1;
  const HandModel after = read();
  for (std::size_t i = 0; i < after.links.size(); ++i) {
    EXPECT_LT((after.rest_surface.vertices[i] - before.rest_surface.vertices[i]).norm(), 1e-5);
    EXPECT_EQ(main_bone(after.links[i]), 0);
  }
}

// An armature in centimetres below a node that scales by 0.01, as converters leave it.
TEST_F(OtherHands, ScaledJointsAreWhereTheirScaledParentsPutThem) {
  model_.nodes[0].scale = {0.01, 0.01, 0.01};
  for (int i = 0; i < kWebxrJointCount; ++i) {
    for (double& way : joint(i).translation) way *= 100.0;
  }
  std::vector<float> inverse = numbers(model_.skins[0].inverseBindMatrices, 16);
  for (std::size_t i = 0; i < inverse.size(); ++i) {
    if (i % 4 < 3) inverse[i] *= 100.0F;
  }
  model_.skins[0].inverseBindMatrices = append_floats(model_, inverse, 16, 0, false);
  expect_same(read());
}

TEST_F(OtherHands, JointsOfOtherNamesMoveWithTheJointAbove) {
  // A twist joint between the index finger's first two, and the vertices of the second on it.
  constexpr int kProximal = 6, kMiddle = 7;
  const int twist = static_cast<int>(model_.nodes.size());
  model_.nodes.emplace_back();
  model_.nodes.back().name = "index-twist";
  model_.nodes.back().children = joint(kProximal).children;
  joint(kProximal).children = {twist};
  std::vector<float> inverse = numbers(model_.skins[0].inverseBindMatrices, 16);
  // It lies where the proximal joint does, so it has its inverse bind matrix.
  inverse.insert(inverse.end(), inverse.begin() + 16 * kProximal,
                 inverse.begin() + 16 * (kProximal + 1));
  model_.skins[0].inverseBindMatrices = append_floats(model_, inverse, 16, 0, false);
  model_.skins[0].joints.push_back(twist);
  std::vector<std::uint8_t> joints;
  for (const float number : attribute("JOINTS_0", 4)) {
    joints.push_back(number == kProximal ? kWebxrJointCount : static_cast<std::uint8_t>(number));
  }
  primitive().attributes["JOINTS_0"] = append_byte_quads(model_, joints);
  ASSERT_EQ(joint(kMiddle).name, "index-finger-phalanx-intermediate");
  expect_same(read());
}

TEST_F(OtherHands, MeshesOfSeveralSkinsOnTheSameJointsAreOneHand) {
  // Nails as a mesh of their own: half of the triangles, with a skin of fewer joints.
  std::vector<std::uint32_t> first, second;
  for (const float corner : numbers(primitive().indices, 1)) {
    auto& half = first.size() < 3 * hand_.rest_surface.triangles.size() / 2 ? first : second;
    half.push_back(static_cast<std::uint32_t>(corner));
  }
  primitive().indices = append_indices(model_, first);
  tinygltf::Mesh nails = model_.meshes[0];
  nails.primitives[0].indices = append_indices(model_, second);
  model_.meshes.push_back(nails);
  model_.skins.push_back(model_.skins[0]);
  model_.skins[1].joints.pop_back();  // the last tip, which moves no vertex
  tinygltf::Node node;
  node.mesh = node.skin = 1;
  model_.nodes.push_back(node);
  model_.scenes[0].nodes.push_back(static_cast<int>(model_.nodes.size()) - 1);
  expect_same(read());
}

TEST_F(OtherHands, VerticesOfNoTriangleAreLeftOut) {
  std::vector<float> places = attribute("POSITION", 3), weights = attribute("WEIGHTS_0", 4);
  std::vector<std::uint8_t> joints(weights.size() + 4, 0);
  const std::vector<float> old = attribute("JOINTS_0", 4);
  for (std::size_t i = 0; i < old.size(); ++i) joints[i] = static_cast<std::uint8_t>(old[i]);
  places.insert(places.end(), {5.0F, 5.0F, 5.0F});
  weights.insert(weights.end(), {1.0F, 0.0F, 0.0F, 0.0F});
  set_attribute("POSITION", places, 3);
  set_attribute("WEIGHTS_0", weights, 4);
  primitive().attributes["JOINTS_0"] = append_byte_quads(model_, joints);
  primitive().attributes.erase("NORMAL");
  expect_same(read());
}

TEST_F(OtherHands, AMirroredNodeTurnsTheSurfaceInsideOutAndItIsTurnedBack) {
  model_.nodes[0].scale = {-1.0, 1.0, 1.0};
  const HandModel mirror = read_plain(Side::left);
  EXPECT_GT(enclosed_volume(mirror.rest_surface), 0.0);
}

TEST_F(OtherHands, WeightsThatAreZeroNamesTheVertex) {
  std::vector<float> weights = attribute("WEIGHTS_0", 4);
  for (std::size_t i = 0; i < 4; ++i) weights[20 + i] = 0.0F;
  set_attribute("WEIGHTS_0", weights, 4);
  expect_refused([&] { read(); }, "changed.glb", "vertex 5 is bound to no joint");
}

TEST_F(OtherHands, WeightsThatAreNegativeInfiniteOrNotNumbers) {
  for (const float bad : {-0.5F, kNotANumber, std::numeric_limits<float>::infinity()}) {
    std::vector<float> weights = attribute("WEIGHTS_0", 4);
    weights[9] = bad;
    set_attribute("WEIGHTS_0", weights, 4);
    expect_refused([&] { read(); }, "changed.glb", "vertex 2 ", "0 to 1");
  }
}

TEST_F(OtherHands, JointNumbersBeyondTheSkin) {
  for (const float bad : {25.0F, -1.0F, 1e30F, kNotANumber}) {
    std::vector<float> joints = attribute("JOINTS_0", 4), weights = attribute("WEIGHTS_0", 4);
    joints[8] = bad;
    set_attribute("JOINTS_0", joints, 4);
    expect_refused([&] { read(); }, "changed.glb", "vertex 2 ", "25 joints");
  }
}

TEST_F(OtherHands, PositionsThatAreNotNumbers) {
  std::vector<float> places = attribute("POSITION", 3);
  places[10] = kNotANumber;
  set_attribute("POSITION", places, 3);
  model_.accessors.back().minValues = model_.accessors.back().maxValues = {0.0, 0.0, 0.0};
  expect_refused([&] { read(); }, "changed.glb", "vertex 3 ", "finite");
}

TEST_F(OtherHands, InverseBindMatricesThatAreTooFewOrNotNumbers) {
  std::vector<float> inverse = numbers(model_.skins[0].inverseBindMatrices, 16);
  inverse[18] = kNotANumber;
  model_.skins[0].inverseBindMatrices = append_floats(model_, inverse, 16, 0, false);
  expect_refused([&] { read(); }, "changed.glb", "joint 1 is not finite");
  inverse.resize(16);
  model_.skins[0].inverseBindMatrices = append_floats(model_, inverse, 16, 0, false);
  expect_refused([&] { read(); }, "changed.glb", "1 for 25 joints");
}

TEST_F(OtherHands, CornersBeyondTheVertices) {
  model_.accessors[static_cast<std::size_t>(primitive().attributes["POSITION"])].count = 5;
  expect_refused([&] { read(); }, "changed.glb", "not one a vertex");
  primitive().indices = append_indices(model_, {0, 1, 4'000'000'000U});
  model_.accessors[static_cast<std::size_t>(primitive().attributes["POSITION"])].count = 96;
  expect_refused([&] { read(); }, "changed.glb", "of 96 vertices");
}

TEST_F(OtherHands, AFewMeshesThatShareTheirBytesCannotFillTheMemory) {
  const tinygltf::Primitive one = primitive();
  model_.meshes[0].primitives.assign(6000, one);
  expect_refused([&] { read(); }, "changed.glb", "more than 2000000");
}

TEST_F(OtherHands, LinesAndPointsAreNoSurface) {
  primitive().mode = TINYGLTF_MODE_LINE;
  expect_refused([&] { read(); }, "changed.glb", "mode 1", "triangles");
}

TEST_F(OtherHands, AHandWithoutAMeshIsRefused) {
  model_.nodes[26].mesh = -1;
  expect_refused([&] { read(); }, "changed.glb", "no triangles");
}

}  // namespace
}  // namespace tegata
