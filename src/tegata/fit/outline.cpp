// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/outline.h"

#include <algorithm>
#include <cmath>

#include "tegata/fit/surface_row.h"
#include "tegata/image/rasterizer.h"

namespace tegata {
namespace {

// How far beside the outline the picture of the hand is asked for the hand, on either side. Less
// and the outline of a coarse mesh would be missed, more and fingers close together would look like
// one.
constexpr double kProbePx = 1.5;

bool covered(const Silhouette& silhouette, const Eigen::Vector2d& pixel) {
  const int x = static_cast<int>(std::lround(pixel.x()));
  const int y = static_cast<int>(std::lround(pixel.y()));
  return silhouette.contains(x, y) && silhouette(x, y) == PixelLabel::hand;
}

}  // namespace

std::vector<OutlinePoint> hand_outline(const FitHand& hand, const PosedHand& posed,
                                       const Camera& camera) {
  const Silhouette seen = render_silhouette(posed.vertices(), posed.model().rest_surface.triangles,
                                            camera, Faces::front);
  const Eigen::Vector3d eye = camera.center_in_world();
  const std::vector<Eigen::Vector3d>& vertices = posed.vertices();
  const std::vector<Eigen::Vector3d>& normals = posed.normals();
  std::vector<double> facing(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    facing[i] = normals[i].dot(eye - vertices[i]);
  }

  std::vector<OutlinePoint> outline;
  for (const SurfaceEdge& edge : hand.edges) {
    const double at_a = facing[edge.a], at_b = facing[edge.b];
    if ((at_a > 0.0) == (at_b > 0.0)) continue;
    OutlinePoint point;
    point.a = edge.a;
    point.b = edge.b;
    point.fraction = at_a / (at_a - at_b);
    point.point = (1.0 - point.fraction) * vertices[edge.a] + point.fraction * vertices[edge.b];
    const auto pixel = project(camera, point.point);
    if (!pixel || !camera.contains(*pixel)) continue;
    const Eigen::Vector3d normal =
        (1.0 - point.fraction) * normals[edge.a] + point.fraction * normals[edge.b];
    const Eigen::Vector2d direction =
        (camera.camera_from_world.rotation * normal).head<2>().normalized();
    if (!direction.allFinite()) continue;
    if (covered(seen, *pixel + kProbePx * direction)) continue;
    if (!covered(seen, *pixel - kProbePx * direction)) continue;
    point.pixel = *pixel;
    point.normal = direction;
    point.beyond_wrist = hand.beyond_wrist[edge.a] != 0 && hand.beyond_wrist[edge.b] != 0;
    outline.push_back(point);
  }
  std::stable_sort(
      outline.begin(), outline.end(),
      [](const OutlinePoint& a, const OutlinePoint& b) { return a.pixel.x() < b.pixel.x(); });
  return outline;
}

HandRow outline_row(const PosedHand& posed, const OutlinePoint& point,
                    const Eigen::RowVector3d& along) {
  HandRow row;
  add_vertex_row(posed, point.a, (1.0 - point.fraction) * along, row);
  add_vertex_row(posed, point.b, point.fraction * along, row);
  return row;
}

ShapeRow outline_shape_row(const ShapeMotion* shape, const OutlinePoint& point,
                           const Eigen::RowVector3d& along) {
  if (shape == nullptr) return {};
  return (1.0 - point.fraction) * shape->row(point.a, along) +
         point.fraction * shape->row(point.b, along);
}

}  // namespace tegata
