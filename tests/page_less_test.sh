#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The tegata authors
# SPDX-License-Identifier: Apache-2.0
#
# Without the report page (-DTEGATA_VIEWER=OFF) nothing needs npm, everything that the program is
# made of has a rule, and what carries the page compiles without it. Building it all would take
# minutes, so the build is only planned.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() {
  echo "page_less_test.sh: $*"
  exit 1
}

# A name that no program has stands for an npm that is not installed.
cmake -S "$root" -B "$scratch" -G Ninja -DTEGATA_VIEWER=OFF -DTEGATA_TESTS=OFF \
  -DTEGATA_NPM="$scratch/no-npm" -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >"$scratch/log" 2>&1 ||
  fail "does not configure: $(cat "$scratch/log")"
! grep -q -e no-npm -e viewer/copy "$scratch/build.ninja" || fail "the build still makes the page"
ninja -C "$scratch" -n tegata >"$scratch/log" 2>&1 || fail "cannot be built: $(cat "$scratch/log")"
object=src/tegata/export/CMakeFiles/tegata_export.dir/viewer_page.cpp.o
ninja -C "$scratch" "$object" >"$scratch/log" 2>&1 || fail "$(cat "$scratch/log")"
! nm "$scratch/$object" | grep -q tegata_viewer_page_begin || fail "the page is carried all the same"
grep -q TEGATA_VIEWER=OFF "$scratch/$object" || fail "nothing says that the page is missing"
