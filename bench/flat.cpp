// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "flat.h"

#include <meshoptimizer.h>

#include <limits>

namespace tegata::bench {

std::vector<FlatView> flat(const std::vector<HullView>& views) {
  std::vector<FlatView> flat_views;
  for (const HullView& view : views) {
    const Camera& camera = view.camera;
    FlatView flat{camera.width, camera.height, camera.fx, camera.fy, camera.cx, camera.cy, {}, {}};
    const Eigen::Matrix3d rotation = camera.camera_from_world.rotation.toRotationMatrix();
    for (Eigen::Index row = 0; row < 3; ++row) {
      for (Eigen::Index column = 0; column < 4; ++column) {
        flat.camera_from_world[static_cast<std::size_t>(4 * row + column)] =
            column < 3 ? rotation(row, column) : camera.camera_from_world.translation[row];
      }
    }
    for (const PixelLabel label : view.silhouette.values()) {
      flat.mask.push_back(label == PixelLabel::background ? 0 : 255);
    }
    flat_views.push_back(std::move(flat));
  }
  return flat_views;
}

FlatCube flat_cube(const SparseField& field) {
  const Lattice lattice = lattice_of(field);
  return {{field.origin.x(), field.origin.y(), field.origin.z()}, field.cell_size, lattice.cells};
}

FlatMesh flat(const TriangleMesh& mesh) {
  FlatMesh flat_mesh;
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    for (const double x : vertex) flat_mesh.vertices.push_back(static_cast<float>(x));
  }
  for (const Triangle& triangle : mesh.triangles) {
    flat_mesh.triangles.insert(flat_mesh.triangles.end(), triangle.begin(), triangle.end());
  }
  return flat_mesh;
}

std::vector<std::uint32_t> meshoptimizer_triangles(const FlatMesh& mesh,
                                                   std::size_t triangle_count) {
  std::vector<std::uint32_t> triangles(mesh.triangles.size());
  triangles.resize(meshopt_simplify(triangles.data(), mesh.triangles.data(), mesh.triangles.size(),
                                    mesh.vertices.data(), mesh.vertices.size() / 3,
                                    3 * sizeof(float), 3 * triangle_count,
                                    std::numeric_limits<float>::max(), 0, nullptr));
  return triangles;
}

TriangleMesh from_flat(const FlatMesh& flat_mesh) {
  TriangleMesh mesh;
  const auto& v = flat_mesh.vertices;
  for (std::size_t i = 0; i < v.size(); i += 3)
    mesh.vertices.emplace_back(v[i], v[i + 1], v[i + 2]);
  const auto& t = flat_mesh.triangles;
  for (std::size_t i = 0; i < t.size(); i += 3)
    mesh.triangles.push_back({t[i], t[i + 1], t[i + 2]});
  return mesh;
}

}  // namespace tegata::bench
