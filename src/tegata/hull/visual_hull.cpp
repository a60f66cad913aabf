// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hull/visual_hull.h"

#include "tegata/base/error.h"
#include "tegata/base/stopwatch.h"
#include "tegata/hull/hull_region.h"
#include "tegata/hull/leaf_components.h"
#include "tegata/hull/marching_cubes.h"
#include "tegata/hull/octree_division.h"
#include "tegata/hull/silhouette_field.h"
#include "tegata/mesh/simplify.h"

namespace tegata {
namespace {

SparseField carve_field(SilhouetteField& field, const Eigen::AlignedBox3d& region,
                        double voxel_size) {
  const OctreeRoot root = root_around(region, voxel_size);
  field.prepare_sampling(root);
  return OctreeDivision<SilhouetteField>(root, field).run();
}

}  // namespace

Eigen::AlignedBox3d find_region(const std::vector<HullView>& views, const HullOptions& options) {
  return locate_region(SilhouetteField(views, options));
}

SparseField carve(const std::vector<HullView>& views, const Eigen::AlignedBox3d& region,
                  const HullOptions& options) {
  SilhouetteField field(views, options);
  return carve_field(field, region, options.voxel_size);
}

TriangleMesh visual_hull(const std::vector<HullView>& views, const HullOptions& options,
                         HullReport* report) {
  HullReport made;
  const Stopwatch searching;
  SilhouetteField field(views, options);
  made.region = locate_region(field);
  made.region_seconds = searching.seconds();

  const Stopwatch carving;
  const SparseField carved = carve_field(field, made.region, options.voxel_size);
  made.levels = carved.levels;
  made.carve_seconds = carving.seconds();
  if (carved.leaves.empty()) {
    throw Error("hull: nothing is left at voxel_size = ", options.voxel_size, " m of a region of (",
                made.region.sizes().transpose(),
                ") m: what the silhouettes have in common is thinner than a voxel");
  }

  const Stopwatch extracting;
  TriangleMesh mesh =
      extract_isosurface(without_small_components(carved, options.smallest_component));
  made.raw_triangle_count = mesh.triangles.size();
  made.isosurface_seconds = extracting.seconds();

  const Stopwatch simplifying;
  if (options.triangle_count > 0) {
    mesh = simplify(mesh, options.triangle_count, options.largest_error);
  }
  made.simplify_seconds = simplifying.seconds();
  made.triangle_count = mesh.triangles.size();
  made.volume = enclosed_volume(mesh);
  if (report != nullptr) *report = made;
  return mesh;
}

}  // namespace tegata
