// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/gltf/hand_gltf.h"

#include <gtest/gtest.h>
#include <tiny_gltf.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "tegata/base/error.h"
#include "tegata/base/random.h"
#include "tegata/gltf/accessor.h"
#include "tegata/gltf/webxr_joints.h"
#include "tegata/hand/built_in_hand.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

/// A folder that is gone after the test.
class HandGltf : public testing::Test {
 protected:
  HandGltf()
      : folder_(std::filesystem::temp_directory_path() /
                ("tegata_gltf_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~HandGltf() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path file(const std::string& name) const { return folder_ / name; }

 private:
  std::filesystem::path folder_;
};

const HandModel& hand(Side side) {
  static const HandModel right = built_in_hand(HandShape(), Side::right);
  static const HandModel left = mirrored(right);
  return side == Side::right ? right : left;
}

tinygltf::Model load(const std::filesystem::path& file) {
  tinygltf::TinyGLTF loader;
  tinygltf::Model model;
  std::string error, warning;
  const bool is_binary = file.extension() == ".glb";
  EXPECT_TRUE(is_binary ? loader.LoadBinaryFromFile(&model, &error, &warning, file.string())
                        : loader.LoadASCIIFromFile(&model, &error, &warning, file.string()))
      << error;
  EXPECT_EQ(warning, "");
  return model;
}

void save(tinygltf::Model& model, const std::filesystem::path& file) {
  tinygltf::TinyGLTF writer;
  ASSERT_TRUE(writer.WriteGltfSceneToFile(&model, file.string(), true, true, false, true));
}

std::vector<HandKeyframe> some_keyframes() {
  std::vector<HandKeyframe> keyframes(4);
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    const double part = static_cast<double>(i) / 3.0;
    keyframes[i].time = 0.1 * static_cast<double>(i);
    keyframes[i].pose.world_from_hand = {so3_exp({2.5 * part, 1.0, -2.0 * part}),
                                         {0.1 * part, -0.2, 0.9}};
    keyframes[i].pose.angles = part * angle_limits().upper + (1.0 - part) * relaxed_angles();
  }
  return keyframes;
}

/// A node's transform with what the animation has at a keyframe.
Eigen::Affine3d local_at(const tinygltf::Model& model, int node, std::size_t keyframe) {
  const tinygltf::Node& described = model.nodes[static_cast<std::size_t>(node)];
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  if (!described.translation.empty()) {
    place = Eigen::Map<const Eigen::Vector3d>(described.translation.data());
  }
  if (!described.rotation.empty()) turn = Eigen::Quaterniond(described.rotation.data());
  for (const tinygltf::AnimationChannel& channel : model.animations[0].channels) {
    if (channel.target_node != node) continue;
    const int output =
        model.animations[0].samplers[static_cast<std::size_t>(channel.sampler)].output;
    const bool is_turn = channel.target_path == "rotation";
    const std::vector<double> numbers = read_accessor(model, output, is_turn ? 4 : 3, "output");
    if (is_turn) {
      turn = Eigen::Quaterniond(&numbers[4 * keyframe]);
    } else {
      place = Eigen::Map<const Eigen::Vector3d>(&numbers[3 * keyframe]);
    }
  }
  return Eigen::Translation3d(place) * turn.normalized();
}

Eigen::Affine3d world_at(const tinygltf::Model& model, int node, std::size_t keyframe) {
  Eigen::Affine3d world = local_at(model, node, keyframe);
  for (std::size_t above = 0; above < model.nodes.size(); ++above) {
    for (const int child : model.nodes[above].children) {
      if (child == node) return world_at(model, static_cast<int>(above), keyframe) * world;
    }
  }
  return world;
}

/// From OpenCV's axes to glTF's.
Eigen::Vector3d y_up(const Eigen::Vector3d& point) { return {point.x(), -point.y(), -point.z()}; }

TEST_F(HandGltf, RoundTripKeepsTheHand) {
  for (const Side side : {Side::right, Side::left}) {
    for (const char* name : {"hand.glb", "hand.gltf"}) {
      const HandModel& written = hand(side);
      write_hand_gltf(written, {}, file(name));
      const HandModel read = read_hand_gltf(file(name), side);
      EXPECT_EQ(read.name, "hand");
      EXPECT_EQ(read.rest_surface.triangles, written.rest_surface.triangles);
      ASSERT_EQ(read.rest_surface.vertices.size(), written.rest_surface.vertices.size());
      for (std::size_t i = 0; i < read.links.size(); ++i) {
        EXPECT_LT((read.rest_surface.vertices[i] - written.rest_surface.vertices[i]).norm(), 1e-6);
        EXPECT_EQ(main_bone(read.links[i]), main_bone(written.links[i]));
        EXPECT_NEAR(read.links[i].weights[0], written.links[i].weights[0], 1e-6);
      }
      for (std::size_t k = 0; k < kKeypointCount; ++k) {
        EXPECT_LT((read.skeleton.keypoints[k] - written.skeleton.keypoints[k]).norm(), 1e-9);
      }
      for (std::size_t a = 0; a < kAngleCount; ++a) {
        EXPECT_LT((read.skeleton.axes[a] - written.skeleton.axes[a]).norm(), 1e-9);
      }
      EXPECT_LT((read.rest_angles - written.rest_angles).cwiseAbs().maxCoeff(), 1e-9);
    }
  }
}

// As a file from elsewhere: nothing but nodes, skin and mesh.
TEST_F(HandGltf, WithoutNotesTheRestPoseIsStillThatOfTheFile) {
  for (const Side side : {Side::right, Side::left}) {
    const HandModel& written = hand(side);
    write_hand_gltf(written, {}, file("hand.glb"));
    tinygltf::Model model = load(file("hand.glb"));
    model.asset.extras = tinygltf::Value();
    save(model, file("plain.glb"));
    const HandModel read = read_hand_gltf(file("plain.glb"), side);
    const auto expected = posed_keypoints(written.skeleton, {Rigid3d(), written.rest_angles});
    const auto got = posed_keypoints(read.skeleton, {Rigid3d(), read.rest_angles});
    const Rigid3d written_from_read =
        align_points(Eigen::Map<const Eigen::Matrix3Xd>(got[0].data(), 3, kKeypointCount),
                     Eigen::Map<const Eigen::Matrix3Xd>(expected[0].data(), 3, kKeypointCount));
    for (std::size_t k = 0; k < kKeypointCount; ++k) {
      EXPECT_LT((written_from_read * got[k] - expected[k]).norm(), 1e-5);
    }
    for (std::size_t i = 0; i < read.links.size(); ++i) {
      EXPECT_LT(
          (written_from_read * read.rest_surface.vertices[i] - written.rest_surface.vertices[i])
              .norm(),
          1e-5);
    }
    // The palm's frame is made anew from the knuckles and turns by some degrees.
    EXPECT_LT((read.rest_angles - written.rest_angles).cwiseAbs().maxCoeff(), 0.15);
    EXPECT_LT(written_from_read.rotation.angularDistance(Eigen::Quaterniond::Identity()), 0.1);
  }
}

TEST_F(HandGltf, AnimationPutsTheJointsWhereThePosesDo) {
  const std::vector<HandKeyframe> keyframes = some_keyframes();
  for (const Side side : {Side::right, Side::left}) {
    write_hand_gltf(hand(side), keyframes, file("take.glb"));
    const tinygltf::Model model = load(file("take.glb"));
    ASSERT_EQ(model.animations.size(), 1U);
    const int input = model.animations[0].samplers[0].input;
    const std::vector<double> times = read_accessor(model, input, 1, "times");
    ASSERT_EQ(times.size(), keyframes.size());
    for (std::size_t frame = 0; frame < keyframes.size(); ++frame) {
      EXPECT_NEAR(times[frame], keyframes[frame].time, 1e-6);
      const auto expected = posed_keypoints(hand(side).skeleton, keyframes[frame].pose);
      for (std::size_t j = 0; j < kWebxrJointCount; ++j) {
        const int keypoint = webxr_joints()[j].keypoint;
        if (keypoint < 0) continue;
        const Eigen::Vector3d got = world_at(model, model.skins[0].joints[j], frame).translation();
        EXPECT_LT((got - y_up(expected[static_cast<std::size_t>(keypoint)])).norm(), 1e-5)
            << webxr_joints()[j].name;
      }
    }
  }
}

TEST_F(HandGltf, AnimationBendsTheSurfaceAsThePosesDo) {
  const std::vector<HandKeyframe> keyframes = some_keyframes();
  const HandModel& model = hand(Side::right);
  write_hand_gltf(model, keyframes, file("take.glb"));
  const tinygltf::Model written = load(file("take.glb"));
  const tinygltf::Skin& skin = written.skins[0];
  const auto& attributes = written.meshes[0].primitives[0].attributes;
  const auto inverse = read_accessor(written, skin.inverseBindMatrices, 16, "inverse");
  const auto joints = read_accessor(written, attributes.at("JOINTS_0"), 4, "joints");
  const auto weights = read_accessor(written, attributes.at("WEIGHTS_0"), 4, "weights");
  const auto places = read_accessor(written, attributes.at("POSITION"), 3, "positions");
  for (std::size_t frame = 0; frame < keyframes.size(); ++frame) {
    std::vector<Eigen::Matrix4d> matrices;
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
      matrices.push_back(world_at(written, skin.joints[j], frame).matrix() *
                         Eigen::Map<const Eigen::Matrix4d>(&inverse[16 * j]));
    }
    const PosedHand posed(model, keyframes[frame].pose);
    for (std::size_t i = 0; i < posed.vertices().size(); ++i) {
      const Eigen::Vector4d place(places[3 * i], places[3 * i + 1], places[3 * i + 2], 1.0);
      Eigen::Vector4d got = Eigen::Vector4d::Zero();
      for (std::size_t j = 0; j < 4; ++j) {
        got += weights[4 * i + j] * (matrices[static_cast<std::size_t>(joints[4 * i + j])] * place);
      }
      ASSERT_LT((got.head<3>() - y_up(posed.vertices()[i])).norm(), 1e-5) << i;
    }
  }
}

