#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The tegata authors
# SPDX-License-Identifier: Apache-2.0
#
# Installs the build into an empty folder and builds and runs a project that finds it there. The core
# component must do without everything but Eigen, oneTBB and meshoptimizer; the full one compiles
# README.md's C++ example and runs it on a take.
# usage: consumer_test.sh BUILD-FOLDER core|full
set -euo pipefail
build=$1 component=$2
root=$(cd "$(dirname "$0")/.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

cmake --install "$build" --prefix "$scratch/installed" >"$scratch/install.log"
options=()
if [ "$component" = core ]; then
  for package in OpenCVParts nlohmann_json tomlplusplus TinyGLTF CLI11 fmt; do
    options+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON")
  done
else
  awk '/^```cpp$/ { inside = 1; next } /^```/ { inside = 0 } inside' "$root/README.md" \
    >"$scratch/readme_example.cpp"
  [ -s "$scratch/readme_example.cpp" ]
  options+=("-DREADME_EXAMPLE=$scratch/readme_example.cpp")
fi
cmake -G Ninja -S "$root/tests/consumer" -B "$scratch/build" -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_PREFIX_PATH="$scratch/installed" -DCOMPONENT="$component" "${options[@]}"
cmake --build "$scratch/build"

if [ "$component" = core ]; then
  "$scratch/build/core_consumer"
  if ldd "$scratch/build/core_consumer" | grep -i opencv; then
    echo "the core library pulls in OpenCV"
    exit 1
  fi
else
  "$scratch/installed/bin/tegata" simulate "$scratch/take" --mode mask --frames 2 --size 320x240
  "$scratch/build/readme_example" "$scratch/take"
fi
