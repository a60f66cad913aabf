// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include "benchmarks.h"
#include "flat.h"
#include "report.h"
#include "scene.h"

namespace tegata::bench {
namespace {

// Hull, isosurface and simplification as separate prototypes, on another day [ms].
constexpr double kReachable = 1.75 + 1.7 + 12.6;
constexpr double kMostGrowth = 4.5;  // from 2 mm to 1 mm

// Medians of what the reports of many calls say.
class Steps {
 public:
  std::size_t run(const Scene& scene, const HullOptions& options) {
    HullReport report;
    const std::size_t count = visual_hull(scene.views, options, &report).triangles.size();
    carve_.push_back(1e3 * report.carve_seconds);
    isosurface_.push_back(1e3 * report.isosurface_seconds);
    simplify_.push_back(1e3 * report.simplify_seconds);
    return count;
  }
  double carve_ms() const { return median(carve_); }
  double isosurface_ms() const { return median(isosurface_); }
  double simplify_ms() const { return median(simplify_); }

 private:
  std::vector<double> carve_, isosurface_, simplify_;
};

}  // namespace

bool benchmark_chain() {
  Report report("Chain: 3 silhouettes in memory to 4,000 triangles");
  const Scene scene = hand_scene(3);
  Steps at_2_mm, at_1_mm, at_1_mm_raw, at_2_mm_raw;
  const auto options = [&](double voxel_size, std::size_t triangle_count) {
    HullOptions made = hull_options(scene, voxel_size);
    made.triangle_count = triangle_count;
    return made;
  };
  const std::vector<FlatView> views = flat(scene.views);
  const FlatCube cube =
      flat_cube(carve(scene.views, region_of_cells(scene.center(), 128, 0.002), options(0.002, 0)));
  std::vector<std::uint8_t> inside;
  const std::vector<Contestant> contestants = {
      {"tegata visual_hull, 2 mm", [&] { return at_2_mm.run(scene, options(0.002, 4000)); }},
      {"tegata visual_hull, 1 mm", [&] { return at_1_mm.run(scene, options(0.001, 4000)); }},
      {"2 mm, not simplified", [&] { return at_2_mm_raw.run(scene, options(0.002, 0)); }},
      {"1 mm, not simplified", [&] { return at_1_mm_raw.run(scene, options(0.001, 0)); }},
      {"naive loop (256 mm / 2 mm), FlyingEdges, meshopt_simplify", [&] {
         carve_naively(views, cube, inside);
         return meshoptimizer_triangles(vtk_surface_of_voxels(inside, cube.voxels), 4000).size();
       }}};
  const std::vector<Timing> timings = run_rounds(contestants);
  report.add("silhouettes to mesh", contestants, timings);
  for (const auto& [name, steps] : {std::pair{"2 mm", &at_2_mm}, std::pair{"1 mm", &at_1_mm}}) {
    report.note(
        fmt::format("{}: region and hull {:.2f} ms, isosurface and components {:.2f} ms, "
                    "simplification {:.2f} ms",
                    name, steps->carve_ms(), steps->isosurface_ms(), steps->simplify_ms()));
  }
  report.note(
      fmt::format("prototypes of the three steps at 2 mm, measured apart: {:.2f} ms", kReachable));
  const double growth = timings[3].ratio / timings[2].ratio;
  report.note(fmt::format(
      "1 mm over 2 mm without simplification: {:.2f} (at most {} to hold: {}), with it: {:.2f}",
      growth, kMostGrowth, growth <= kMostGrowth ? "held" : "not held", timings[1].ratio));
  return report.print();
}

}  // namespace tegata::bench