TEST_F(HandGltf, AnimatedFileIsReadInItsRestPose) {
  write_hand_gltf(hand(Side::right), some_keyframes(), file("take.glb"));
  const HandModel read = read_hand_gltf(file("take.glb"), Side::right);
  EXPECT_LT((read.rest_surface.vertices[7] - hand(Side::right).rest_surface.vertices[7]).norm(),
            1e-6);
}

// The joints of the WebXR generic hand are a flat list, in another order for each side.
TEST_F(HandGltf, JointsMayComeInAnyOrderAndHierarchy) {
  write_hand_gltf(hand(Side::right), some_keyframes(), file("hand.glb"));
  tinygltf::Model model = load(file("hand.glb"));
  std::vector<Eigen::Affine3d> rest;  // world transforms without the animation
  tinygltf::Model still = model;
  still.animations[0].channels.clear();
  for (const int joint : model.skins[0].joints) rest.push_back(world_at(still, joint, 0));
  model.animations.clear();
  model.nodes[0].children = model.skins[0].joints;
  model.nodes[0].rotation.clear();
  for (std::size_t j = 0; j < kWebxrJointCount; ++j) {
    tinygltf::Node& node = model.nodes[static_cast<std::size_t>(model.skins[0].joints[j])];
    const std::string name = node.name;
    node = tinygltf::Node();
    node.name = name;
    node.matrix.assign(rest[j].data(), rest[j].data() + 16);
  }
  // The list reversed, and with it the inverse bind matrices and the vertices' joint numbers.
  std::reverse(model.skins[0].joints.begin(), model.skins[0].joints.end());
  const auto inverse = read_accessor(model, model.skins[0].inverseBindMatrices, 16, "inverse");
  std::vector<float> turned;
  for (std::size_t j = kWebxrJointCount; j-- > 0;) {
    for (std::size_t i = 0; i < 16; ++i) turned.push_back(static_cast<float>(inverse[16 * j + i]));
  }
  model.skins[0].inverseBindMatrices = append_floats(model, turned, 16, 0, false);
  int& joints = model.meshes[0].primitives[0].attributes["JOINTS_0"];
  std::vector<std::uint8_t> numbers;
  for (const double joint : read_accessor(model, joints, 4, "joints")) {
    numbers.push_back(static_cast<std::uint8_t>(kWebxrJointCount - 1 - static_cast<int>(joint)));
  }
  joints = append_byte_quads(model, numbers);
  save(model, file("flat.glb"));
  const HandModel read = read_hand_gltf(file("flat.glb"), Side::right);
  for (std::size_t i = 0; i < read.links.size(); ++i) {
    EXPECT_LT((read.rest_surface.vertices[i] - hand(Side::right).rest_surface.vertices[i]).norm(),
              1e-5);
    EXPECT_EQ(main_bone(read.links[i]), main_bone(hand(Side::right).links[i]));
  }
}

