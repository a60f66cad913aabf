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

// A camera's picture of the hand, smaller than the camera's own.
struct DrawnHand {
  DrawnHand(const FitHand& hand, const PosedHand& posed, const Camera& camera, int coarseness)
      : scale(1.0 / coarseness),
        silhouette(render_silhouette(posed.vertices(), hand.drawn, smaller(camera, coarseness),
                                     Faces::front)) {}

  bool covers(const Eigen::Vector2d& pixel) const {
    const int x = static_cast<int>(std::lround(scale * (pixel.x() + 0.5) - 0.5));
    const int y = static_cast<int>(std::lround(scale * (pixel.y() + 0.5) - 0.5));
    return silhouette.contains(x, y) && silhouette(x, y) == PixelLabel::hand;
  }
  static Camera smaller(Camera camera, int coarseness) {
    camera.width = (camera.width + coarseness - 1) / coarseness;
    camera.height = (camera.height + coarseness - 1) / coarseness;
    camera.fx /= coarseness;
    camera.fy /= coarseness;
    camera.cx = (camera.cx + 0.5) / coarseness - 0.5;
    camera.cy = (camera.cy + 0.5) / coarseness - 0.5;
    return camera;
  }

  double scale;
  Silhouette silhouette;
};

}  // namespace

std::vector<double> facing_camera(const PosedHand& posed, const Camera& camera) {
  const Eigen::Vector3d eye = camera.center_in_world();
  const std::vector<Eigen::Vector3d>& vertices = posed.vertices();
  std::vector<double> facing(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    facing[i] = posed.normals()[i].dot(eye - vertices[i]);
  }
  return facing;
}

std::vector<OutlinePoint> hand_outline(const FitHand& hand, const PosedHand& posed,
                                       const Camera& camera, int coarseness) {
  const DrawnHand drawn(hand, posed, camera, coarseness);
  const std::vector<Eigen::Vector3d>& vertices = posed.vertices();
  const std::vector<Eigen::Vector3d>& normals = posed.normals();
  const std::vector<double> facing = facing_camera(posed, camera);

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
    if (drawn.covers(*pixel + kProbePx * direction)) continue;
    if (!drawn.covers(*pixel - kProbePx * direction)) continue;
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
