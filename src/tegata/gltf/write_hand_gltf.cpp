// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <tiny_gltf.h>

#include <fstream>

#include "tegata/base/error.h"
#include "tegata/gltf/accessor.h"
#include "tegata/gltf/gltf_cameras.h"
#include "tegata/gltf/hand_gltf.h"
#include "tegata/gltf/webxr_joints.h"

namespace tegata {
namespace {

using JointFrames = std::array<Rigid3d, kWebxrJointCount>;

// Nodes: the turn from OpenCV's axes to glTF's, the joints in WebXR's order, the mesh.
constexpr int kTurnNode = 0;
constexpr int kFirstJointNode = 1;
constexpr int kMeshNode = kFirstJointNode + kWebxrJointCount;

/// A joint's frame as WebXR has it: -z along the bone, y out of its back.
Rigid3d joint_frame(const Eigen::Vector3d& place, const Eigen::Vector3d& along,
                    const Eigen::Vector3d& back) {
  Eigen::Matrix3d axes;
  axes.col(2) = -along.normalized();
  axes.col(1) = (back - back.dot(axes.col(2)) * axes.col(2)).normalized();
  axes.col(0) = axes.col(1).cross(axes.col(2));
  return {Eigen::Quaterniond(axes), place};
}

/// The joints' frames in the hand's frame at zero angles.
JointFrames joint_frames(const Skeleton& skeleton) {
  const Eigen::Vector3d dorsal = Eigen::Vector3d::UnitZ();
  JointFrames frames;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const WebxrJoint& joint = webxr_joints()[i];
    if (joint.keypoint <= 0) {
      // The wrist points to the middle MCP joint, a finger's metacarpal begins at the wrist's
      // bones.
      const int end = joint.keypoint == 0 ? 9 : webxr_joints()[i + 1].keypoint;
      const Eigen::Vector3d way = skeleton.keypoints[static_cast<std::size_t>(end)];
      frames[i] = joint_frame((joint.keypoint == 0 ? 0.0 : 0.35) * way, way, dorsal);
      continue;
    }
    const auto near = static_cast<std::size_t>(proximal_keypoint(joint.bone));
    const Eigen::Vector3d along = skeleton.keypoints[near + 1] - skeleton.keypoints[near];
    // Of a digit's three flexion axes the last one is that of the bone's own plane of bending.
    const auto angle = static_cast<std::size_t>(4 * ((joint.bone - 1) / 3) + 3);
    frames[i] = joint_frame(skeleton.keypoints[static_cast<std::size_t>(joint.keypoint)], along,
                            along.cross(skeleton.axes[angle]));
  }
  return frames;
}

/// The joints' transforms relative to the joint above (the wrist's: to the world) in a pose.
JointFrames local_transforms(const Skeleton& skeleton, const JointFrames& frames,
                             const HandPose& pose) {
  const auto bones = bone_transforms(skeleton, pose.angles);
  JointFrames world, local;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const WebxrJoint& joint = webxr_joints()[i];
    world[i] = pose.world_from_hand * bones[static_cast<std::size_t>(joint.bone)] * frames[i];
    local[i] = joint.parent < 0
                   ? world[i]
                   : world[static_cast<std::size_t>(joint.parent)].inverse() * world[i];
  }
  return local;
}

std::vector<float> floats(const std::vector<Eigen::Vector3d>& vectors) {
  std::vector<float> numbers;
  numbers.reserve(3 * vectors.size());
  for (const Eigen::Vector3d& vector : vectors) {
    for (int i = 0; i < 3; ++i) numbers.push_back(static_cast<float>(vector[i]));
  }
  return numbers;
}

tinygltf::Value value(const double* numbers, std::size_t count) {
  tinygltf::Value::Array list;
  for (std::size_t i = 0; i < count; ++i) list.emplace_back(numbers[i]);
  return tinygltf::Value(std::move(list));
}

/// What joints alone do not tell: which way angles turn and where they are zero.
tinygltf::Value notes(const HandModel& hand) {
  tinygltf::Value::Object skeleton;
  skeleton["side"] = tinygltf::Value(std::string(side_name(hand.skeleton.side)));
  skeleton["keypoints"] = value(hand.skeleton.keypoints[0].data(), 3 * kKeypointCount);
  skeleton["axes"] = value(hand.skeleton.axes[0].data(), 3 * kAngleCount);
  skeleton["rest_angles"] = value(hand.rest_angles.data(), kAngleCount);
  tinygltf::Value::Object extras;
  extras["tegata_hand"] = tinygltf::Value(std::move(skeleton));
  return tinygltf::Value(std::move(extras));
}

/// The same links without a bone twice, which glTF does not allow.
SkinLinks with_bones_once(SkinLinks links) {
  for (std::size_t i = 1; i < links.bones.size(); ++i) {
    for (std::size_t j = 0; j < i && links.weights[i] > 0.0; ++j) {
      if (links.bones[i] != links.bones[j] || links.weights[j] <= 0.0) continue;
      links.weights[j] += links.weights[i];
      links.weights[i] = 0.0;
    }
  }
  return links;
}

