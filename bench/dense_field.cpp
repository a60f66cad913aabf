// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "dense_field.h"

#include <algorithm>
#include <limits>

#include "tegata/image/distance_transform.h"

namespace tegata::bench {
namespace {

// [m]; what is so far from the surface takes no peer any work.
constexpr float kFarOutside = -1.0f;

void for_each_leaf_corner(const SparseField& field, const Lattice& lattice, const auto& visit) {
  for (const OctreeLeaf& leaf : field.leaves) {
    for (std::int32_t i = 0; i < 8; ++i) {
      visit(lattice.index(leaf.index[0] + (i & 1), leaf.index[1] + (i >> 1 & 1),
                          leaf.index[2] + (i >> 2)),
            leaf.field[static_cast<std::size_t>(i)]);
    }
  }
}

}  // namespace

DenseField::DenseField(const std::vector<HullView>& views, const HullOptions& options)
    : least_views_(static_cast<std::size_t>(options.least_views)) {
  for (const HullView& source : views) {
    const Camera& camera = source.camera;
    Eigen::Matrix3d pixel_from_camera;
    pixel_from_camera << camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0;
    const Eigen::Matrix3d rotation = camera.camera_from_world.rotation.toRotationMatrix();
    views_.push_back(
        {pixel_from_camera * rotation, pixel_from_camera * camera.camera_from_world.translation,
         static_cast<double>(camera.width), static_cast<double>(camera.height),
         2.0 / (camera.fx + camera.fy), signed_distance(source.silhouette, [](PixelLabel label) {
           return label != PixelLabel::background;
         })});
  }
}

template <typename Visit>
std::size_t DenseField::for_each_seeing(const Eigen::Vector3d& point, const Visit& visit) const {
  std::size_t seeing = 0;
  for (const View& view : views_) {
    const Eigen::Vector3d h = view.pixel_from_world * point + view.pixel_offset;
    if (!(h.z() > 0.0)) continue;
    const double x = h.x() / h.z(), y = h.y() / h.z();
    if (!(x >= -0.5 && y >= -0.5 && x < view.width - 0.5 && y < view.height - 0.5)) continue;
    ++seeing;
    if (!visit(view, h.z(), x, y)) break;
  }
  return seeing;
}

float DenseField::value(const Eigen::Vector3d& point) const {
  double least = std::numeric_limits<double>::infinity();
  const std::size_t seeing =
      for_each_seeing(point, [&](const View& view, double depth, double x, double y) {
        const double pixels = sample_bilinear(view.distance, x, y);
        least = std::min(least, pixels * depth * view.metres_per_pixel);
        return true;
      });
  return seeing < least_views_ ? kFarOutside : static_cast<float>(least);
}

bool DenseField::is_inside(const Eigen::Vector3d& point) const {
  bool before_hand = true;
  const std::size_t seeing =
      for_each_seeing(point, [&](const View& view, double, double x, double y) {
        return before_hand = sample_bilinear(view.distance, x, y) > 0.0f;
      });
  return before_hand && seeing >= least_views_;
}

std::size_t Lattice::point_count() const {
  const auto side = static_cast<std::size_t>(points());
  return side * side * side;
}

std::size_t Lattice::index(std::int32_t x, std::int32_t y, std::int32_t z) const {
  const auto side = static_cast<std::size_t>(points());
  return (static_cast<std::size_t>(z) * side + static_cast<std::size_t>(y)) * side +
         static_cast<std::size_t>(x);
}

Lattice lattice_of(const SparseField& field) {
  return {field.origin, field.cell_size, std::int32_t{1} << (field.levels.size() - 1)};
}

std::size_t count_differing_points(const SparseField& field, const DenseField& dense) {
  enum : std::uint8_t { kNotSaid, kOutside, kInside };
  const Lattice lattice = lattice_of(field);
  std::vector<std::uint8_t> said(lattice.point_count(), kNotSaid);
  for_each_leaf_corner(field, lattice, [&](std::size_t point, float value) {
    said[point] = value > 0.0f ? kInside : kOutside;
  });
  std::size_t differing = 0;
  for (std::int32_t z = 1; z < lattice.cells; ++z) {
    for (std::int32_t y = 1; y < lattice.cells; ++y) {
      bool inside = false;
      for (std::int32_t x = 0; x < lattice.cells; ++x) {
        const std::uint8_t here = said[lattice.index(x, y, z)];
        if (here != kNotSaid) inside = here == kInside;
        if (x > 0 && inside != dense.is_inside(lattice.at(x, y, z))) ++differing;
      }
    }
  }
  return differing;
}

std::vector<float> dense_values(const SparseField& field, const DenseField& dense) {
  const Lattice lattice = lattice_of(field);
  std::vector<float> values(lattice.point_count(), kFarOutside);
  for (std::int32_t z = 1; z < lattice.cells; ++z) {
    for (std::int32_t y = 1; y < lattice.cells; ++y) {
      for (std::int32_t x = 1; x < lattice.cells; ++x) {
        values[lattice.index(x, y, z)] = dense.value(lattice.at(x, y, z));
      }
    }
  }
  for_each_leaf_corner(field, lattice,
                       [&](std::size_t point, float value) { values[point] = value; });
  return values;
}

}  // namespace tegata::bench
