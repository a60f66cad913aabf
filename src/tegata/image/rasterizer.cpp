// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// J. Pineda: A Parallel Algorithm for Polygon Rasterization. SIGGRAPH 1988. Corners are rounded to
// a grid of 1/1024 pixel, so that edge functions are whole numbers and a pixel centre on a shared
// edge belongs to exactly one of the two triangles (the top-left rule).
#include "tegata/image/rasterizer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

#include "tegata/image/lens_range.h"

namespace tegata {
namespace {

constexpr int kGridBits = 10;
constexpr std::int64_t kGrid = std::int64_t{1} << kGridBits;
// Farther corners are not drawn; edge functions stay below 2^60.
constexpr double kFarthest = 1 << 18;

struct Corner {
  std::int64_t x = 0, y = 0;  // in kGrid-ths of a pixel
  double inverse_depth = 0.0;
  bool visible = false;
};

// To the nearest grid point, for what is nearer than kFarthest pixels.
std::int64_t on_grid(double pixels) {
  constexpr std::int64_t kOffset = std::int64_t{1} << 40;  // makes it positive: cut off is down
  return static_cast<std::int64_t>(pixels * static_cast<double>(kGrid) +
                                   (static_cast<double>(kOffset) + 0.5)) -
         kOffset;
}

std::vector<Corner> project_corners(std::span<const Eigen::Vector3d> vertices,
                                    const Camera& camera) {
  const double radius = invertible_radius(camera);
  const bool is_ideal = !camera.is_distorted();
  const Eigen::Matrix3d rotation = camera.camera_from_world.rotation.toRotationMatrix();
  std::vector<Corner> corners(vertices.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d point = rotation * vertices[i] + camera.camera_from_world.translation;
    Eigen::Vector2d pixel;
    if (is_ideal) {
      if (!(point.z() > 0.0)) continue;
      pixel = {camera.fx * (point.x() / point.z()) + camera.cx,
               camera.fy * (point.y() / point.z()) + camera.cy};
    } else {
      const auto projected = project_camera_point(camera, point);
      if (!projected || point.head<2>().norm() > radius * point.z()) continue;
      pixel = *projected;
    }
    if (!(pixel.cwiseAbs().maxCoeff() < kFarthest)) continue;
    corners[i] = {on_grid(pixel.x()), on_grid(pixel.y()), 1.0 / point.z(), true};
  }
  return corners;
}

// The edge function of a -> b: positive on the inner side of a triangle of positive area.
struct Edge {
  Edge(const Corner& a, const Corner& b, int x, int y)
      : step_x((a.y - b.y) * kGrid),
        step_y((b.x - a.x) * kGrid),
        at_row((b.x - a.x) * (y * kGrid - a.y) - (b.y - a.y) * (x * kGrid - a.x)),
        threshold(b.y < a.y || (b.y == a.y && b.x > a.x) ? 0 : 1) {}

