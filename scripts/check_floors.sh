#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The tegata authors
# SPDX-License-Identifier: Apache-2.0
#
# Checks the rooms of src/tegata: a file includes only from its own room and from rooms on lower
# floors, the core library (rooms not marked FULL) includes no OpenCV, and every source file opens
# with the two SPDX lines. Prints file:line for each breach.
# usage: scripts/check_floors.sh [ROOT]     ROOT: the tree to check, else this one
set -euo pipefail
cd "${1:-"$(dirname "$0")/.."}"

breaches=$(
  {
    grep -Ho 'NAME [a-z]* FLOOR [0-9]*\( FULL\)*' src/tegata/*/CMakeLists.txt | sed 's/^[^:]*:/floor /'
    grep -rnE --include='*.h' --include='*.cpp' '^[[:space:]]*#[[:space:]]*include' src/tegata |
      sed 's/^/include /'
  } | awk '
    $1 == "floor" { floor[$3] = $5; full[$3] = $6; next }
    {
      split($2, place, ":")
      where = place[1] ":" place[2]
      split(place[1], folders, "/")
      room = folders[3]
      if (!(room in floor)) { print where ": room " room " declares no floor"; next }
      if (!full[room] && /<opencv/) print where ": core room " room " includes OpenCV"
      if (!match($0, /"tegata\/[a-z_]+\//)) next
      other = substr($0, RSTART + 8, RLENGTH - 9)
      if (other == room) next
      if (!(other in floor)) {
        print where ": there is no room " other
      } else if (floor[other] + 0 >= floor[room] + 0) {
        print where ": room " room " (floor " floor[room] ") includes from " other " (floor " \
          floor[other] ")"
      }
    }'
  folders=()
  for folder in src cli tests bench fuzz cmake scripts examples; do
    [ -d "$folder" ] && folders+=("$folder")
  done
  find "${folders[@]}" -type f \
    \( -name '*.h' -o -name '*.cpp' -o -name '*.cmake' -o -name '*.sh' -o -name CMakeLists.txt \) |
    sort | while read -r file; do
      if [ "$(head -n 3 "$file" | grep -cE \
        'SPDX-(FileCopyrightText: 2026 The tegata authors|License-Identifier: Apache-2\.0)$')" != 2 ]
      then
        echo "$file:1: the two SPDX lines are missing"
      fi
    done
)
if [ -n "$breaches" ]; then
  echo "$breaches"
  exit 1
fi
