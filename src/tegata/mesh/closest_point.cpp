// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/mesh/closest_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "tegata/base/error.h"

namespace tegata {
namespace {

// Cells are made so large that one on the surface of the points' box would hold about so many.
constexpr double kPointsPerCell = 3.0;
constexpr double kMostCellsPerPoint = 1.0;
// By how much of a cell a search looks further than it must: covers the rounding of cell indices.
constexpr double kSlack = 1e-6;
constexpr std::uint32_t kTrianglesPerLeaf = 4;

// The cell of a coordinate that is given in cells; the first one for what is not a number.
int clamped_cell(double coordinate, int cell_count) {
  if (!(coordinate > 0.0)) return 0;
  return coordinate < cell_count - 1 ? static_cast<int>(coordinate) : cell_count - 1;
}

Eigen::Vector3d closest_point_on_segment(const Eigen::Vector3d& query, const Eigen::Vector3d& a,
                                         const Eigen::Vector3d& b) {
  const Eigen::Vector3d ab = b - a;
  const double length2 = ab.squaredNorm();
  if (length2 <= 0.0) return a;
  return a + std::clamp(ab.dot(query - a) / length2, 0.0, 1.0) * ab;
}

}  // namespace

NearestPoint::NearestPoint(std::vector<Eigen::Vector3d> points) : points_(std::move(points)) {
  if (points_.empty()) throw Error("nearest point: got no points, expected one or more");
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!points_[i].allFinite()) {
      throw Error("nearest point: point ", i, " is (", points_[i].transpose(),
                  "), expected finite numbers");
    }
  }
  choose_cells();
  std::vector<std::uint32_t> cells(points_.size());
  cell_start_.assign(static_cast<std::size_t>(cells_per_axis_.prod()) + 1, 0);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Eigen::Vector3d in_cells = (points_[i] - origin_) * cells_per_metre_;
    const int x = clamped_cell(in_cells.x(), cells_per_axis_.x());
    const int y = clamped_cell(in_cells.y(), cells_per_axis_.y());
    const int z = clamped_cell(in_cells.z(), cells_per_axis_.z());
    cells[i] = static_cast<std::uint32_t>(first_of_row(y, z) + static_cast<std::size_t>(x));
    ++cell_start_[cells[i]];
  }
  // Ends of the cells' runs first; placing the points from the last one on makes them beginnings.
  std::partial_sum(cell_start_.begin(), cell_start_.end(), cell_start_.begin());
  sorted_.resize(points_.size());
  for (std::size_t i = points_.size(); i-- > 0;) {
    sorted_[--cell_start_[cells[i]]] = {points_[i], static_cast<std::uint32_t>(i)};
  }
}

// The size and number of cells for points that lie on a surface, more or less; cells of points on a
// line or in one place come out right as well.
void NearestPoint::choose_cells() {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points_) box.extend(point);
  const auto count = static_cast<double>(points_.size());
  const Eigen::Vector3d side = box.sizes();
  const double area = 2.0 * (side.x() * side.y() + side.y() * side.z() + side.z() * side.x());
  origin_ = box.min();
  cell_size_ = std::max(std::sqrt(kPointsPerCell * area / count), side.maxCoeff() / count);
  if (!(cell_size_ > 0.0) || !std::isfinite(cell_size_)) {
    cell_size_ = side.maxCoeff() > 0.0 ? side.maxCoeff() : 1.0;
  }
  Eigen::Array3d cells = (side.array() / cell_size_).floor() + 1.0;
  while (cells.prod() > kMostCellsPerPoint * count + 64.0) {
    cell_size_ *= 1.25;
    cells = (side.array() / cell_size_).floor() + 1.0;
  }
  cells_per_axis_ = cells.cast<int>();
  cells_per_metre_ = 1.0 / cell_size_;
}

struct NearestPoint::Search {
  Eigen::Vector3d query;
  Eigen::Array3i cell;  // where the query, or the grid's nearest point to it, lies
  double best2 = std::numeric_limits<double>::infinity();
  std::uint32_t index = 0;
};

