#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The tegata authors
# SPDX-License-Identifier: Apache-2.0
#
# scripts/check_floors.sh passes on this tree and finds each kind of breach in a copy of it.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT

"$root/scripts/check_floors.sh"

# expect_breach FILE LINE-TO-ADD MESSAGE
expect_breach() {
  rm -rf "$copy/src"
  cp -r "$root/src" "$copy/"
  printf '%s\n' "$2" >>"$copy/$1"
  local line said
  line=$(wc -l <"$copy/$1")
  if said=$("$root/scripts/check_floors.sh" "$copy"); then
    echo "passed although $1 says: $2"
    exit 1
  fi
  if [ "$said" != "$1:$line: $3" ]; then
    echo "expected: $1:$line: $3"
    echo "got:      $said"
    exit 1
  fi
}

expect_breach src/tegata/camera/camera.h '#include "tegata/fit/view.h"' \
  'room camera (floor 2) includes from fit (floor 6)'
expect_breach src/tegata/camera/camera.cpp '#include "tegata/mesh/simplify.h"' \
  'room camera (floor 2) includes from mesh (floor 2)'
expect_breach src/tegata/base/error.h '  #  include "tegata/attic/box.h"' 'there is no room attic'
expect_breach src/tegata/image/silhouette.h '#include <opencv2/core.hpp>' \
  'core room image includes OpenCV'

rm -rf "$copy/src"
cp -r "$root/src" "$copy/"
sed -i 2d "$copy/src/tegata/base/text.h"
if "$root/scripts/check_floors.sh" "$copy" >"$copy/said"; then
  echo "passed without the licence line"
  exit 1
fi
grep -q '^src/tegata/base/text.h:1: the two SPDX lines are missing$' "$copy/said"
