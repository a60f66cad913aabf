// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// A. Hertzmann and D. Zorin: Illustrating Smooth Surfaces (SIGGRAPH 2000), section 4: the smooth
// surface's outline is where the vertices' normals, interpolated, stand across the line of sight.
#include "tegata/fit/outline_piece.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tegata/fit/outline.h"
#include "tegata/fit/surface_row.h"
#include "tegata/image/rasterizer.h"

namespace tegata {
namespace {

// How far beside the outline the picture of the hand is asked for the hand, on either side. Less
// and the outline of a coarse mesh would be missed, more and fingers close together would look like
// one.
constexpr double kBesideOutlinePx = 1.0;
// Pieces are no longer than this.
constexpr double kLongestPx = 2.0;
// Pieces of which a smaller share is seen are left out.
constexpr double kLeastSeenShare = 0.05;

// Where the outline crosses a triangle: from the edge a -> b to the edge a -> c.
struct Crossing {
  Triangle corners;
  double to_b, to_c;

  // Of the corners at a share of the way across.
  Eigen::Vector3d fractions(double share) const {
    const double at_b = (1.0 - share) * to_b, at_c = share * to_c;
    return {1.0 - at_b - at_c, at_b, at_c};
  }
  Eigen::Vector3d blend(const std::vector<Eigen::Vector3d>& values,
                        const Eigen::Vector3d& fractions) const {
    return fractions[0] * values[corners[0]] + fractions[1] * values[corners[1]] +
           fractions[2] * values[corners[2]];
  }
};

// `facing` is positive at vertices that face the camera.
std::optional<Crossing> crossing(const Triangle& triangle, const std::vector<double>& facing) {
  const bool first = facing[triangle[0]] > 0.0, second = facing[triangle[1]] > 0.0,
             third = facing[triangle[2]] > 0.0;
  if (first == second && second == third) return std::nullopt;
  const std::size_t odd = second == third ? 0 : first == third ? 1 : 2;
  const Triangle corners = {triangle[odd], triangle[(odd + 1) % 3], triangle[(odd + 2) % 3]};
  const double at = facing[corners[0]];
  return Crossing{corners, at / (at - facing[corners[1]]), at / (at - facing[corners[2]])};
}

}  // namespace

HandPicture::HandPicture(const PosedHand& posed, const Camera& camera)
    : silhouette_(render_silhouette(posed.vertices(), posed.model().rest_surface.triangles, camera,
                                    Faces::front)) {}

double HandPicture::cover(const Eigen::Vector2d& pixel) const {
  const double left = std::floor(pixel.x()), top = std::floor(pixel.y());
  const auto at = [&](int dx, int dy) {
    const int x = static_cast<int>(left) + dx, y = static_cast<int>(top) + dy;
    return silhouette_.contains(x, y) && silhouette_(x, y) == PixelLabel::hand ? 1.0 : 0.0;
  };
  const double x = pixel.x() - left, y = pixel.y() - top;
  return (1.0 - y) * ((1.0 - x) * at(0, 0) + x * at(1, 0)) +
         y * ((1.0 - x) * at(0, 1) + x * at(1, 1));
}

std::vector<OutlinePiece> outline_pieces(const FitHand& hand, const PosedHand& posed,
                                         const Camera& camera, const HandPicture& drawn) {
  const std::vector<Eigen::Vector3d>& vertices = posed.vertices();
  const std::vector<Eigen::Vector3d>& normals = posed.normals();
  const std::vector<double> facing = facing_camera(posed, camera);
  std::vector<OutlinePiece> pieces;
  for (const Triangle& triangle : posed.model().rest_surface.triangles) {
    const std::optional<Crossing> across = crossing(triangle, facing);
    if (!across) continue;
    const auto first = project(camera, across->blend(vertices, across->fractions(0.0)));
    const auto last = project(camera, across->blend(vertices, across->fractions(1.0)));
    if (!first || !last) continue;
    const double length = (*last - *first).norm();
    const int count = std::max(1, static_cast<int>(std::ceil(length / kLongestPx)));
    for (int i = 0; i < count; ++i) {
      OutlinePiece piece;
      const double share = (i + 0.5) / count;
      piece.corners = across->corners;
      piece.fractions = across->fractions(share);
      piece.pixel = (1.0 - share) * *first + share * *last;
      if (!camera.contains(piece.pixel)) continue;
      const Eigen::Vector3d normal = across->blend(normals, piece.fractions);
      piece.normal = (camera.camera_from_world.rotation * normal).head<2>().normalized();
      if (!piece.normal.allFinite()) continue;
      const double seen = (1.0 - drawn.cover(piece.pixel + kBesideOutlinePx * piece.normal)) *
                          drawn.cover(piece.pixel - kBesideOutlinePx * piece.normal);
      if (seen < kLeastSeenShare) continue;
      piece.point = across->blend(vertices, piece.fractions);
      piece.length_px = length / count;
      piece.weight_px = seen * piece.length_px;
      piece.beyond_wrist = std::all_of(piece.corners.begin(), piece.corners.end(),
                                       [&](auto corner) { return hand.beyond_wrist[corner] != 0; });
      pieces.push_back(piece);
    }
  }
  std::stable_sort(pieces.begin(), pieces.end(), [](const OutlinePiece& a, const OutlinePiece& b) {
    return a.pixel.x() < b.pixel.x();
  });
  return pieces;
}

HandRow outline_row(const PosedHand& posed, const OutlinePiece& piece,
                    const Eigen::RowVector3d& along) {
  HandRow row;
  add_vertex_row(posed, piece.corners[0], piece.fractions[0] * along, row);
  add_vertex_row(posed, piece.corners[1], piece.fractions[1] * along, row);
  add_vertex_row(posed, piece.corners[2], piece.fractions[2] * along, row);
  return row;
}

}  // namespace tegata
