#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The tegata authors
# SPDX-License-Identifier: Apache-2.0
#
# Fetches what some tests take from npm into build/assets (100 MB): the WebXR generic hand and the
# glTF validator. Where npm is not there, or does not reach its registry, those tests skip.
set -euo pipefail
cd "$(dirname "$0")/.."

assets=build/assets
packages=(@webxr-input-profiles/assets@1.0.20 gltf-validator@2.0.0-dev.3.10)
modules=$assets/node_modules
[ -e "$modules/@webxr-input-profiles/assets/package.json" ] &&
  [ -e "$modules/gltf-validator/package.json" ] && exit 0
if ! command -v npm >/dev/null || ! command -v node >/dev/null; then
  echo "npm is not there: the tests of the WebXR hand and of the glTF validator will skip"
  exit 0
fi
mkdir -p "$assets"
npm install --prefix "$assets" --no-save --no-audit --no-fund --ignore-scripts --loglevel=error \
  "${packages[@]}" ||
  echo "npm cannot fetch ${packages[*]}: the tests that need them will skip"
