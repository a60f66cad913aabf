// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <array>

#include "benchmarks.h"
#include "flat.h"
#include "report.h"
#include "scene.h"
#include "tegata/hull/cube_cases.h"
#include "tegata/hull/marching_cubes.h"

namespace tegata::bench {
namespace {

// How many triangles VTK makes of a cell, for each of the 256 ways in which corners can be inside.
std::array<std::size_t, 256> vtk_triangles_by_case() {
  std::array<std::size_t, 256> counts{};
  for (unsigned inside = 0; inside < 256; ++inside) {
    const auto cell = std::make_shared<FlatField>(FlatField{{}, 2, 1.0f});
    for (unsigned i = 0; i < 8; ++i) cell->values.push_back((inside >> i & 1u) != 0 ? 1.0f : -1.0f);
    counts[inside] = vtk_marching_cubes(cell, false)();
  }
  return counts;
}

// Cell by cell: the surface is the same wherever the two fill a case with as many triangles.
void check_counts(const SparseField& field, const TriangleMesh& mesh, std::size_t vtk_count,
                  const std::string& work, Report& report) {
  static const std::array<std::size_t, 256> vtk_counts = vtk_triangles_by_case();
  std::size_t ours_expected = 0, vtk_expected = 0, differing_cells = 0;
  for (const OctreeLeaf& leaf : field.leaves) {
    unsigned inside = 0;
    for (unsigned i = 0; i < 8; ++i) inside |= (leaf.field[i] > 0.0f ? 1u : 0u) << i;
    const std::size_t ours = cube_cases()[inside].triangles.size();
    ours_expected += ours;
    vtk_expected += vtk_counts[inside];
    differing_cells += ours != vtk_counts[inside] ? 1 : 0;
  }
  report.check(work + ": as many triangles as VTK marching cubes but for ambiguous cells",
               fmt::format("{} against {}; {} of {} cells are filled with another number",
                           mesh.triangles.size(), vtk_count, differing_cells, field.leaves.size()),
               mesh.triangles.size() == ours_expected && vtk_count == vtk_expected);
  const MeshTopology topology = inspect_topology(mesh);
  report.check(work + ": closed, oriented, manifold",
               fmt::format("{} pieces", topology.component_count),
               topology.closed && topology.oriented && topology.manifold);
}

void run_case(const Scene& scene, int cube_mm, double flying_edges_bar, Report& report) {
  constexpr double kVoxelSize = 0.002;
  const HullOptions options = hull_options(scene, kVoxelSize);
  const int cells = static_cast<int>(1e-3 * cube_mm / kVoxelSize + 0.5);
  const SparseField field =
      carve(scene.views, region_of_cells(scene.center(), cells, kVoxelSize), options);
  const auto dense = std::make_shared<FlatField>(
      FlatField{dense_values(field, DenseField(scene.views, options)), lattice_of(field).points(),
                static_cast<float>(kVoxelSize)});

  const std::vector<Contestant> contestants = {
      {"tegata extract_isosurface (normals)",
       [&] { return extract_isosurface(field).triangles.size(); }},
      {"VTK FlyingEdges", vtk_flying_edges(dense, false), flying_edges_bar},
      {"VTK FlyingEdges, normals", vtk_flying_edges(dense, true)},
      {"VTK marching cubes", vtk_marching_cubes(dense, false)},
      {"VTK marching cubes, normals", vtk_marching_cubes(dense, true)},
      {"OpenVDB volumeToMesh (quads)", openvdb_volume_to_mesh(dense, false)},
      {"OpenVDB copy and volumeToMesh", openvdb_volume_to_mesh(dense, true)}};
  const std::vector<Timing> timings = run_rounds(contestants);
  const std::string work = fmt::format("{}^3 cells, {} mm", cells, cube_mm);
  report.add(work, contestants, timings);
  check_counts(field, extract_isosurface(field), timings[3].result, work, report);
}

}  // namespace

bool benchmark_isosurface() {
  Report report("B2: field to surface, 3 cameras, 2 mm");
  const Scene scene = hand_scene(3);
  run_case(scene, 256, 1.5, report);
  run_case(scene, 512, 5.0, report);
  report.note("ours reads the octree's leaves, VTK a dense field of floats with the same values");
  return report.print();
}

}  // namespace tegata::bench
