// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// What ours is compared with. Inputs are flat arrays that each peer takes into its own structures
// before the clock runs; one thread everywhere.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tegata::bench {

/// Does the whole work and returns how much came out of it.
using Work = std::function<std::size_t()>;

/// To be called before anything else; OpenVDB's hold lasts as long as what is returned.
std::shared_ptr<void> hold_openvdb_to_one_thread();
void hold_vtk_to_one_thread();
/// More than one: by oneTBB, as ours.
void give_vtk_threads(int threads);
void hold_open3d_to_one_thread();

std::string vtk_version();
std::string openvdb_version();
std::string open3d_version();
std::string cgal_version();
std::string nanoflann_version();
std::string ceres_version();

/// An ideal camera and its mask: 255 is hand, 0 background.
struct FlatView {
  int width = 0, height = 0;
  double fx = 0.0, fy = 0.0, cx = 0.0, cy = 0.0;
  std::array<double, 12> camera_from_world = {};  ///< 3 x 4, row by row
  std::vector<std::uint8_t> mask;
};

/// A cube of voxels.
struct FlatCube {
  std::array<double, 3> origin = {};  ///< lowest corner of the first voxel [m]
  double voxel_size = 0.0;            ///< [m]
  int voxels = 0;                     ///< a side
};

/// Each voxel's centre: project (single precision, incremental in neither axis but with all that
/// does not depend on x taken out of the inner loop), bounds, nearest pixel, break at background.
/// Out of the picture is background. Writes 1 or 0 for every voxel, x fastest; returns how many 1.
std::size_t carve_naively(const std::vector<FlatView>& views, const FlatCube& cube,
                          std::vector<std::uint8_t>& inside);
/// The same of the layers from `first_z` up to but not including `end_z`, for threads that share
/// the cube; `inside` has its size already.
std::size_t carve_slab_naively(const std::vector<FlatView>& views, const FlatCube& cube,
                               int first_z, int end_z, std::vector<std::uint8_t>& inside);

/// VoxelGrid::CreateDense and CarveSilhouette of each view. A voxel stays if any corner is inside.
Work open3d_carve(const std::vector<FlatView>& views, const FlatCube& cube);

/// A field of points * points * points values, x fastest, positive inside.
struct FlatField {
  std::vector<float> values;
  int points = 0;        ///< a side
  float spacing = 0.0f;  ///< [m]
};

Work vtk_flying_edges(std::shared_ptr<FlatField> field, bool normals);
Work vtk_marching_cubes(std::shared_ptr<FlatField> field, bool normals);
/// FlyingEdges of what a loop over voxels left, half way between 1 and 0. Positions in voxels.
struct FlatMesh;
FlatMesh vtk_surface_of_voxels(std::vector<std::uint8_t>& inside, int voxels);
/// volumeToMesh of a sparse grid that is there already, or (with_copy) made each time of the dense
/// one, clipped to a narrow band. Quads; no normals.
Work openvdb_volume_to_mesh(const std::shared_ptr<FlatField>& field, bool with_copy);

struct FlatMesh {
  std::vector<float> vertices;           ///< three a vertex [m]
  std::vector<std::uint32_t> triangles;  ///< three a triangle
};

/// Work whose product can be looked at: last() is that of the last run.
struct MeshWork {
  Work run;
  std::function<FlatMesh()> last;
};

MeshWork vtk_quadric_decimation(const FlatMesh& mesh, std::size_t triangle_count);
/// Topology kept.
MeshWork vtk_decimate_pro(const FlatMesh& mesh, std::size_t triangle_count);
/// Edge collapse with the default cost and placement of Lindstrom and Turk.
MeshWork cgal_lindstrom_turk(const FlatMesh& mesh, std::size_t triangle_count);
/// Edge collapse with Garland and Heckbert's plane quadrics.
MeshWork cgal_garland_heckbert(const FlatMesh& mesh, std::size_t triangle_count);
MeshWork open3d_quadric_decimation(const FlatMesh& mesh, std::size_t triangle_count);

/// Builds a k-d tree of the points, double precision, ten a leaf as by default, and finds the
/// nearest one of each query. Three numbers a point.
void nanoflann_nearest(const std::vector<double>& points, const std::vector<double>& queries,
                       std::vector<std::uint32_t>& nearest);

}  // namespace tegata::bench
