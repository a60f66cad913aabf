// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "tegata/camera/camera.h"
#include "tegata/image/image.h"
#include "tegata/image/silhouette.h"
#include "tegata/mesh/triangle_mesh.h"

namespace tegata {

/// What a camera sees of a mesh: per pixel the depth z in the camera's frame [m] of the nearest
/// surface (infinity where there is none) and the triangle (-1 where there is none).
struct RenderedMesh {
  Image<float> depth;
  Image<std::int32_t> triangle;
};

/// Draws a mesh by its triangles' projected corners, with lens distortion: for true curves of edges
/// under distortion, triangles should be small. A pixel is covered where its centre is. Triangles
/// with a corner that is not in front of the camera are left out.
RenderedMesh render(const TriangleMesh& mesh, const Camera& camera);

enum class Faces {
  all,
  front,  ///< that face the camera; of a closed surface they cover the same pixels
};

/// The pixels that the mesh covers, as hand; all others background.
Silhouette render_silhouette(const TriangleMesh& mesh, const Camera& camera,
                             Faces faces = Faces::all);
/// The same of vertices in world coordinates [m] and the triangles between them.
Silhouette render_silhouette(std::span<const Eigen::Vector3d> vertices,
                             std::span<const Triangle> triangles, const Camera& camera,
                             Faces faces = Faces::all);

/// Triangles with the edges between them, made once for pictures of many poses.
struct EdgedTriangles {
  explicit EdgedTriangles(std::span<const Triangle> triangles);

  struct Edge {
    std::uint32_t a = 0, b = 0;
    /// The triangle that has it from a to b and the one that has it from b to a; -1: none. Where
    /// more meet there are more edges.
    std::int32_t forth = -1, back = -1;
  };
  std::vector<Triangle> triangles;
  std::vector<Edge> edges;
};

/// The same pixels, found by the few edges where what faces the camera ends.
Silhouette render_silhouette(std::span<const Eigen::Vector3d> vertices,
                             const EdgedTriangles& surface, const Camera& camera,
                             Faces faces = Faces::all);

}  // namespace tegata
