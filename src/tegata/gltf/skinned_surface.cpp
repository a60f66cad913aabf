// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/gltf/skinned_surface.h"

#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/gltf/accessor.h"

namespace tegata {
namespace {

using Matrices = std::vector<Eigen::Matrix4d>;

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
      if (child < 0 || static_cast<std::size_t>(child) >= parent.size() ||
          parent[static_cast<std::size_t>(child)] >= 0) {
        throw Error("node ", i, ": child ", child, " is absent or has another parent");
      }
      parent[static_cast<std::size_t>(child)] = static_cast<int>(i);
    }
  }
  return parent;
}

Matrices world_matrices(const tinygltf::Model& model, const std::vector<int>& parent) {
  Matrices world(model.nodes.size());
  for (std::size_t i = 0; i < world.size(); ++i) {
    world[i] = local_matrix(model.nodes[i]);
    std::size_t steps = 0;
    for (int above = parent[i]; above >= 0; above = parent[static_cast<std::size_t>(above)]) {
      if (++steps > world.size()) throw Error("node ", i, " is its own ancestor");
      world[i] = local_matrix(model.nodes[static_cast<std::size_t>(above)]) * world[i];
    }
    if (!world[i].allFinite()) throw Error("node ", i, ": its transform is not finite");
  }
  return world;
}

/// The place of a node in webxr_joints(), or -1.
int webxr_joint(const tinygltf::Node& node) {
  const auto& joints = webxr_joints();
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i].name == node.name) return static_cast<int>(i);
  }
  return -1;
}

/// The first skin with all joints; `nodes` gets the nodes of the joints.
std::size_t hand_skin(const tinygltf::Model& model, std::array<int, kWebxrJointCount>& nodes) {
  std::string missing = "no skin";
  std::size_t fewest = kWebxrJointCount + 1;
  for (std::size_t skin = 0; skin < model.skins.size(); ++skin) {
    nodes.fill(-1);
    for (const int node : model.skins[skin].joints) {
      if (node < 0 || static_cast<std::size_t>(node) >= model.nodes.size()) {
        throw Error("skin ", skin, ": joint ", node, " is not among the file's ",
                    model.nodes.size(), " nodes");
      }
      const int joint = webxr_joint(model.nodes[static_cast<std::size_t>(node)]);
      if (joint >= 0) nodes[static_cast<std::size_t>(joint)] = node;
    }
    const auto absent = static_cast<std::size_t>(std::count(nodes.begin(), nodes.end(), -1));
    if (absent == 0) return skin;
    if (absent < fewest) {
      fewest = absent;
      const auto first = std::find(nodes.begin(), nodes.end(), -1) - nodes.begin();
      missing = text("skin ", skin, " lacks ", absent, ", the first of them ",
                     webxr_joints()[static_cast<std::size_t>(first)].name);
    }
  }
  throw Error("expected a skin with the 25 joints of a WebXR hand, but ", missing);
}

/// For each joint of the skin the bone that it moves.
std::vector<int> bones_of_joints(const tinygltf::Model& model, const tinygltf::Skin& skin,
                                 const std::vector<int>& parent) {
  std::vector<int> bones;
  for (int node : skin.joints) {
    int joint = -1;
    for (; node >= 0 && joint < 0; node = parent[static_cast<std::size_t>(node)]) {
      joint = webxr_joint(model.nodes[static_cast<std::size_t>(node)]);
    }
    bones.push_back(joint < 0 ? 0 : webxr_joints()[static_cast<std::size_t>(joint)].bone);
  }
  return bones;
}

/// The skin's joints: from the mesh as it is stored to the world, and the bone of each.
struct Binding {
  Matrices world_from_mesh;
  std::vector<int> bones;
};

Binding bind(const tinygltf::Model& model, const tinygltf::Skin& skin,
             const std::vector<int>& parent, const Matrices& world) {
  Binding binding;
  binding.bones = bones_of_joints(model, skin, parent);
  std::vector<double> inverse;
  if (skin.inverseBindMatrices >= 0) {
    inverse = read_accessor(model, skin.inverseBindMatrices, 16, "inverse bind matrices");
    if (inverse.size() < 16 * skin.joints.size()) {
      throw Error("inverse bind matrices: ", inverse.size() / 16, " for ", skin.joints.size(),
                  " joints");
    }
  }
  for (std::size_t i = 0; i < skin.joints.size(); ++i) {
    Eigen::Matrix4d matrix = world[static_cast<std::size_t>(skin.joints[i])];
    if (!inverse.empty()) matrix = matrix * Eigen::Map<const Eigen::Matrix4d>(&inverse[16 * i]);
    binding.world_from_mesh.push_back(matrix);
  }
  return binding;
}

/// The four heaviest bones, their weights summing to 1.
SkinLinks heaviest(const std::array<double, kBoneCount>& weights, const std::string& what) {
  std::array<int, kBoneCount> order;
  for (int bone = 0; bone < kBoneCount; ++bone) order[static_cast<std::size_t>(bone)] = bone;
  const auto weight = [&](int bone) { return weights[static_cast<std::size_t>(bone)]; };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return weight(a) > weight(b); });
  SkinLinks links;
  double sum = 0.0;
  for (std::size_t i = 0; i < links.bones.size(); ++i) sum += weight(order[i]);
  if (!(sum > 0.0)) throw Error(what, ": a vertex is bound to no joint");
  for (std::size_t i = 0; i < links.bones.size(); ++i) {
    links.weights[i] = weight(order[i]) / sum;
    if (links.weights[i] > 0.0) links.bones[i] = order[i];
  }
  return links;
}

