// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <cmath>

#include "benchmarks.h"
#include "flat.h"
#include "report.h"
#include "scene.h"
#include "tegata/base/error.h"
#include "tegata/hull/marching_cubes.h"

namespace tegata::bench {
namespace {

constexpr double kMostDiffering = 1e-5;  // of the lattice's points

struct Case {
  int cube_mm = 0, voxel_mm = 0;
  double naive_bar = 0.0;
  bool with_open3d = false;
};
// Open3D takes seconds a round on finer ones.
constexpr Case kCases[] = {{256, 4, 0.0, false}, {256, 2, 2.0, true},   {256, 1, 4.0, false},
                           {512, 4, 0.0, false}, {512, 2, 12.0, false}, {512, 1, 0.0, false}};
constexpr double kOpen3dBar = 200.0;

void run_case(const Scene& scene, const Case& chosen, Report& report) {
  const int cells = chosen.cube_mm / chosen.voxel_mm;
  const HullOptions options = hull_options(scene, 1e-3 * chosen.voxel_mm);
  const Eigen::AlignedBox3d region = region_of_cells(scene.center(), cells, options.voxel_size);
  const SparseField field = carve(scene.views, region, options);
  const Lattice lattice = lattice_of(field);
  if (lattice.cells != cells) {
    throw Error("bench: the octree has ", lattice.cells, " cells a side, expected ", cells);
  }

  const std::vector<FlatView> views = flat(scene.views);
  const FlatCube cube = flat_cube(field);
  std::vector<std::uint8_t> inside;
  std::vector<Contestant> contestants = {
      {"tegata carve", [&] { return carve(scene.views, region, options).leaves.size(); }},
      {"naive early-out loop", [&] { return carve_naively(views, cube, inside); },
       chosen.naive_bar}};
  if (chosen.with_open3d && scene.views.size() == 3) {
    contestants.push_back({"Open3D CarveSilhouette", open3d_carve(views, cube), kOpen3dBar});
  }
  const std::string work =
      fmt::format("{} cameras, {} mm / {} mm", scene.views.size(), chosen.cube_mm, chosen.voxel_mm);
  const std::vector<Timing> timings = run_rounds(contestants);
  report.add(work, contestants, timings);
  if (chosen.with_open3d) {
    const double volume = enclosed_volume(extract_isosurface(field));
    std::string kept = fmt::format("{}: ours encloses {:.0f} voxels", work,
                                   volume / std::pow(options.voxel_size, 3));
    for (std::size_t i = 1; i < contestants.size(); ++i) {
      kept += fmt::format(", {} keeps {}", contestants[i].name, timings[i].result);
    }
    report.note(kept);
  }

  const std::size_t differing = count_differing_points(field, DenseField(scene.views, options));
  const auto points = static_cast<double>(lattice.point_count());
  report.check(work + ": points that differ from a dense loop, at most 1e-5",
               fmt::format("{} of {:.0f}; {} leaves", differing, points, field.leaves.size()),
               static_cast<double>(differing) <= kMostDiffering * points);
}

}  // namespace

bool benchmark_hull() {
  Report report("B1: silhouettes to the octree's leaves, tables included");
  for (const int cameras : {3, 8}) {
    const Scene scene = hand_scene(cameras);
    report.note(fmt::format("{} cameras: {} hand pixels a view", cameras, scene.mean_foreground()));
    for (const Case& chosen : kCases) run_case(scene, chosen, report);
  }
  report.note(
      "the naive loop asks at voxel centres for the nearest pixel, ours at voxel corners for the "
      "distance to the silhouette's edge: its work is less, its product coarser");
  return report.print();
}

}  // namespace tegata::bench