TEST_F(HandGltf, SplitVerticesAreJoined) {
  write_hand_gltf(hand(Side::right), {}, file("hand.glb"));
  tinygltf::Model model = load(file("hand.glb"));
  // Every triangle gets corners of its own, as flat shading does.
  tinygltf::Primitive& primitive = model.meshes[0].primitives[0];
  const auto corners = read_accessor(model, primitive.indices, 1, "corners");
  const auto spread = [&](const std::string& name, int width) {
    const auto numbers = read_accessor(model, primitive.attributes[name], width, name);
    std::vector<float> copies;
    for (const double corner : corners) {
      for (int i = 0; i < width; ++i) {
        copies.push_back(static_cast<float>(
            numbers[static_cast<std::size_t>(corner) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(i)]));
      }
    }
    return copies;
  };
  const std::vector<float> joints = spread("JOINTS_0", 4);
  primitive.attributes["JOINTS_0"] =
      append_byte_quads(model, std::vector<std::uint8_t>(joints.begin(), joints.end()));
  primitive.attributes["WEIGHTS_0"] = append_floats(model, spread("WEIGHTS_0", 4), 4, 0, false);
  primitive.attributes["POSITION"] = append_floats(model, spread("POSITION", 3), 3, 0, true);
  primitive.attributes.erase("NORMAL");
  primitive.indices = -1;
  save(model, file("split.glb"));
  const HandModel read = read_hand_gltf(file("split.glb"), Side::right);
  EXPECT_EQ(read.rest_surface.vertices.size(), hand(Side::right).rest_surface.vertices.size());
  EXPECT_TRUE(inspect_topology(read.rest_surface).closed);
}