/// Joins vertices that are stored at the same place and bound to the same bones.
class Collector {
 public:
  explicit Collector(SkinnedSurface& target) : target_(target) {}

  std::uint32_t vertex(const Eigen::Vector3d& point, const SkinLinks& links) {
    const Key key{{point.x(), point.y(), point.z()}, links.bones, links.weights};
    const auto [place, is_new] =
        known_.emplace(key, static_cast<std::uint32_t>(target_.surface.vertices.size()));
    if (is_new) {
      target_.surface.vertices.push_back(point);
      target_.links.push_back(links);
    }
    return place->second;
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) target_.surface.triangles.push_back({a, b, c});
  }

 private:
  using Key = std::tuple<std::array<double, 3>, std::array<int, 4>, std::array<double, 4>>;
  SkinnedSurface& target_;
  std::map<Key, std::uint32_t> known_;
};

/// Adds the vertices of a primitive; returns where each went.
std::vector<std::uint32_t> add_vertices(const tinygltf::Model& model,
                                        const tinygltf::Primitive& primitive,
                                        const Binding& binding, const std::string& what,
                                        Collector& collector) {
  const auto attribute = [&](const std::string& name, int components) {
    const auto found = primitive.attributes.find(name);
    if (found == primitive.attributes.end()) throw Error(what, ": it has no ", name);
    return read_accessor(model, found->second, components, what + ", " + name);
  };
  const std::vector<double> positions = attribute("POSITION", 3);
  const std::size_t count = positions.size() / 3;
  std::vector<std::array<double, kBoneCount>> weights(count);
  std::vector<Eigen::Matrix4d> matrices(count, Eigen::Matrix4d::Zero());
  for (int set = 0; set == 0 || primitive.attributes.count(text("JOINTS_", set)) > 0; ++set) {
    const std::vector<double> joints = attribute(text("JOINTS_", set), 4);
    const std::vector<double> parts = attribute(text("WEIGHTS_", set), 4);
    if (joints.size() != 4 * count || parts.size() != 4 * count) {
      throw Error(what, ": joints or weights are not one a vertex");
    }
    for (std::size_t i = 0; i < 4 * count; ++i) {
      if (parts[i] == 0.0) continue;
      const auto joint = static_cast<std::size_t>(joints[i]);
      if (!(parts[i] > 0.0) || !(joints[i] >= 0.0) || joint >= binding.bones.size()) {
        throw Error(what, ": vertex ", i / 4, " is bound to joint ", joints[i], " by ", parts[i],
                    ", expected one of ", binding.bones.size(), " joints and 0 to 1");
      }
      weights[i / 4][static_cast<std::size_t>(binding.bones[joint])] += parts[i];
      matrices[i / 4] += parts[i] * binding.world_from_mesh[joint];
    }
  }
  std::vector<std::uint32_t> places;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector4d stored(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2], 1.0);
    const Eigen::Vector4d point = matrices[i] * stored;
    places.push_back(collector.vertex(point.head<3>() / point.w(), heaviest(weights[i], what)));
  }
  return places;
}

void add_primitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                   const Binding& binding, const std::string& what, Collector& collector) {
  if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != -1) {
    throw Error(what, ": mode ", primitive.mode, ", expected triangles");
  }
  const std::vector<std::uint32_t> places =
      add_vertices(model, primitive, binding, what, collector);
  std::vector<double> corners;
  if (primitive.indices >= 0) {
    corners = read_accessor(model, primitive.indices, 1, what + ", indices");
  } else {
    for (std::size_t i = 0; i < places.size(); ++i) corners.push_back(static_cast<double>(i));
  }
  if (corners.size() % 3 != 0) throw Error(what, ": ", corners.size(), " corners of triangles");
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    std::array<std::uint32_t, 3> at;
    for (std::size_t j = 0; j < 3; ++j) {
      if (!(corners[i + j] >= 0.0 && corners[i + j] < static_cast<double>(places.size()))) {
        throw Error(what, ": index ", corners[i + j], " of ", places.size(), " vertices");
      }
      at[j] = places[static_cast<std::size_t>(corners[i + j])];
    }
    collector.triangle(at[0], at[1], at[2]);
  }
}

}  // namespace

SkinnedSurface skinned_surface(const tinygltf::Model& model) {
  const std::vector<int> parent = parents(model);
  const Matrices world = world_matrices(model, parent);
  std::array<int, kWebxrJointCount> nodes;
  const std::size_t skin = hand_skin(model, nodes);
  const Binding binding = bind(model, model.skins[skin], parent, world);

  SkinnedSurface result;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    result.joints[i] = world[static_cast<std::size_t>(nodes[i])].block<3, 1>(0, 3);
  }
  Collector collector(result);
  for (const tinygltf::Node& node : model.nodes) {
    if (node.skin != static_cast<int>(skin) || node.mesh < 0) continue;
    if (static_cast<std::size_t>(node.mesh) >= model.meshes.size()) {
      throw Error("node '", node.name, "': mesh ", node.mesh, " is not among the file's ",
                  model.meshes.size());
    }
    const tinygltf::Mesh& mesh = model.meshes[static_cast<std::size_t>(node.mesh)];
    for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
      add_primitive(model, mesh.primitives[i], binding,
                    text("mesh '", mesh.name, "', primitive ", i), collector);
    }
  }
  if (result.surface.triangles.empty()) throw Error("no triangles are bound to the hand's skin");
  check_mesh(result.surface);
  if (enclosed_volume(result.surface) < 0.0) {
    for (Triangle& triangle : result.surface.triangles) std::swap(triangle[1], triangle[2]);
  }
  return result;
}

}  // namespace tegata
