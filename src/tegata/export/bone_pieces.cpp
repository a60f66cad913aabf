// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/bone_pieces.h"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

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

/// Closes each hole by triangles between its edges and the middle of its corners.
void close_holes(TriangleMesh& mesh) {
  // How often an edge is run along forwards more than backwards; a hole's are once.
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> excess;
  for (const Triangle& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangle[i], to = triangle[(i + 1) % 3];
      ++excess[{from, to}];
      --excess[{to, from}];
    }
  }
  std::multimap<std::uint32_t, std::uint32_t> open;
  for (const auto& [edge, count] : excess) {
    for (int i = 0; i < count; ++i) open.insert(edge);
  }
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
  std::array<TriangleMesh, kBoneCount> pieces;
  for (const Triangle& triangle : hand.rest_surface.triangles) {
    pieces[index(bone_of(hand, triangle))].triangles.push_back(triangle);
  }
  const auto bones = bone_transforms(hand.skeleton, hand.rest_angles);
  for (std::size_t bone = 0; bone < pieces.size(); ++bone) {
    TriangleMesh& piece = pieces[bone];
    if (piece.triangles.empty()) continue;
    piece.vertices = hand.rest_surface.vertices;
    piece = without_unused_vertices(piece);
    const Rigid3d flat_from_rest = bones[bone].inverse();
    for (Eigen::Vector3d& vertex : piece.vertices) vertex = flat_from_rest * vertex;
    close_holes(piece);
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
