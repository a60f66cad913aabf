#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The tegata authors
# SPDX-License-Identifier: Apache-2.0
#
# Runs the rooms' tests of a build that is there, as many programs at once as there are cores. ctest
# runs each test in a process of its own, which loads some 250 libraries and builds a hand anew; here
# each program runs a quarter of its tests at a time. What fails is shown, what skips is named.
# usage: scripts/unit_tests.sh PRESET [PATTERN...]     patterns, as GoogleTest's, of tests to leave out
set -euo pipefail
cd "$(dirname "$0")/.."

preset=$1
shift
IFS=: eval 'left_out="-$*"'
logs=build/$preset/unit_tests
rm -rf "$logs"
mkdir -p "$logs"

# part PROGRAM INDEX COUNT LEFT_OUT LOGS: runs one part of a program's tests.
part() {
  local program=$1 index=$2 count=$3 left_out=$4 name status=0
  name=$(basename "$program")
  local log=$5/$name.$index.txt
  GTEST_TOTAL_SHARDS=$count GTEST_SHARD_INDEX=$index timeout 900 \
    "$program" --gtest_filter="$left_out" >"$log" 2>&1 || status=$?
  sed -n 's/^\[  SKIPPED \] \([A-Z].*[a-zA-Z0-9]\)$/skipped: \1/p' "$log" | sort -u
  if [ "$status" -ne 0 ]; then
    cat "$log"
    echo "$name, part $((index + 1)) of $count: exit code $status (124: out of time)"
    return 1
  fi
}
export -f part

count=4
programs=(build/"$preset"/src/tegata/*/tegata_*_test)
for index in $(seq 0 $((count - 1))); do
  for program in "${programs[@]}"; do
    [[ $program == */tegata_precompiled_test ]] || printf '%s %s\n' "$program" "$index"
  done
done | xargs -P "$(nproc)" -L 1 bash -c 'part "$4" "$5" "$1" "$2" "$3"' part "$count" "$left_out" "$logs"
passed=$(cat "$logs"/*.txt | sed -n 's/^\[  PASSED  \] \([0-9]*\) tests*\.$/\1/p' | paste -sd +)
if [ $((passed)) -eq 0 ]; then
  echo "unit_tests.sh: no test ran" >&2
  exit 1
fi
echo "unit tests, $preset: $((passed)) passed"
