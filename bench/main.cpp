// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Ours and the peers in one process, on the same input, on one thread.
// usage: tegata_bench [NAME]...     NAME: a benchmark; none: all of them
#include <fmt/core.h>

#include <cstdlib>
#include <exception>
#include <string_view>
#include <utility>

#include "benchmarks.h"
#include "peers/peers.h"

namespace {

using namespace tegata::bench;

constexpr std::pair<std::string_view, bool (*)()> kBenchmarks[] = {
    {"memory", benchmark_memory},  // first: it starts processes, before anything makes threads
    {"hull", benchmark_hull},
    {"isosurface", benchmark_isosurface},
    {"simplify", benchmark_simplify},
    {"closest_point", benchmark_closest_point},
    {"fit", benchmark_fit},
    {"joint", benchmark_joint},
    {"hand", benchmark_hand},
    {"chain", benchmark_chain},
    {"refine", benchmark_refine},
    {"track", benchmark_track},
    {"segmentation", benchmark_segmentation}};

bool run(std::string_view name) {
  for (const auto& [known, benchmark] : kBenchmarks) {
    if (known == name) return benchmark();
  }
  fmt::print(stderr, "tegata_bench: got '{}', expected", name);
  for (const auto& [known, benchmark] : kBenchmarks) fmt::print(stderr, " {}", known);
  fmt::print(stderr, "\n");
  std::exit(2);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto hold = hold_openvdb_to_one_thread();
    hold_vtk_to_one_thread();
    hold_open3d_to_one_thread();
    bool all_hold = true;
    fmt::print("Peers: VTK {}, OpenVDB {}, Open3D {}, CGAL {}, nanoflann {}, Ceres {}.\n\n",
               vtk_version(), openvdb_version(), open3d_version(), cgal_version(),
               nanoflann_version(), ceres_version());
    for (int i = 1; i < argc; ++i) all_hold = run(argv[i]) && all_hold;
    if (argc == 1) {
      for (const auto& [name, benchmark] : kBenchmarks) all_hold = benchmark() && all_hold;
    }
    return all_hold ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "tegata_bench: {}\n", error.what());
    return 1;
  }
}