void add_mesh(const HandModel& hand, tinygltf::Model& model) {
  tinygltf::Material material;
  material.name = "skin";
  material.pbrMetallicRoughness.baseColorFactor = {0.80, 0.60, 0.50, 1.0};
  material.pbrMetallicRoughness.metallicFactor = 0.0;
  material.pbrMetallicRoughness.roughnessFactor = 0.8;
  model.materials.push_back(material);

  std::array<std::uint8_t, kBoneCount> joint_of_bone = {};
  for (std::size_t i = kWebxrJointCount; i-- > 0;) {  // the first joint of a bone wins
    joint_of_bone[static_cast<std::size_t>(webxr_joints()[i].bone)] = static_cast<std::uint8_t>(i);
  }
  std::vector<std::uint8_t> joints;
  std::vector<float> weights;
  for (const SkinLinks& stored : hand.links) {
    const SkinLinks links = with_bones_once(stored);
    for (std::size_t i = 0; i < links.bones.size(); ++i) {
      const bool is_used = links.weights[i] > 0.0;
      joints.push_back(is_used ? joint_of_bone[static_cast<std::size_t>(links.bones[i])] : 0);
      weights.push_back(static_cast<float>(links.weights[i]));
    }
  }
  std::vector<std::uint32_t> corners;
  for (const Triangle& triangle : hand.rest_surface.triangles) {
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  }
  constexpr int kVertices = TINYGLTF_TARGET_ARRAY_BUFFER;
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.material = 0;
  primitive.indices = append_indices(model, corners);
  primitive.attributes["POSITION"] =
      append_floats(model, floats(hand.rest_surface.vertices), 3, kVertices, true);
  primitive.attributes["NORMAL"] =
      append_floats(model, floats(hand.rest_surface.normals), 3, kVertices, false);
  primitive.attributes["JOINTS_0"] = append_byte_quads(model, joints);
  primitive.attributes["WEIGHTS_0"] = append_floats(model, weights, 4, kVertices, false);
  tinygltf::Mesh mesh;
  mesh.name = "hand";
  mesh.primitives.push_back(primitive);
  model.meshes.push_back(mesh);
}

void add_nodes(const HandModel& hand, const JointFrames& frames, tinygltf::Model& model) {
  const HandPose rest{Rigid3d(), hand.rest_angles};
  const JointFrames local = local_transforms(hand.skeleton, frames, rest);
  model.nodes.resize(kMeshNode + 1);
  model.nodes[kTurnNode].name = "opencv-world";
  model.nodes[kTurnNode].rotation = {1.0, 0.0, 0.0, 0.0};
  model.nodes[kTurnNode].children = {kFirstJointNode};

  const auto bones = bone_transforms(hand.skeleton, hand.rest_angles);
  tinygltf::Skin skin;
  skin.name = "hand";
  std::vector<float> inverse_bind;
  for (std::size_t i = 0; i < kWebxrJointCount; ++i) {
    const WebxrJoint& joint = webxr_joints()[i];
    const int index = kFirstJointNode + static_cast<int>(i);
    tinygltf::Node& node = model.nodes[static_cast<std::size_t>(index)];
    node.name = joint.name;
    const Eigen::Quaterniond& turn = local[i].rotation;
    node.rotation = {turn.x(), turn.y(), turn.z(), turn.w()};
    node.translation = {local[i].translation.x(), local[i].translation.y(),
                        local[i].translation.z()};
    if (joint.parent >= 0) {
      model.nodes[static_cast<std::size_t>(kFirstJointNode + joint.parent)].children.push_back(
          index);
    }
    skin.joints.push_back(index);
    const Rigid3d inverse = (bones[static_cast<std::size_t>(joint.bone)] * frames[i]).inverse();
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
    matrix.topLeftCorner<3, 3>() = inverse.rotation.toRotationMatrix().cast<float>();
    matrix.topRightCorner<3, 1>() = inverse.translation.cast<float>();
    inverse_bind.insert(inverse_bind.end(), matrix.data(), matrix.data() + 16);
  }
  skin.inverseBindMatrices = append_floats(model, inverse_bind, 16, 0, false);
  skin.skeleton = kFirstJointNode;
  model.skins.push_back(skin);
  model.nodes[kMeshNode].name = "hand";
  model.nodes[kMeshNode].mesh = 0;
  model.nodes[kMeshNode].skin = 0;
}

/// Adds what one node does over time: its rotations, or the wrist's translations and scales.
void add_channel(tinygltf::Model& model, int input, int node, const std::string& path,
                 const std::vector<float>& numbers) {
  tinygltf::Animation& animation = model.animations.back();
  tinygltf::AnimationSampler sampler;
  sampler.input = input;
  sampler.output = append_floats(model, numbers, path == "rotation" ? 4 : 3, 0, false);
  sampler.interpolation = path == "scale" ? "STEP" : "LINEAR";
  animation.samplers.push_back(sampler);
  tinygltf::AnimationChannel channel;
  channel.sampler = static_cast<int>(animation.samplers.size()) - 1;
  channel.target_node = node;
  channel.target_path = path;
  animation.channels.push_back(channel);
}

