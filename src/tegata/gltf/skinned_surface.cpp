// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/gltf/skinned_surface.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/gltf/accessor.h"

namespace tegata {
namespace {

using Matrices = std::vector<Eigen::Matrix4d>;

// Of all meshes together: far more than a hand needs, and little enough for any machine.
constexpr std::size_t kMostVertices = 2'000'000;

/// The skin's joints: from the mesh as it is stored to the world, and the bone of each.
struct Binding {
  Matrices world_from_mesh;
  std::vector<int> bones;
};

Binding bind(const tinygltf::Model& model, const tinygltf::Skin& skin, const NodeTree& tree,
             const std::vector<int>& bone_of_node) {
  Binding binding;
  std::vector<double> inverse;
  if (skin.inverseBindMatrices >= 0) {
    inverse = read_accessor(model, skin.inverseBindMatrices, 16, "inverse bind matrices");
    if (inverse.size() < 16 * skin.joints.size()) {
      throw Error("inverse bind matrices: ", inverse.size() / 16, " for ", skin.joints.size(),
                  " joints");
    }
  }
  for (std::size_t i = 0; i < skin.joints.size(); ++i) {
    const auto node = static_cast<std::size_t>(skin.joints[i]);
    Eigen::Matrix4d matrix = tree.world[node];
    if (!inverse.empty()) matrix = matrix * Eigen::Map<const Eigen::Matrix4d>(&inverse[16 * i]);
    if (!matrix.allFinite())
      throw Error("inverse bind matrices: that of joint ", i, " is not finite");
    binding.world_from_mesh.push_back(matrix);
    binding.bones.push_back(bone_of_node[node]);
  }
  return binding;
}

/// The four heaviest bones, their weights summing to 1.
SkinLinks heaviest(const std::array<double, kBoneCount>& weights) {
  std::array<int, kBoneCount> order;
  for (int bone = 0; bone < kBoneCount; ++bone) order[static_cast<std::size_t>(bone)] = bone;
  const auto weight = [&](int bone) { return weights[static_cast<std::size_t>(bone)]; };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return weight(a) > weight(b); });
  SkinLinks links;
  double sum = 0.0;
  for (std::size_t i = 0; i < links.bones.size(); ++i) sum += weight(order[i]);
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

  /// Throws Error where so many more vertices, or corners of triangles, are too many.
  void expect(std::size_t more, const std::string& what) {
    expected_ += more;
    if (expected_ > kMostVertices) {
      throw Error(what, ": the hand's meshes have more than ", kMostVertices,
                  " vertices and corners; a simplified hand would do");
    }
  }

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
  std::size_t expected_ = 0;
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
  collector.expect(count, what);
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
      const auto joint_count = static_cast<double>(binding.bones.size());
      if (!(parts[i] > 0.0 && std::isfinite(parts[i]) && joints[i] >= 0.0 &&
            joints[i] < joint_count)) {
        throw Error(what, ": vertex ", i / 4, " is bound to joint ", joints[i], " by ", parts[i],
                    ", expected one of ", binding.bones.size(), " joints and 0 to 1");
      }
      const auto joint = static_cast<std::size_t>(joints[i]);
      weights[i / 4][static_cast<std::size_t>(binding.bones[joint])] += parts[i];
      matrices[i / 4] += parts[i] * binding.world_from_mesh[joint];
    }
  }
  std::vector<std::uint32_t> places;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector4d stored(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2], 1.0);
    // Divided by its last entry, which is the sum of the weights, so that they need not sum to 1.
    const Eigen::Vector4d sum = matrices[i] * stored;
    if (matrices[i].isZero(0.0)) throw Error(what, ": vertex ", i, " is bound to no joint");
    const Eigen::Vector3d point = sum.head<3>() / sum.w();
    if (!point.allFinite()) throw Error(what, ": vertex ", i, " is not at a finite place");
    places.push_back(collector.vertex(point, heaviest(weights[i])));
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
  collector.expect(corners.size(), what);
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

/// Leaves out the vertices that no triangle uses, and their links.
void drop_unused_vertices(SkinnedSurface& read) {
  std::vector<bool> is_used(read.links.size(), false);
  for (const Triangle& triangle : read.surface.triangles) {
    for (const std::uint32_t corner : triangle) is_used[corner] = true;
  }
  std::vector<SkinLinks> links;
  for (std::size_t i = 0; i < is_used.size(); ++i) {
    if (is_used[i]) links.push_back(read.links[i]);
  }
  read.links = std::move(links);
  read.surface = without_unused_vertices(read.surface);
}

}  // namespace

SkinnedSurface skinned_surface(const tinygltf::Model& model, const NodeTree& tree,
                               const HandJoints& hand) {
  SkinnedSurface result;
  for (std::size_t i = 0; i < hand.nodes.size(); ++i) {
    result.joints[i] = tree.world[static_cast<std::size_t>(hand.nodes[i])].block<3, 1>(0, 3);
  }
  const std::vector<int> bone_of_node = bones_of_nodes(hand, tree);
  std::map<int, Binding> bindings;
  for (const std::size_t skin : hand.skins) {
    bindings[static_cast<int>(skin)] = bind(model, model.skins[skin], tree, bone_of_node);
  }
  Collector collector(result);
  for (const tinygltf::Node& node : model.nodes) {
    const auto binding = bindings.find(node.skin);
    if (binding == bindings.end() || node.mesh < 0) continue;
    if (static_cast<std::size_t>(node.mesh) >= model.meshes.size()) {
      throw Error("node '", node.name, "': mesh ", node.mesh, " is not among the file's ",
                  model.meshes.size());
    }
    const tinygltf::Mesh& mesh = model.meshes[static_cast<std::size_t>(node.mesh)];
    for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
      add_primitive(model, mesh.primitives[i], binding->second,
                    text("mesh '", mesh.name, "', primitive ", i), collector);
    }
  }
  if (result.surface.triangles.empty()) throw Error("no triangles are bound to the hand's skin");
  drop_unused_vertices(result);
  check_mesh(result.surface);
  if (enclosed_volume(result.surface) < 0.0) {
    for (Triangle& triangle : result.surface.triangles) std::swap(triangle[1], triangle[2]);
  }
  return result;
}

}  // namespace tegata
