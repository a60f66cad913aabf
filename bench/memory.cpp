// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>
#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <string>

#include "benchmarks.h"
#include "report.h"
#include "scene.h"
#include "tegata/base/error.h"
#include "tegata/hull/marching_cubes.h"

namespace tegata::bench {
namespace {

double megabytes_of_process(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word != key + ":") continue;
    double kibibytes = 0.0;
    status >> kibibytes;
    return kibibytes * 1024.0 * 1e-6;
  }
  throw Error("bench: /proc/self/status has no ", key);
}

// What the work adds to the process's resident memory at its peak, in a process of its own: memory
// that earlier work gave back to the heap would hide some.
double peak_megabytes(const std::function<std::function<void()>()>& prepare) {
  int ends[2] = {};
  if (pipe(ends) != 0) throw Error("bench: pipe() failed");
  const pid_t child = fork();
  if (child < 0) throw Error("bench: fork() failed");
  if (child == 0) {
    const std::function<void()> work = prepare();
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << 5 << std::flush;  // resets VmHWM, proc(5)
    const double before = megabytes_of_process("VmRSS");
    work();
    const double added = megabytes_of_process("VmHWM") - before;
    const bool written = write(ends[1], &added, sizeof added) == sizeof added;
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  double added = 0.0;
  const bool has_answer = read(ends[0], &added, sizeof added) == sizeof added;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!has_answer || status != 0) throw Error("bench: a measurement of memory failed");
  return added;
}

}  // namespace

bool benchmark_memory() {
  Report report("Memory: 512 mm at 1 mm, 3 cameras");
  for (const bool is_ball : {false, true}) {
    const auto prepare = [=](bool with_surface) {
      return [=]() -> std::function<void()> {
        const Scene scene = is_ball ? ball_scene(3) : hand_scene(3);
        const HullOptions options = hull_options(scene, 0.001);
        const Eigen::AlignedBox3d region = region_of_cells(scene.center(), 512, options.voxel_size);
        return [=] {
          const SparseField field = carve(scene.views, region, options);
          if (with_surface) extract_isosurface(field);
        };
      };
    };
    report.note(fmt::format("{}: {:.0f} MB for the hull, {:.0f} MB with its surface",
                            is_ball ? "ball of 400 mm" : "hand", peak_megabytes(prepare(false)),
                            peak_megabytes(prepare(true))));
  }
  report.note("a dense field of floats takes 540 MB");
  return report.print();
}

}  // namespace tegata::bench
