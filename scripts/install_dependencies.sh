#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The tegata authors
# SPDX-License-Identifier: Apache-2.0
#
# Installs what building needs and is not there yet, from Debian 12's packages.
# usage: scripts/install_dependencies.sh [test|bench]
#   test: what scripts/test.sh needs as well; bench: the libraries that scripts/bench.sh compares with
set -euo pipefail

packages=(
  g++ cmake ninja-build
  libeigen3-dev libtbb-dev libmeshoptimizer-dev
  libopencv-core-dev libopencv-imgproc-dev libopencv-imgcodecs-dev libopencv-calib3d-dev
  libopencv-videoio-dev libopencv-contrib-dev libceres-dev
  nlohmann-json3-dev libtomlplusplus-dev libyaml-cpp-dev libtinygltf-dev libcli11-dev libfmt-dev
)
# The report page is built with npm; a Node that is there already, from anywhere, is good enough.
if ! command -v node >/dev/null || ! command -v npm >/dev/null; then
  packages+=(nodejs npm)
fi
case "${1:-}" in
  '') ;;
  test)
    packages+=(git libgtest-dev clang-14 libclang-rt-14-dev clang-format-14 chromium
      liburdfdom-tools python3-numpy)
    ;;
  bench) packages+=(libvtk9-dev libcgal-dev libopenvdb-dev libnanoflann-dev libopen3d-dev) ;;
  *)
    echo "install_dependencies.sh: got '$1', expected nothing, 'test' or 'bench'" >&2
    exit 2
    ;;
esac

if ! command -v dpkg-query >/dev/null; then
  echo "install_dependencies.sh: this is no Debian system; install by hand: ${packages[*]}" >&2
  exit 1
fi
missing=()
for package in "${packages[@]}"; do
  # shellcheck disable=SC2016  # the format is dpkg-query's
  state=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$state" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "install_dependencies.sh: neither root nor sudo; have root install: ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "installing ${missing[*]}"
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends "${missing[@]}"
