#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The tegata authors
# SPDX-License-Identifier: Apache-2.0
#
# From nothing to a fitted grasp: builds the program, makes a take of a hand that turns a cylinder in
# the virtual room, fits it and compares the result with the truth. What is there already is kept.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/build.sh
program=build/release/tegata

# made FILE-OR-FOLDER COMMAND...: runs the command unless what it makes is there.
made() {
  local product=$1
  shift
  if [ -e "$product" ]; then
    echo "kept: $product"
  else
    echo "+ $*"
    "$@"
  fi
}

made demo/take $program simulate demo/take --grasp cylinder --cameras 3 --frames 10 --seed 1 \
  --mode infrared --hand right
made demo/result $program fit demo/take -o demo/result
made demo/picture.png $program picture demo/result --take demo/take -o demo/picture.png
echo "+ $program evaluate demo/result --truth demo/take"
$program evaluate demo/result --truth demo/take

cat <<'END'

Open these:
  demo/result/report.html   the report, in a browser
  demo/picture.png          the cameras' pictures with the fitted hand's outline
  demo/result/hand.glb      the hand as an animation, in Blender or any glTF viewer
  demo/result/angles.csv    joint angles, in a spreadsheet
Remove the folder demo to make all of it anew.
END
