// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/sim/held_object.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace tegata {
namespace {

// From the cube [-1, 1]^3 to the unit ball's surface; the tangent evens out the spacing.
Eigen::Vector3d cube_to_sphere(const Eigen::Vector3d& p) {
  return Eigen::Vector3d((p.array() * (std::numbers::pi / 4.0)).tan()).normalized();
}

// Squares about the z axis become circles of their half width; z stays.
Eigen::Vector3d cube_to_cylinder(const Eigen::Vector3d& p) {
  const double radius = p.head<2>().lpNorm<Eigen::Infinity>();
  if (radius == 0.0) return p;
  const Eigen::Vector2d around =
      Eigen::Vector2d((p.head<2>().array() / radius * (std::numbers::pi / 4.0)).tan()).normalized();
  return {radius * around.x(), radius * around.y(), p.z()};
}

Eigen::Vector3d surface_point(const HeldObject& object, const Eigen::Vector3d& in_cube) {
  switch (object.shape) {
    case HeldObject::Shape::cylinder:
      return cube_to_cylinder(in_cube).cwiseProduct(object.half_size);
    case HeldObject::Shape::sphere:
      return cube_to_sphere(in_cube).cwiseProduct(object.half_size);
    case HeldObject::Shape::block:
      break;
  }
  return in_cube.cwiseProduct(object.half_size);
}

}  // namespace

double signed_distance(const HeldObject& object, const Eigen::Vector3d& point_in_object) {
  const Eigen::Vector3d& half = object.half_size;
  switch (object.shape) {
    case HeldObject::Shape::sphere:
      return point_in_object.norm() - half.x();
    case HeldObject::Shape::cylinder: {
      const Eigen::Array2d beyond(point_in_object.head<2>().norm() - half.x(),
                                  std::abs(point_in_object.z()) - half.z());
      return beyond.max(0.0).matrix().norm() + std::min(beyond.maxCoeff(), 0.0);
    }
    case HeldObject::Shape::block:
      break;
  }
  const Eigen::Array3d beyond = point_in_object.array().abs() - half.array();
  return beyond.max(0.0).matrix().norm() + std::min(beyond.maxCoeff(), 0.0);
}

TriangleMesh object_surface(const HeldObject& object, double longest_edge) {
  // Squares of this width have diagonals, and stretched ones near a cube's edges, that are no
  // longer than asked for; a quarter of a circle is pi / 4 of the cube's edge longer than its
  // radius.
  const double cell = longest_edge / 1.85;
  const Eigen::Array3i counts = (2.0 * object.half_size.array() / cell).ceil().cast<int>().max(1);
  TriangleMesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> vertex_at;
  const auto vertex = [&](const Eigen::Array3i& at) {
    const auto [place, is_new] = vertex_at.try_emplace(
        {at.x(), at.y(), at.z()}, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (is_new) {
      const Eigen::Vector3d in_cube =
          2.0 * (at.cast<double>() / counts.cast<double>()).matrix() - Eigen::Vector3d::Ones();
      mesh.vertices.push_back(surface_point(object, in_cube));
    }
    return place->second;
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const int layer : {0, counts[axis]}) {
      for (int i = 0; i < counts[u]; ++i) {
        for (int j = 0; j < counts[v]; ++j) {
          std::array<std::uint32_t, 4> corner;  // counter-clockwise seen from along the axis
          for (int k = 0; k < 4; ++k) {
            Eigen::Array3i at;
            at[axis] = layer;
            at[u] = i + (k == 1 || k == 2 ? 1 : 0);
            at[v] = j + (k >= 2 ? 1 : 0);
            corner[static_cast<std::size_t>(k)] = vertex(at);
          }
          if (layer == 0) std::swap(corner[1], corner[3]);
          mesh.triangles.push_back({corner[0], corner[1], corner[2]});
          mesh.triangles.push_back({corner[0], corner[2], corner[3]});
        }
      }
    }
  }
  return mesh;
}

}  // namespace tegata