void NearestPoint::search_run(std::size_t first_cell, std::size_t last_cell, Search& search) const {
  for (std::uint32_t i = cell_start_[first_cell]; i < cell_start_[last_cell + 1]; ++i) {
    const double distance2 = (sorted_[i].point - search.query).squaredNorm();
    if (distance2 < search.best2 ||
        (distance2 == search.best2 && sorted_[i].index < search.index)) {
      search.best2 = distance2;
      search.index = sorted_[i].index;
    }
  }
}

// A lower bound of the square of a coordinate's distance to those of a cell.
double NearestPoint::distance2_to_cell(double query, int axis, int cell) const {
  const double low = origin_[axis] + (cell - kSlack) * cell_size_;
  const double distance =
      std::max({low - query, query - low - (1.0 + 2.0 * kSlack) * cell_size_, 0.0});
  return distance * distance;
}

// The cells that are `radius` cells away along one axis and not more along the others, but for rows
// that are too far away.
void NearestPoint::search_shell(int radius, Search& search) const {
  const Eigen::Array3i low = (search.cell - radius).max(0);
  const Eigen::Array3i high = (search.cell + radius).min(cells_per_axis_ - 1);
  for (int z = low.z(); z <= high.z(); ++z) {
    const double z2 = distance2_to_cell(search.query.z(), 2, z);
    if (z2 > search.best2) continue;
    const bool is_end = std::abs(z - search.cell.z()) == radius;
    for (int y = low.y(); y <= high.y(); ++y) {
      if (z2 + distance2_to_cell(search.query.y(), 1, y) > search.best2) continue;
      const auto cell_at = [row = first_of_row(y, z)](int x) {
        return row + static_cast<std::size_t>(x);
      };
      if (is_end || std::abs(y - search.cell.y()) == radius) {
        search_run(cell_at(low.x()), cell_at(high.x()), search);
        continue;
      }
      const int left = search.cell.x() - radius, right = search.cell.x() + radius;
      if (left >= 0) search_run(cell_at(left), cell_at(left), search);
      if (right < cells_per_axis_.x()) search_run(cell_at(right), cell_at(right), search);
    }
  }
}

NearestPoint::Match NearestPoint::nearest(const Eigen::Vector3d& query) const {
  Search search{.query = query, .cell = Eigen::Array3i::Zero()};
  // `inside` is the query moved to the nearest point of the grid; because the grid is convex,
  // |query - p|^2 >= |query - inside|^2 + |inside - p|^2 for each of its points p.
  Eigen::Vector3d inside;
  double to_next_cell = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const int count = cells_per_axis_[axis];
    const double coordinate = (query[axis] - origin_[axis]) * cells_per_metre_;
    const double within = std::clamp(coordinate, 0.0, static_cast<double>(count));
    const int cell = clamped_cell(coordinate, count);
    search.cell[axis] = cell;
    inside[axis] = origin_[axis] + cell_size_ * within;
    to_next_cell = std::min({to_next_cell, within - cell, cell + 1 - within});
  }
  const double outside2 = (query - inside).squaredNorm();
  const int farthest = cells_per_axis_.maxCoeff();
  for (int radius = 0; radius < farthest; ++radius) {
    const double reach = cell_size_ * std::max(radius - 1 + to_next_cell - kSlack, 0.0);
    if (radius > 0 && outside2 * (1.0 - kSlack) + reach * reach > search.best2) break;
    search_shell(radius, search);
  }
  return {search.index, std::sqrt(search.best2)};
}

NearestSurface::NearestSurface(const TriangleMesh& mesh) : mesh_(mesh) {
  check_mesh(mesh_);
  if (mesh_.triangles.empty()) {
    throw Error("nearest surface: got a mesh without triangles, expected one or more");
  }
  std::vector<Eigen::Vector3d> centers;
  centers.reserve(mesh_.triangles.size());
  for (const Triangle& t : mesh_.triangles) {
    centers.push_back((mesh_.vertices[t[0]] + mesh_.vertices[t[1]] + mesh_.vertices[t[2]]) / 3.0);
  }
  order_.resize(mesh_.triangles.size());
  std::iota(order_.begin(), order_.end(), 0u);
  nodes_.push_back({.box = {}, .first = 0, .count = static_cast<std::uint32_t>(order_.size())});
  split(0, centers);
}

