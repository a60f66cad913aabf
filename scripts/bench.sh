#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The tegata authors
# SPDX-License-Identifier: Apache-2.0
#
# Installs what is missing, builds the benchmarks, runs them and writes what they print to the end of
# docs/performance.md. With names it runs those alone and prints to the terminal. Wants an idle
# machine and a few minutes.
# usage: scripts/bench.sh [NAME]...     NAME: memory, hull, isosurface, simplify, closest_point, fit,
#                                       joint, hand, chain, refine, track,
#                                       segmentation
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh bench
cmake --preset release -B build/bench -DTEGATA_TESTS=OFF -DTEGATA_BENCH=ON >/dev/null
cmake --build build/bench --target tegata_bench
program=build/bench/bench/tegata_bench
if [ $# -gt 0 ]; then
  exec $program "$@"
fi

page=docs/performance.md
marker='<!-- What follows is written by scripts/bench.sh. -->'
measured=$(mktemp)
trap 'rm -f "$measured"' EXIT
{
  sed "\\|^$marker\$|,\$d" $page
  printf '%s\n\n' "$marker"
  printf 'Machine: %s, %s cores, load %s before the run; g++ %s, Release (-O3), commit %s.\n' \
    "$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)" "$(nproc)" \
    "$(cut -d ' ' -f 1 /proc/loadavg)" "$(g++ -dumpfullversion)" "$(git rev-parse --short HEAD)"
  $program
} >"$measured"
cp "$measured" $page
echo "written: $page"