void add_animation(const Skeleton& skeleton, const JointFrames& frames,
                   const std::vector<HandKeyframe>& keyframes, tinygltf::Model& model) {
  std::vector<float> times;
  std::vector<JointFrames> locals;
  for (const HandKeyframe& keyframe : keyframes) {
    if (keyframe.is_hidden) continue;
    times.push_back(static_cast<float>(keyframe.time));
    locals.push_back(local_transforms(skeleton, frames, keyframe.pose));
  }
  if (times.empty()) return;
  const int input = append_floats(model, times, 1, 0, true);
  model.animations.emplace_back();
  model.animations.back().name = "take";
  std::vector<float> places;
  for (const JointFrames& local : locals) {
    for (int i = 0; i < 3; ++i) places.push_back(static_cast<float>(local[0].translation[i]));
  }
  add_channel(model, input, kFirstJointNode, "translation", places);
  for (std::size_t joint = 0; joint < kWebxrJointCount; ++joint) {
    const WebxrJoint& described = webxr_joints()[joint];
    // Metacarpals and tips are fixed to the joint above.
    if (described.parent >= 0 &&
        webxr_joints()[static_cast<std::size_t>(described.parent)].bone == described.bone) {
      continue;
    }
    std::vector<float> turns;
    Eigen::Quaterniond before = locals.front()[joint].rotation;
    for (const JointFrames& local : locals) {
      Eigen::Quaterniond turn = local[joint].rotation;
      // Of the two quaternions of a rotation the one that a viewer reaches without going round.
      if (turn.dot(before) < 0.0) turn.coeffs() = -turn.coeffs();
      for (int i = 0; i < 4; ++i) turns.push_back(static_cast<float>(turn.coeffs()[i]));
      before = turn;
    }
    add_channel(model, input, kFirstJointNode + static_cast<int>(joint), "rotation", turns);
  }
}

/// Adds where the hand is shown and where not, unless it always is.
void add_visibility(const std::vector<HandKeyframe>& keyframes, tinygltf::Model& model) {
  if (model.animations.empty()) return;
  std::vector<float> times, scales;
  bool is_ever_hidden = false;
  for (const HandKeyframe& keyframe : keyframes) {
    times.push_back(static_cast<float>(keyframe.time));
    scales.insert(scales.end(), 3, keyframe.is_hidden ? 0.0F : 1.0F);
    is_ever_hidden = is_ever_hidden || keyframe.is_hidden;
  }
  if (!is_ever_hidden) return;
  add_channel(model, append_floats(model, times, 1, 0, true), kFirstJointNode, "scale", scales);
}

void check_keyframes(const std::vector<HandKeyframe>& keyframes,
                     const std::filesystem::path& file) {
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    const HandKeyframe& keyframe = keyframes[i];
    if (!(keyframe.time >= 0.0) || (i > 0 && !(static_cast<float>(keyframe.time) >
                                               static_cast<float>(keyframes[i - 1].time)))) {
      throw Error(file.string(), ": keyframe ", i, " is at ", keyframe.time,
                  " s, expected times from 0 on that increase");
    }
    const Rigid3d& place = keyframe.pose.world_from_hand;
    if (keyframe.is_hidden) continue;
    if (!place.translation.allFinite() || !place.rotation.coeffs().allFinite() ||
        !keyframe.pose.angles.allFinite()) {
      throw Error(file.string(), ": the pose of keyframe ", i, " is not finite");
    }
  }
}

}  // namespace

void write_hand_gltf(const HandModel& hand, const std::vector<HandKeyframe>& keyframes,
                     const std::filesystem::path& file, const CameraRig& cameras) {
  check_hand(hand);
  check_keyframes(keyframes, file);
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "tegata";
  model.asset.extras = notes(hand);
  add_mesh(hand, model);
  const JointFrames frames = joint_frames(hand.skeleton);
  add_nodes(hand, frames, model);
  add_animation(hand.skeleton, frames, keyframes, model);
  add_visibility(keyframes, model);
  for (const Camera& camera : cameras) {
    const int node = add_gltf_camera(camera, model);  // moves the nodes
    model.nodes[kTurnNode].children.push_back(node);
  }
  tinygltf::Scene scene;
  scene.nodes = {kTurnNode, kMeshNode};
  model.scenes.push_back(scene);
  model.defaultScene = 0;

  const bool is_binary = file.extension() != ".gltf";
  std::ofstream stream(file, std::ios::binary);
  tinygltf::TinyGLTF writer;
  const bool is_written = writer.WriteGltfSceneToStream(&model, stream, !is_binary, is_binary);
  stream.close();
  if (!is_written || !stream) throw Error(file.string(), ": it cannot be written");
}

}  // namespace tegata
