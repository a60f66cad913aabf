// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "peers/peers.h"

namespace tegata::bench {
namespace {

// The homogeneous pixel of voxel (x, y, z)'s centre is offset + x * by[0] + y * by[1] + z * by[2],
// with half a pixel added so that truncation rounds.
struct Projection {
  std::array<float, 3> offset, by[3];
  const std::uint8_t* mask;
  std::uint32_t width, height;
};

Projection projection_of(const FlatView& view, const FlatCube& cube) {
  Projection projection;
  const auto& m = view.camera_from_world;
  const std::array<std::array<double, 3>, 3> intrinsics = {
      {{view.fx, 0.0, view.cx + 0.5}, {0.0, view.fy, view.cy + 0.5}, {0.0, 0.0, 1.0}}};
  for (std::size_t row = 0; row < 3; ++row) {
    std::array<double, 4> pixel_from_world = {};
    for (std::size_t column = 0; column < 4; ++column) {
      for (std::size_t k = 0; k < 3; ++k) {
        pixel_from_world[column] += intrinsics[row][k] * m[4 * k + column];
      }
    }
    double offset = pixel_from_world[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      offset += pixel_from_world[axis] * (cube.origin[axis] + 0.5 * cube.voxel_size);
      projection.by[axis][row] = static_cast<float>(pixel_from_world[axis] * cube.voxel_size);
    }
    projection.offset[row] = static_cast<float>(offset);
  }
  projection.mask = view.mask.data();
  projection.width = static_cast<std::uint32_t>(view.width);
  projection.height = static_cast<std::uint32_t>(view.height);
  return projection;
}

}  // namespace

std::size_t carve_slab_naively(const std::vector<FlatView>& views, const FlatCube& cube,
                               int first_z, int end_z, std::vector<std::uint8_t>& inside) {
  const auto side = static_cast<std::size_t>(cube.voxels);
  std::vector<Projection> projections;
  for (const FlatView& view : views) projections.push_back(projection_of(view, cube));
  std::vector<std::array<float, 3>> row(projections.size());

  std::size_t count = 0;
  std::uint8_t* out = inside.data() + static_cast<std::size_t>(first_z) * side * side;
  for (int z = first_z; z < end_z; ++z) {
    for (int y = 0; y < cube.voxels; ++y) {
      for (std::size_t v = 0; v < row.size(); ++v) {
        const Projection& p = projections[v];
        for (std::size_t i = 0; i < 3; ++i) {
          row[v][i] =
              p.offset[i] + static_cast<float>(y) * p.by[1][i] + static_cast<float>(z) * p.by[2][i];
        }
      }
      for (int x = 0; x < cube.voxels; ++x) {
        const float along = static_cast<float>(x);
        std::uint8_t keep = 1;
        for (std::size_t v = 0; v < row.size(); ++v) {
          const Projection& p = projections[v];
          const float depth = row[v][2] + along * p.by[0][2];
          const float scale = 1.0f / depth;
          // Left of the picture or above it comes out as a huge number.
          const auto column = static_cast<std::uint32_t>(
              static_cast<std::int32_t>((row[v][0] + along * p.by[0][0]) * scale));
          const auto line = static_cast<std::uint32_t>(
              static_cast<std::int32_t>((row[v][1] + along * p.by[0][1]) * scale));
          if (!(depth > 0.0f) || column >= p.width || line >= p.height ||
              p.mask[line * p.width + column] == 0) {
            keep = 0;
            break;
          }
        }
        *out++ = keep;
        count += keep;
      }
    }
  }
  return count;
}

std::size_t carve_naively(const std::vector<FlatView>& views, const FlatCube& cube,
                          std::vector<std::uint8_t>& inside) {
  const auto side = static_cast<std::size_t>(cube.voxels);
  inside.resize(side * side * side);
  return carve_slab_naively(views, cube, 0, cube.voxels, inside);
}

}  // namespace tegata::bench