// Fits a node's box and, where it has many triangles, divides them at the median of their centres
// along the axis on which these spread most.
void NearestSurface::split(std::uint32_t node, std::vector<Eigen::Vector3d>& centers) {
  const std::uint32_t first = nodes_[node].first, count = nodes_[node].count;
  Eigen::AlignedBox3d spread;
  for (std::uint32_t i = first; i < first + count; ++i) {
    for (const std::uint32_t v : mesh_.triangles[order_[i]]) {
      nodes_[node].box.extend(mesh_.vertices[v]);
    }
    spread.extend(centers[order_[i]]);
  }
  if (count <= kTrianglesPerLeaf) return;
  Eigen::Index axis = 0;
  spread.sizes().maxCoeff(&axis);
  const std::uint32_t half = count / 2;
  std::nth_element(order_.begin() + first, order_.begin() + first + half,
                   order_.begin() + first + count, [&](std::uint32_t a, std::uint32_t b) {
                     return std::pair(centers[a][axis], a) < std::pair(centers[b][axis], b);
                   });
  const auto child = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].first = child;
  nodes_[node].count = 0;
  nodes_.push_back({.box = {}, .first = first, .count = half});
  nodes_.push_back({.box = {}, .first = first + half, .count = count - half});
  split(child, centers);
  split(child + 1, centers);
}

NearestSurface::Match NearestSurface::nearest(const Eigen::Vector3d& query) const {
  struct Pending {
    std::uint32_t node;
    double distance2;
  };
  // The tree halves 2^32 triangles at most, and each level leaves one child waiting.
  std::array<Pending, 64> stack;
  std::size_t waiting = 0;
  stack[waiting++] = {0, 0.0};
  Match best{.point = query};
  double best2 = std::numeric_limits<double>::infinity();
  while (waiting > 0) {
    const Pending pending = stack[--waiting];
    if (pending.distance2 > best2) continue;
    const Node& node = nodes_[pending.node];
    if (node.count == 0) {
      Pending near{node.first, nodes_[node.first].box.squaredExteriorDistance(query)};
      Pending far{node.first + 1, nodes_[node.first + 1].box.squaredExteriorDistance(query)};
      if (far.distance2 < near.distance2) std::swap(near, far);
      stack[waiting++] = far;
      stack[waiting++] = near;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Triangle& t = mesh_.triangles[order_[i]];
      const Eigen::Vector3d point = closest_point_on_triangle(
          query, mesh_.vertices[t[0]], mesh_.vertices[t[1]], mesh_.vertices[t[2]]);
      const double distance2 = (point - query).squaredNorm();
      if (distance2 < best2) {
        best2 = distance2;
        best = {.point = point, .triangle = order_[i]};
      }
    }
  }
  best.distance = std::sqrt(best2);
  return best;
}

Eigen::Vector3d closest_point_on_triangle(const Eigen::Vector3d& query, const Eigen::Vector3d& a,
                                          const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  constexpr double kNoArea = 1e-12;  // sine of the angle between two sides
  const Eigen::Vector3d ab = b - a, ac = c - a, bc = c - b;
  const Eigen::Vector3d normal = ab.cross(ac);
  const double area2 = normal.squaredNorm();
  const bool has_area = area2 > kNoArea * kNoArea * ab.squaredNorm() * ac.squaredNorm();
  // Within the triangle's prism the answer is the foot of the perpendicular, else it is on a side.
  const Eigen::Vector3d from_a = query - a, from_b = query - b;
  const bool within = has_area && normal.dot(ab.cross(from_a)) >= 0.0 &&
                      normal.dot(bc.cross(from_b)) >= 0.0 && normal.dot(ac.cross(from_a)) <= 0.0;
  if (within) return query - normal * (normal.dot(from_a) / area2);

  Eigen::Vector3d best = closest_point_on_segment(query, a, b);
  for (const Eigen::Vector3d& other :
       {closest_point_on_segment(query, b, c), closest_point_on_segment(query, a, c)}) {
    if ((other - query).squaredNorm() < (best - query).squaredNorm()) best = other;
  }
  return best;
}

}  // namespace tegata
