// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// For the room's own tests: what a surface that crosses itself encloses.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "tegata/hand/hand_model.h"

namespace tegata::test {

/// The volumes [m^3] that a closed surface winds around once or more, twice or more, and wrong side
/// out.
struct WindingVolume {
  double solid = 0.0, overlap = 0.0, inverted = 0.0;
};

/// By columns along z, `step` [m] apart.
inline WindingVolume winding_volume(const TriangleMesh& mesh, double step) {
  // Where columns enter and leave, by column.
  std::map<std::pair<int, int>, std::vector<std::pair<double, int>>> columns;
  const auto first = [&](double low) { return static_cast<int>(std::ceil(low / step)); };
  for (const Triangle& triangle : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]],
                          &c = mesh.vertices[triangle[2]];
    const Eigen::Vector3d u = b - a, v = c - a;
    const double area = u.x() * v.y() - u.y() * v.x();
    if (area == 0.0) continue;
    const Eigen::Vector3d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    for (int i = first(low.x()); i * step <= high.x(); ++i) {
      for (int j = first(low.y()); j * step <= high.y(); ++j) {
        const double x = i * step - a.x(), y = j * step - a.y();
        const double s = (x * v.y() - y * v.x()) / area, t = (u.x() * y - u.y() * x) / area;
        if (s < 0.0 || t < 0.0 || s + t > 1.0) continue;
        columns[{i, j}].push_back({a.z() + s * u.z() + t * v.z(), area > 0.0 ? -1 : 1});
      }
    }
  }
  WindingVolume volume;
  for (auto& [place, crossings] : columns) {
    std::sort(crossings.begin(), crossings.end());
    int winding = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
      winding += crossings[i].second;
      const double part = (crossings[i + 1].first - crossings[i].first) * step * step;
      if (winding >= 1) volume.solid += part;
      if (winding >= 2) volume.overlap += part;
      if (winding < 0) volume.inverted += part;
    }
  }
  return volume;
}

/// The part of a hand's surface whose vertices move most with a digit's bones, closed by a fan.
inline TriangleMesh digit_surface(const HandModel& model, const TriangleMesh& surface, int digit) {
  const auto is_inside = [&](std::uint32_t vertex) {
    const int bone = main_bone(model.links[vertex]);
    return bone > 0 && (bone - 1) / 3 == digit;
  };
  TriangleMesh part;
  part.vertices = surface.vertices;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const Triangle& t : surface.triangles) {
    if (!is_inside(t[0]) || !is_inside(t[1]) || !is_inside(t[2])) continue;
    part.triangles.push_back(t);
    for (std::size_t i = 0; i < 3; ++i) ++sides[{t[i], t[(i + 1) % 3]}];
  }
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> border;
  for (const auto& [side, count] : sides) {
    if (sides.contains({side.second, side.first})) continue;
    border.push_back(side);
    middle += surface.vertices[side.first];
  }
  const auto center = static_cast<std::uint32_t>(part.vertices.size());
  part.vertices.push_back(middle / static_cast<double>(border.size()));
  for (const auto& [a, b] : border) part.triangles.push_back({b, a, center});
  return part;
}

/// Two surfaces as one mesh.
inline TriangleMesh side_by_side(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh both = a;
  const auto first = static_cast<std::uint32_t>(a.vertices.size());
  both.vertices.insert(both.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Triangle& t : b.triangles) {
    both.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return both;
}

}  // namespace tegata::test
