// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <omp.h>
#include <open3d/Open3DConfig.h>
#include <open3d/camera/PinholeCameraParameters.h>
#include <open3d/geometry/Image.h>
#include <open3d/geometry/TriangleMesh.h>
#include <open3d/geometry/VoxelGrid.h>

#include <limits>

#include "peers/peers.h"

namespace tegata::bench {
namespace {

struct MaskedCamera {
  open3d::camera::PinholeCameraParameters camera;
  open3d::geometry::Image mask;
};

MaskedCamera masked_camera(const FlatView& view) {
  MaskedCamera made;
  made.camera.intrinsic_.SetIntrinsics(view.width, view.height, view.fx, view.fy, view.cx, view.cy);
  made.camera.extrinsic_ = Eigen::Matrix4d::Identity();
  for (Eigen::Index i = 0; i < 12; ++i) {
    made.camera.extrinsic_(i / 4, i % 4) = view.camera_from_world[static_cast<std::size_t>(i)];
  }
  made.mask.Prepare(view.width, view.height, 1, sizeof(float));
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      *made.mask.PointerAt<float>(x, y) =
          view.mask[static_cast<std::size_t>(y * view.width + x)] == 0 ? 0.0f : 1.0f;
    }
  }
  return made;
}

}  // namespace

std::string open3d_version() { return OPEN3D_VERSION; }

void hold_open3d_to_one_thread() { omp_set_num_threads(1); }

Work open3d_carve(const std::vector<FlatView>& views, const FlatCube& cube) {
  const auto masked = std::make_shared<std::vector<MaskedCamera>>();
  for (const FlatView& view : views) masked->push_back(masked_camera(view));
  return [=] {
    const double side = cube.voxel_size * cube.voxels;
    const auto grid = open3d::geometry::VoxelGrid::CreateDense(
        Eigen::Vector3d(cube.origin[0], cube.origin[1], cube.origin[2]), Eigen::Vector3d::Zero(),
        cube.voxel_size, side, side, side);
    for (const MaskedCamera& view : *masked) grid->CarveSilhouette(view.mask, view.camera, false);
    return grid->voxels_.size();
  };
}

MeshWork open3d_quadric_decimation(const FlatMesh& mesh, std::size_t triangle_count) {
  using open3d::geometry::TriangleMesh;
  const auto input = std::make_shared<TriangleMesh>();
  for (std::size_t i = 0; i < mesh.vertices.size(); i += 3) {
    input->vertices_.push_back(Eigen::Map<const Eigen::Vector3f>(&mesh.vertices[i]).cast<double>());
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    input->triangles_.push_back(
        Eigen::Map<const Eigen::Matrix<std::uint32_t, 3, 1>>(&mesh.triangles[i]).cast<int>());
  }
  const auto output = std::make_shared<std::shared_ptr<TriangleMesh>>();
  const int count = static_cast<int>(triangle_count);
  return {[=] {
            *output = input->SimplifyQuadricDecimation(
                count, std::numeric_limits<double>::infinity(), 1.0);
            return (*output)->triangles_.size();
          },
          [=] {
            FlatMesh simplified;
            for (const Eigen::Vector3d& vertex : (*output)->vertices_) {
              for (const double x : vertex) simplified.vertices.push_back(static_cast<float>(x));
            }
            for (const Eigen::Vector3i& triangle : (*output)->triangles_) {
              for (const int corner : triangle) {
                simplified.triangles.push_back(static_cast<std::uint32_t>(corner));
              }
            }
            return simplified;
          }};
}

}  // namespace tegata::bench
