// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <cmath>

#include "benchmarks.h"
#include "flat.h"
#include "report.h"
#include "scene.h"
#include "tegata/mesh/closest_point.h"
#include "tegata/mesh/simplify.h"

namespace tegata::bench {
namespace {

constexpr std::size_t kTriangles = 4000;
constexpr double kMostRmsMm = 0.40;

double rms_distance_mm(const TriangleMesh& from, const TriangleMesh& to) {
  const NearestSurface surface(to);
  double sum = 0.0;
  for (const Eigen::Vector3d& vertex : from.vertices) {
    const double distance = surface.nearest(vertex).distance;
    sum += distance * distance;
  }
  return 1e3 * std::sqrt(sum / static_cast<double>(from.vertices.size()));
}

std::string said_of(const MeshTopology& topology) {
  return fmt::format("{}, {}", topology.closed && topology.oriented ? "closed" : "not closed",
                     topology.manifold ? "manifold" : "not manifold");
}

MeshWork bare_meshoptimizer(const FlatMesh& mesh) {
  const auto indices = std::make_shared<std::vector<std::uint32_t>>();
  return {[=] {
            *indices = meshoptimizer_triangles(mesh, kTriangles);
            return indices->size() / 3;
          },
          [=] {
            return FlatMesh{mesh.vertices, *indices};
          }};
}

}  // namespace

bool benchmark_simplify() {
  const Scene scene = hand_scene(3);
  HullOptions options = hull_options(scene, 0.002);
  options.triangle_count = 0;
  const TriangleMesh input = visual_hull(scene.views, options);
  const FlatMesh flat_input = flat(input);
  Report report(
      fmt::format("B3: {} triangles of the 2 mm hull to {}", input.triangles.size(), kTriangles));

  struct Peer {
    std::string name;
    MeshWork work;
    double bar = 0.0;
  };
  const Peer peers[] = {
      {"VTK QuadricDecimation", vtk_quadric_decimation(flat_input, kTriangles), 10.0},
      {"VTK DecimatePro", vtk_decimate_pro(flat_input, kTriangles)},
      {"CGAL Lindstrom-Turk", cgal_lindstrom_turk(flat_input, kTriangles)},
      {"CGAL Garland-Heckbert", cgal_garland_heckbert(flat_input, kTriangles)},
      {"Open3D quadric decimation", open3d_quadric_decimation(flat_input, kTriangles)},
      {"meshopt_simplify alone", bare_meshoptimizer(flat_input)}};
  std::vector<Contestant> contestants = {
      {"tegata simplify", [&] { return simplify(input, kTriangles).triangles.size(); }}};
  for (const Peer& peer : peers) contestants.push_back({peer.name, peer.work.run, peer.bar});
  const std::vector<Timing> timings = run_rounds(contestants);
  report.add("to 4,000 triangles", contestants, timings);

  const TriangleMesh ours = simplify(input, kTriangles);
  const double rms_mm = rms_distance_mm(input, ours);
  const MeshTopology topology = inspect_topology(ours);
  report.check("rms distance of the input's vertices, at most 0.40 mm",
               fmt::format("{:.3f} mm, {} triangles", rms_mm, ours.triangles.size()),
               rms_mm <= kMostRmsMm);
  report.check("closed, oriented, manifold", said_of(topology),
               topology.closed && topology.oriented && topology.manifold);
  for (const Peer& peer : peers) {
    const TriangleMesh theirs = from_flat(peer.work.last());
    report.note(fmt::format("{}: {:.3f} mm rms, {} triangles, {}", peer.name,
                            rms_distance_mm(input, theirs), theirs.triangles.size(),
                            said_of(inspect_topology(theirs))));
  }
  return report.print();
}

}  // namespace tegata::bench
