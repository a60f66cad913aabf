#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The tegata authors
# SPDX-License-Identifier: Apache-2.0
#
# Installs what is missing, builds everything and runs every test: format and floors, the rooms'
# tests under the address and undefined-behaviour sanitizers, then the whole suite (rooms, program
# end to end, bad input, README, installed consumer) in release, then the fuzz targets for a minute
# each, some at a time.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh test
scripts/fetch_test_assets.sh
scripts/check_format.sh
scripts/check_floors.sh

cmake --preset release
cmake --build --preset release
cmake --preset asan
cmake --build --preset asan --target unit_tests

# Up to two minutes each under the sanitizers, through code that other tests go through as well:
# these are left to the release build.
slow=('CalibrationCheck.NamesTheCameraThatWas*' 'DigitSearch.FingersInTheir*' 'FitTake.AFrame*'
  'FitSurface.Finds*' 'FitSurface.Missing*' 'FitSurface.Same*' 'GraspFit.KeepsNoMore*'
  'Grasps.Angles*' 'Grasps.Digits*' 'Grasps.Left*' 'Grasps.Plate*' 'HandTracker.WhatIs*'
  'KnownHulls.*' 'PaperFit.All*' 'PaperFit.Does*' 'ShapeFit.AKnown*')
scripts/unit_tests.sh asan "${slow[@]}"
scripts/unit_tests.sh release
ctest --preset release --no-tests=error -LE unit -j "$(nproc)"
scripts/fuzz.sh 60
