// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include "benchmarks.h"
#include "peers/peers.h"
#include "report.h"
#include "scene.h"
#include "tegata/base/random.h"
#include "tegata/mesh/closest_point.h"

namespace tegata::bench {
namespace {

constexpr std::size_t kQueries = 2000;

// So many points of a mesh's vertices, no vertex twice, each moved by a normal deviate.
std::vector<Eigen::Vector3d> some_vertices(const TriangleMesh& mesh, std::size_t count,
                                           double deviation, std::uint64_t seed) {
  Random random(seed);
  std::vector<Eigen::Vector3d> points = mesh.vertices;
  for (std::size_t i = 0; i < count; ++i) {
    std::swap(points[i], points[i + random.index(points.size() - i)]);
    const Eigen::Vector3d way(random.normal(), random.normal(), random.normal());
    points[i] += deviation * way;
  }
  points.resize(count);
  return points;
}

std::vector<double> flat(const std::vector<Eigen::Vector3d>& points) {
  std::vector<double> numbers;
  for (const Eigen::Vector3d& point : points) {
    numbers.insert(numbers.end(), {point.x(), point.y(), point.z()});
  }
  return numbers;
}

void run_case(const TriangleMesh& hull, std::size_t count, double bar, Report& report) {
  constexpr double kOffTheHull = 0.003;  // [m], as a hand's model is while it is being fitted
  const auto points = some_vertices(hull, count, 0.0, 1);
  const auto queries = some_vertices(hull, kQueries, kOffTheHull, 2);
  const std::vector<double> flat_points = flat(points), flat_queries = flat(queries);
  std::vector<std::uint32_t> ours(kQueries), theirs;
  const auto sum = [](const std::vector<std::uint32_t>& indices) {
    std::size_t total = 0;
    for (const std::uint32_t index : indices) total += index;
    return total;
  };
  const std::vector<Contestant> contestants = {{"tegata NearestPoint",
                                                [&] {
                                                  const NearestPoint nearest(points);
                                                  for (std::size_t i = 0; i < kQueries; ++i)
                                                    ours[i] = nearest.nearest(queries[i]).index;
                                                  return sum(ours);
                                                }},
                                               {"nanoflann",
                                                [&] {
                                                  nanoflann_nearest(flat_points, flat_queries,
                                                                    theirs);
                                                  return sum(theirs);
                                                },
                                                bar}};
  const std::string work = fmt::format("{} points", count);
  report.add(work, contestants, run_rounds(contestants));
  std::size_t differing = 0;
  for (std::size_t i = 0; i < kQueries; ++i) differing += ours[i] != theirs[i] ? 1 : 0;
  report.check(work + ": the same nearest points", fmt::format("{} differ", differing),
               differing == 0);
}

}  // namespace

bool benchmark_closest_point() {
  Report report("B4: 2,000 nearest points, building included");
  const Scene scene = hand_scene(3);
  HullOptions options = hull_options(scene, 0.001);
  options.triangle_count = 0;
  const TriangleMesh hull = visual_hull(scene.views, options);
  run_case(hull, 5000, 1.8, report);
  run_case(hull, 40000, 5.0, report);
  report.note(
      "points: vertices of the 1 mm hull; queries: such vertices, 3 mm off along each axis");
  return report.print();
}

}  // namespace tegata::bench