  std::int64_t step_x, step_y;
  std::int64_t at_row;     // at the first pixel of the row
  std::int64_t threshold;  // 0 for top and left edges, whose own points belong to the triangle
};

std::int64_t twice_area(const Corner& a, const Corner& b, const Corner& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

struct PixelBox {
  int left, top, right, bottom;  // inclusive
};

PixelBox pixel_box(const std::array<Corner, 3>& c, const Camera& camera) {
  const auto [left, right] = std::minmax({c[0].x, c[1].x, c[2].x});
  const auto [top, bottom] = std::minmax({c[0].y, c[1].y, c[2].y});
  const auto up = [](std::int64_t v) { return static_cast<int>((v + kGrid - 1) >> kGridBits); };
  const auto down = [](std::int64_t v) { return static_cast<int>(v >> kGridBits); };
  return {std::max(0, up(left)), std::max(0, up(top)), std::min(camera.width - 1, down(right)),
          std::min(camera.height - 1, down(bottom))};
}

// The pixels first_x .. last_x of row y, where 1 / depth begins with a value and changes by a step.
struct PixelRun {
  int y, first_x, last_x;
  double inverse_depth, inverse_depth_step;
};

// Calls visit(run) for every row of pixel centres in the triangle; its depths only where asked for.
template <bool kDepths, typename Visit>
void scan_triangle(std::array<Corner, 3> c, const Camera& camera, Faces faces, const Visit& visit) {
  // With y down, a triangle that runs counter-clockwise has a negative area.
  std::int64_t area = twice_area(c[0], c[1], c[2]);
  if (area == 0 || (area > 0 && faces == Faces::front)) return;
  if (area < 0) {
    std::swap(c[1], c[2]);
    area = -area;
  }
  const PixelBox box = pixel_box(c, camera);
  if (box.left > box.right) return;
  Edge e0(c[1], c[2], box.left, box.top), e1(c[2], c[0], box.left, box.top),
      e2(c[0], c[1], box.left, box.top);
  // 1 / z is linear in the picture: the corners' values weighted by the opposite edges' functions.
  const auto inverse_depth = [&](std::int64_t v0, std::int64_t v1, std::int64_t v2) {
    return (static_cast<double>(v0) * c[0].inverse_depth +
            static_cast<double>(v1) * c[1].inverse_depth +
            static_cast<double>(v2) * c[2].inverse_depth) /
           static_cast<double>(area);
  };
  for (int y = box.top; y <= box.bottom; ++y) {
    std::int64_t v0 = e0.at_row - e0.threshold, v1 = e1.at_row - e1.threshold,
                 v2 = e2.at_row - e2.threshold;
    // Inside is where no value is negative; a triangle is convex, so that is one run.
    int x = box.left;
    for (; x <= box.right && (v0 | v1 | v2) < 0; ++x) {
      v0 += e0.step_x;
      v1 += e1.step_x;
      v2 += e2.step_x;
    }
    if (x <= box.right) {
      PixelRun run{y, x, x, 0.0, 0.0};
      if constexpr (kDepths) {
        run.inverse_depth = inverse_depth(v0 + e0.threshold, v1 + e1.threshold, v2 + e2.threshold);
        run.inverse_depth_step = inverse_depth(e0.step_x, e1.step_x, e2.step_x);
      }
      for (; run.last_x < box.right; ++run.last_x) {
        v0 += e0.step_x;
        v1 += e1.step_x;
        v2 += e2.step_x;
        if ((v0 | v1 | v2) < 0) break;
      }
      visit(run);
    }
    e0.at_row += e0.step_y;
    e1.at_row += e1.step_y;
    e2.at_row += e2.step_y;
  }
}

// Calls visit(run, triangle) for every row of pixel centres in every triangle.
template <bool kDepths, typename Visit>
void scan_triangles(std::span<const Eigen::Vector3d> vertices, std::span<const Triangle> triangles,
                    const Camera& camera, Faces faces, const Visit& visit) {
  const std::vector<Corner> corners = project_corners(vertices, camera);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    const std::array<Corner, 3> c = {corners[t[0]], corners[t[1]], corners[t[2]]};
    if (!c[0].visible || !c[1].visible || !c[2].visible) continue;
    scan_triangle<kDepths>(c, camera, faces,
                           [&](const PixelRun& run) { visit(run, static_cast<std::int32_t>(i)); });
  }
}

// Where a row of pixels enters one more triangle or leaves one: at the first pixel behind.
struct Crossing {
  int x, y, change;
};

// Of an edge that triangles have, more of them by `change` to its right than to its left on the way
// from one end to the other: where it runs up (in the picture) they begin, where it runs down they
// end. By the top-left rule pixel centres on the beginning belong to a triangle, those on the end
// do not, nor those in the lowest row.
void add_crossings(const Corner& from, const Corner& to, int change, const Camera& camera,
                   std::vector<Crossing>& crossings) {
  if (from.y == to.y) return;
  const bool begins = to.y < from.y;
  const Corner &top = begins ? to : from, &bottom = begins ? from : to;
  const auto up = [](std::int64_t v) { return (v + kGrid - 1) >> kGridBits; };
  const std::int64_t first = std::max<std::int64_t>(0, up(top.y));
  const std::int64_t end = std::min<std::int64_t>(camera.height, up(bottom.y));
  if (first >= end) return;
  // x is a whole number of pixels and a rest, both of which grow by the same from row to row.
  const std::int64_t rise = bottom.y - top.y, run = bottom.x - top.x, whole = rise * kGrid;
  const auto floor_of = [&](std::int64_t v) { return v / whole - (v % whole < 0 ? 1 : 0); };
  const std::int64_t start = top.x * rise + run * (first * kGrid - top.y), step = run * kGrid;
  std::int64_t x = floor_of(start), rest = start - x * whole;
  const std::int64_t x_step = floor_of(step), rest_step = step - x_step * whole;
  for (std::int64_t y = first; y < end; ++y) {
    const std::int64_t behind = x + (rest > 0 ? 1 : 0);
    crossings.push_back({static_cast<int>(std::clamp<std::int64_t>(behind, 0, camera.width)),
                         static_cast<int>(y), begins ? change : -change});
    x += x_step;
    rest += rest_step;
    if (rest >= whole) {
      rest -= whole;
      ++x;
    }
  }
}

// Fills what lies in one triangle or more.
void fill_between(const std::vector<Crossing>& crossings, Silhouette& silhouette) {
  const auto rows = static_cast<std::size_t>(silhouette.height());
  std::vector<std::size_t> ends(rows + 1, 0);
  for (const Crossing& crossing : crossings) ++ends[static_cast<std::size_t>(crossing.y) + 1];
  for (std::size_t y = 0; y < rows; ++y) ends[y + 1] += ends[y];
  std::vector<Crossing> sorted(crossings.size());
  for (const Crossing& crossing : crossings) {
    sorted[ends[static_cast<std::size_t>(crossing.y)]++] = crossing;
  }
  std::size_t first = 0;
  for (std::size_t y = 0; y < rows; ++y) {
    const std::size_t end = ends[y];
    for (std::size_t i = first + 1; i < end; ++i) {
      const Crossing moved = sorted[i];
      std::size_t place = i;
      for (; place > first && sorted[place - 1].x > moved.x; --place) {
        sorted[place] = sorted[place - 1];
      }
      sorted[place] = moved;
    }
    int depth = 0;
    for (std::size_t i = first; i < end; ++i) {
      depth += sorted[i].change;
      if (depth <= 0 || i + 1 == end) continue;
      std::fill_n(&silhouette(0, static_cast<int>(y)) + sorted[i].x, sorted[i + 1].x - sorted[i].x,
                  PixelLabel::hand);
    }
    first = end;
  }
}

}  // namespace

RenderedMesh render(const TriangleMesh& mesh, const Camera& camera) {
  RenderedMesh picture{
      Image<float>(camera.width, camera.height, std::numeric_limits<float>::infinity()),
      Image<std::int32_t>(camera.width, camera.height, -1)};
  scan_triangles<true>(mesh.vertices, mesh.triangles, camera, Faces::all,
                       [&](const PixelRun& run, std::int32_t triangle) {
                         for (int x = run.first_x; x <= run.last_x; ++x) {
                           const double inverse_depth =
                               run.inverse_depth + (x - run.first_x) * run.inverse_depth_step;
                           const float depth = static_cast<float>(1.0 / inverse_depth);
                           // Of two at the same depth the first one stays.
                           if (depth >= picture.depth(x, run.y)) continue;
                           picture.depth(x, run.y) = depth;
                           picture.triangle(x, run.y) = triangle;
                         }
                       });
  return picture;
}

Silhouette render_silhouette(const TriangleMesh& mesh, const Camera& camera, Faces faces) {
  return render_silhouette(mesh.vertices, mesh.triangles, camera, faces);
}

Silhouette render_silhouette(std::span<const Eigen::Vector3d> vertices,
                             std::span<const Triangle> triangles, const Camera& camera,
                             Faces faces) {
  Silhouette silhouette(camera.width, camera.height, PixelLabel::background);
  scan_triangles<false>(vertices, triangles, camera, faces, [&](const PixelRun& run, std::int32_t) {
    std::fill_n(&silhouette(run.first_x, run.y), run.last_x - run.first_x + 1, PixelLabel::hand);
  });
  return silhouette;
}

EdgedTriangles::EdgedTriangles(std::span<const Triangle> faces)
    : triangles(faces.begin(), faces.end()) {
  struct Half {
    std::uint32_t low, high;
    std::int32_t triangle;
    bool is_forth;  // from low to high
  };
  std::vector<Half> halves;
  halves.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangles[t][i], to = triangles[t][(i + 1) % 3];
      halves.push_back(
          {std::min(from, to), std::max(from, to), static_cast<std::int32_t>(t), from < to});
    }
  }
  std::stable_sort(halves.begin(), halves.end(), [](const Half& a, const Half& b) {
    return std::tie(a.low, a.high) < std::tie(b.low, b.high);
  });
  for (std::size_t i = 0; i < halves.size(); ++i) {
    const Half& half = halves[i];
    Edge edge{half.low, half.high, -1, -1};
    (half.is_forth ? edge.forth : edge.back) = half.triangle;
    if (i + 1 < halves.size()) {
      const Half& next = halves[i + 1];
      if (next.low == half.low && next.high == half.high && next.is_forth != half.is_forth) {
        (next.is_forth ? edge.forth : edge.back) = next.triangle;
        ++i;
      }
    }
    edges.push_back(edge);
  }
}

