// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/bone_pieces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace tegata {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// The bone that moves a triangle's corners most.
int bone_of(const HandModel& hand, const Triangle& triangle) {
  std::array<double, kBoneCount> weights = {};
  for (const std::uint32_t corner : triangle) {
    const SkinLinks& links = hand.links[corner];
    for (std::size_t i = 0; i < links.bones.size(); ++i) {
      weights[index(links.bones[i])] += links.weights[i];
    }
  }
  int most = 0;
  for (int bone = 1; bone < kBoneCount; ++bone) {
    if (weights[index(bone)] > weights[index(most)]) most = bone;
  }
  return most;
}

/// Whether one bone hangs from the other.
bool is_joined(int a, int b) { return parent_bone(a) == b || parent_bone(b) == a; }

/// Whether the bones of the triangles around a vertex are one, or two that hang together.
bool is_clean(const std::vector<std::size_t>& fan, const std::vector<int>& bones) {
  int near = kBoneCount, far = 0;
  for (const std::size_t i : fan) {
    near = std::min(near, bones[i]);
    far = std::max(far, bones[i]);
  }
  return std::all_of(fan.begin(), fan.end(), [&](std::size_t i) {
    return near == far || (is_joined(near, far) && (bones[i] == near || bones[i] == far));
  });
}

/// Moves triangles around a vertex one bone towards the palm: those of the outermost bone, or of
/// all where there are several digits.
void step_towards_palm(const std::vector<std::size_t>& fan, std::vector<int>& bones) {
  int far = 0;
  for (const std::size_t i : fan) far = std::max(far, bones[i]);
  const bool is_one_digit = std::all_of(fan.begin(), fan.end(), [&](std::size_t i) {
    return bones[i] == 0 || (bones[i] - 1) / 3 == (far - 1) / 3;
  });
  for (const std::size_t i : fan) {
    if (bones[i] > 0 && (!is_one_digit || bones[i] == far)) bones[i] = parent_bone(bones[i]);
  }
}

/// The bone of each triangle, so that pieces meet only where a joint is: what other bones share, as
/// neighbouring fingers do the web between them, goes to a bone nearer to the palm.
std::vector<int> bones_of_triangles(const HandModel& hand) {
  const std::vector<Triangle>& triangles = hand.rest_surface.triangles;
  std::vector<int> bones;
  std::vector<std::vector<std::size_t>> around(hand.rest_surface.vertices.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    bones.push_back(bone_of(hand, triangles[i]));
    for (const std::uint32_t corner : triangles[i]) around[corner].push_back(i);
  }
  for (bool is_settled = false; !is_settled;) {  // ends: triangles only ever go towards the palm
    is_settled = true;
    for (const std::vector<std::size_t>& fan : around) {
      if (is_clean(fan, bones)) continue;
      step_towards_palm(fan, bones);
      is_settled = false;
    }
  }
  return bones;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// The edges of triangles that have no other along them.
std::vector<Edge> open_edges(const std::vector<Triangle>& triangles) {
  // How often an edge is run along forwards more than backwards.
  std::map<Edge, int> excess;
  for (const Triangle& triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangle[i], to = triangle[(i + 1) % 3];
      ++excess[{from, to}];
      --excess[{to, from}];
    }
  }
  std::vector<Edge> open;
  for (const auto& [edge, count] : excess) {
    for (int i = 0; i < count; ++i) open.push_back(edge);
  }
  return open;
}

/// Closes the holes that some edges go around by triangles to the middle of each.
void close_holes(const std::vector<Edge>& edges, TriangleMesh& mesh) {
  std::multimap<std::uint32_t, std::uint32_t> open(edges.begin(), edges.end());
  while (!open.empty()) {
    std::vector<std::uint32_t> loop = {open.begin()->first};
    for (auto next = open.begin(); next != open.end(); next = open.find(loop.back())) {
      loop.push_back(next->second);
      open.erase(next);
    }
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i + 1 < loop.size(); ++i) sum += mesh.vertices[loop[i]];
    const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(sum / static_cast<double>(loop.size() - 1));
    for (std::size_t i = 0; i + 1 < loop.size(); ++i) {
      mesh.triangles.push_back({loop[i + 1], loop[i], middle});
    }
  }
}

}  // namespace

std::array<TriangleMesh, kBoneCount> bone_pieces(const HandModel& hand) {
  const std::vector<Triangle>& triangles = hand.rest_surface.triangles;
  const std::vector<int> bones_of = bones_of_triangles(hand);
  std::array<TriangleMesh, kBoneCount> pieces;
  std::map<Edge, int> bone_along;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    pieces[index(bones_of[i])].triangles.push_back(triangles[i]);
    for (std::size_t j = 0; j < 3; ++j) {
      bone_along[{triangles[i][j], triangles[i][(j + 1) % 3]}] = bones_of[i];
    }
  }
  const auto bones = bone_transforms(hand.skeleton, hand.rest_angles);
  for (int bone = 0; bone < kBoneCount; ++bone) {
    TriangleMesh& piece = pieces[index(bone)];
    if (piece.triangles.empty()) continue;
    piece.vertices = hand.rest_surface.vertices;
    const Rigid3d flat_from_rest = bones[index(bone)].inverse();
    for (Eigen::Vector3d& vertex : piece.vertices) vertex = flat_from_rest * vertex;
    const auto first_joint = static_cast<std::uint32_t>(piece.vertices.size());
    for (int joint = 0; joint < kBoneCount; ++joint) {
      piece.vertices.push_back(hand.skeleton.keypoints[index(proximal_keypoint(joint))]);
    }
    std::vector<Edge> unjoined;
    for (const Edge& edge : open_edges(piece.triangles)) {
      const auto other = bone_along.find({edge.second, edge.first});
      if (other == bone_along.end() || !is_joined(bone, other->second)) {
        unjoined.push_back(edge);
        continue;
      }
      const auto joint = static_cast<std::uint32_t>(std::max(bone, other->second));
      piece.triangles.push_back({edge.second, edge.first, first_joint + joint});
    }
    close_holes(unjoined, piece);
    piece = without_unused_vertices(piece);
  }
  return pieces;
}

MassProperties solid_mass(const TriangleMesh& surface, double density) {
  MassProperties solid;
  if (surface.triangles.empty()) return solid;
  const Eigen::Vector3d origin = bounding_box(surface).center();
  double volume = 0.0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();   // integral of p
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // integral of p p'
  for (const Triangle& triangle : surface.triangles) {
    Eigen::Matrix3d corners;
    for (int i = 0; i < 3; ++i) corners.col(i) = surface.vertices[triangle[index(i)]] - origin;
    const double part = corners.determinant() / 6.0;
    const Eigen::Vector3d sum = corners.rowwise().sum();
    volume += part;
    first += part / 4.0 * sum;
    second += part / 20.0 * (corners * corners.transpose() + sum * sum.transpose());
  }
  const Eigen::Vector3d middle = first / volume;
  const Eigen::Matrix3d about_middle = second - volume * middle * middle.transpose();
  solid.mass = density * volume;
  solid.center = origin + middle;
  solid.inertia = density * (about_middle.trace() * Eigen::Matrix3d::Identity() - about_middle);
  return solid;
}

MassProperties ball_mass(const Eigen::Vector3d& center, double mass, double density) {
  const double radius = std::cbrt(3.0 * mass / (4.0 * std::numbers::pi * density));
  return {mass, center, 0.4 * mass * radius * radius * Eigen::Matrix3d::Identity()};
}

}  // namespace tegata