TEST_F(HandGltf, TheOtherHandIsRefused) {
  write_hand_gltf(hand(Side::left), {}, file("left.glb"));
  EXPECT_THROW(read_hand_gltf(file("left.glb"), Side::right), Error);
  tinygltf::Model model = load(file("left.glb"));
  model.asset.extras = tinygltf::Value();
  save(model, file("plain.glb"));
  EXPECT_THROW(read_hand_gltf(file("plain.glb"), Side::right), Error);
  EXPECT_NO_THROW(read_hand_gltf(file("plain.glb"), Side::left));
}

TEST_F(HandGltf, ErrorsNameTheFileAndWhatIsMissing) {
  write_hand_gltf(hand(Side::right), {}, file("hand.glb"));
  tinygltf::Model model = load(file("hand.glb"));
  for (tinygltf::Node& node : model.nodes) {
    if (node.name == "ring-finger-tip") node.name = "ring-finger-nail";
  }
  save(model, file("lacking.glb"));
  try {
    read_hand_gltf(file("lacking.glb"), Side::right);
    FAIL();
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("lacking.glb"), std::string::npos);
    EXPECT_NE(message.find("ring-finger-tip"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
  EXPECT_THROW(read_hand_gltf(file("absent.glb"), Side::right), Error);
  EXPECT_THROW(write_hand_gltf(hand(Side::right), {}, file("absent/hand.glb")), Error);
}

TEST_F(HandGltf, KeyframesMustGoForward) {
  std::vector<HandKeyframe> keyframes = some_keyframes();
  keyframes[2].time = keyframes[1].time;
  EXPECT_THROW(write_hand_gltf(hand(Side::right), keyframes, file("take.glb")), Error);
  keyframes = some_keyframes();
  keyframes[0].time = -0.1;
  EXPECT_THROW(write_hand_gltf(hand(Side::right), keyframes, file("take.glb")), Error);
}

TEST_F(HandGltf, DamagedFilesAreErrorsOrHands) {
  write_hand_gltf(hand(Side::right), {}, file("hand.glb"));
  std::ifstream stream(file("hand.glb"), std::ios::binary);
  const std::string good((std::istreambuf_iterator<char>(stream)),
                         std::istreambuf_iterator<char>());
  const auto survives = [&](const std::string& bytes) {
    std::ofstream(file("bad.glb"), std::ios::binary) << bytes;
    try {
      check_hand(read_hand_gltf(file("bad.glb"), Side::right));
      return true;
    } catch (const Error&) {
      return false;
    }
  };
  for (const std::size_t length : {0UL, 3UL, 12UL, 40UL, good.size() / 2, good.size() - 1}) {
    EXPECT_FALSE(survives(good.substr(0, length))) << length;
  }
  Random random(1);
  int refused = 0;
  for (int i = 0; i < 150; ++i) {
    std::string bytes = good;
    bytes[random.index(8000)] = static_cast<char>(random.index(256));  // within the JSON
    refused += survives(bytes) ? 0 : 1;
  }
  EXPECT_GT(refused, 20);
}

}  // namespace
}  // namespace tegata