Silhouette render_silhouette(std::span<const Eigen::Vector3d> vertices,
                             const EdgedTriangles& surface, const Camera& camera, Faces faces) {
  const std::vector<Corner> corners = project_corners(vertices, camera);
  // 1 where a triangle faces the camera, -1 where it faces away and counts, 0 where it does not.
  std::vector<std::int8_t> facing(surface.triangles.size());
  const int away = faces == Faces::all ? -1 : 0;
  for (std::size_t i = 0; i < facing.size(); ++i) {
    const Triangle& t = surface.triangles[i];
    const Corner &a = corners[t[0]], &b = corners[t[1]], &c = corners[t[2]];
    if (!a.visible || !b.visible || !c.visible) continue;
    // With y down, a triangle that runs counter-clockwise has a negative area.
    const std::int64_t area = twice_area(a, b, c);
    facing[i] = static_cast<std::int8_t>(area < 0 ? 1 : area > 0 ? away : 0);
  }
  const auto at = [&](std::int32_t triangle) {
    return triangle < 0 ? 0 : static_cast<int>(facing[static_cast<std::size_t>(triangle)]);
  };
  std::vector<Crossing> crossings;
  for (const EdgedTriangles::Edge& edge : surface.edges) {
    const int change = at(edge.forth) - at(edge.back);
    if (change == 0) continue;
    // add_crossings() has what faces the camera on the other side.
    add_crossings(corners[edge.b], corners[edge.a], change, camera, crossings);
  }
  Silhouette silhouette(camera.width, camera.height, PixelLabel::background);
  fill_between(crossings, silhouette);
  return silhouette;
}

}  // namespace tegata
