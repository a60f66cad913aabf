#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The tegata authors
# SPDX-License-Identifier: Apache-2.0
#
# make_take.sh DATA_FOLDER TAKE
#
# Turns a two-camera recording into a take. DATA_FOLDER has for camera N = 0 and 1:
#   camN.mp4           the video
#   cN.dat             "intrinsic:" and three rows, "distortion:" and one row of five (OpenCV's order)
#   rot_trans_cN.dat   "R:" and three rows, "T:" and three rows: camera from world; what follows a
#                      later line is not read
set -euo pipefail

readonly kSize='720, 720'        # of the videos [px]
readonly kFps=30.0
readonly kMetresPerUnit=0.046    # translations are in squares of the chessboard

fail() {
  echo "make_take.sh: $*" >&2
  exit 1
}

# toml_table N INTRINSICS EXTRINSICS: the camera's table in calibration.toml.
toml_table() {
  awk -v number="$1" -v size="$kSize" '
    function fail(what) {
      print "make_take.sh: " FILENAME ": " what > "/dev/stderr"
      failed = 1
      exit 1
    }
    # The rows after a heading go to its table, as many as it has; a second heading of a kind counts
    # for nothing.
    BEGIN { rows["intrinsic:"] = 3; rows["distortion:"] = 1; rows["R:"] = 3; rows["T:"] = 3
            columns["intrinsic:"] = 3; columns["distortion:"] = 5; columns["R:"] = 3; columns["T:"] = 1 }
    $1 in rows { heading = $1; next }
    heading != "" && NF > 0 && count[heading] < rows[heading] {
      if (NF != columns[heading])
        fail("got " NF " numbers in a row below \"" heading "\", expected " columns[heading])
      for (i = 1; i <= NF; ++i) {
        if ($i !~ /^[-+]?[0-9]*\.?[0-9]+([eE][-+]?[0-9]+)?$/) fail("got \"" $i "\", expected a number")
        value[heading, count[heading] + 0, i - 1] = $i
      }
      ++count[heading]
    }
    function r(row, column) { return value["R:", row, column] + 0 }
    function abs(x) { return x < 0 ? -x : x }
    # The rotation vector: the axis times the angle. The quaternion (w, x, y, z) is taken from its
    # largest part (Shepperd 1978), so that angles near 180 degrees keep their digits.
    function rotation_vector(   t, w, x, y, z, length_, scale) {
      t = r(0, 0) + r(1, 1) + r(2, 2)
      if (t >= r(0, 0) && t >= r(1, 1) && t >= r(2, 2)) {
        w = 1 + t; x = r(2, 1) - r(1, 2); y = r(0, 2) - r(2, 0); z = r(1, 0) - r(0, 1)
      } else if (r(0, 0) >= r(1, 1) && r(0, 0) >= r(2, 2)) {
        w = r(2, 1) - r(1, 2); x = 1 + 2 * r(0, 0) - t; y = r(1, 0) + r(0, 1); z = r(0, 2) + r(2, 0)
      } else if (r(1, 1) >= r(2, 2)) {
        w = r(0, 2) - r(2, 0); x = r(1, 0) + r(0, 1); y = 1 + 2 * r(1, 1) - t; z = r(2, 1) + r(1, 2)
      } else {
        w = r(1, 0) - r(0, 1); x = r(0, 2) + r(2, 0); y = r(2, 1) + r(1, 2); z = 1 + 2 * r(2, 2) - t
      }
      if (w < 0) { w = -w; x = -x; y = -y; z = -z }
      length_ = sqrt(x * x + y * y + z * z)
      scale = length_ == 0 ? 0 : 2 * atan2(length_, w) / length_
      return sprintf("[%.15g, %.15g, %.15g]", scale * x, scale * y, scale * z)
    }
    function row_of(heading, row,   text, i) {
      for (i = 0; i < columns[heading]; ++i) text = text (i ? ", " : "") value[heading, row, i]
      return text
    }
    END {
      if (failed) exit 1
      for (heading in rows)
        if (count[heading] != rows[heading])
          fail("got " count[heading] + 0 " rows below \"" heading "\", expected " rows[heading])
      for (i = 0; i < 3; ++i) for (j = 0; j <= i; ++j) {
        product = r(i, 0) * r(j, 0) + r(i, 1) * r(j, 1) + r(i, 2) * r(j, 2)
        if (abs(product - (i == j)) > 1e-3) fail("got an R that is no rotation, expected one")
      }
      print "[cam_" number "]"
      print "name = \"cam" number "\""
      print "size = [" size "]"
      print "matrix = [[" row_of("intrinsic:", 0) "], [" row_of("intrinsic:", 1) "], [" \
            row_of("intrinsic:", 2) "]]"
      print "distortions = [" row_of("distortion:", 0) "]"
      print "rotation = " rotation_vector()
      print "translation = [" value["T:", 0, 0] ", " value["T:", 1, 0] ", " value["T:", 2, 0] "]"
      print ""
    }' "$2" "$3"
}

[ $# -eq 2 ] || fail "got $# arguments, expected: make_take.sh DATA_FOLDER TAKE"
data=$1
take=$2
[ ! -e "$take" ] || fail "$take: exists already, expected a folder to make"
for file in {c0,c1,rot_trans_c0,rot_trans_c1}.dat cam{0,1}.mp4; do
  [ -r "$data/$file" ] || fail "$data/$file: cannot be read"
done

staging=$take.making
rm -rf "$staging"
mkdir -p "$staging/videos"
trap 'rm -rf "$staging"' EXIT
for n in 0 1; do
  toml_table $n "$data/c$n.dat" "$data/rot_trans_c$n.dat"
done > "$staging/calibration.toml"
cp "$data/cam0.mp4" "$data/cam1.mp4" "$staging/videos/"
cat > "$staging/take.toml" <<END
name = "two-cameras"
hand = "right"
fps = $kFps
metres_per_unit = $kMetresPerUnit

[segmentation]
method = "skin"
END
mv "$staging" "$take"
