#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The tegata authors
# SPDX-License-Identifier: Apache-2.0
#
# Builds the fuzz targets and runs each for a while, twice as many at once as there are cores: most
# are readers of small texts, which get through a hundred thousand inputs in half a minute. A finding
# fails the script and is kept in build/asan/fuzz/findings: run the target with that file as its
# argument to see it again. What was found to reach new code is kept as well and makes the next run
# start from there.
# usage: scripts/fuzz.sh [SECONDS=60] [TARGET...]     targets as octree, glb; else all
set -euo pipefail
cd "$(dirname "$0")/.."

seconds=${1:-60}
shift $(($# > 0 ? 1 : 0))
cmake --preset asan >/dev/null
cmake --build --preset fuzz

folder=build/asan/fuzz
targets=("$@")
if [ ${#targets[@]} -eq 0 ]; then
  for source in fuzz/fuzz_*.cpp; do
    name=$(basename "$source" .cpp)
    targets+=("${name#fuzz_}")
  done
fi
mkdir -p "$folder/findings" "$folder/logs"
"$folder/make_seeds" "$folder/seeds"

# fuzz FOLDER SECONDS TARGET: runs one target and prints one line on how it went.
fuzz() {
  local folder=$1 seconds=$2 target=$3 status=0
  local log=$folder/logs/$target.txt dictionary=()
  mkdir -p "$folder/corpus/$target" "$folder/seeds/$target"
  [ -e "fuzz/$target.dict" ] && dictionary=("-dict=fuzz/$target.dict")
  "$folder/fuzz_$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 \
    -print_final_stats=1 -artifact_prefix="$folder/findings/$target-" "${dictionary[@]}" \
    "$folder/corpus/$target" "$folder/seeds/$target" >"$log" 2>&1 || status=$?
  local runs
  runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  if [ "$status" -eq 0 ]; then
    echo "fuzz $target: ${runs:-0} inputs in $seconds s, no finding"
  else
    tail -n 40 "$log"
    echo "fuzz $target: a finding, exit code $status; the whole of it is in $log"
    return 1
  fi
}
export -f fuzz
printf '%s\n' "${targets[@]}" |
  xargs -P "$((2 * $(nproc)))" -I TARGET bash -c 'fuzz "$@"' fuzz "$folder" "$seconds" TARGET
