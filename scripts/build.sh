#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The tegata authors
# SPDX-License-Identifier: Apache-2.0
#
# Installs what is missing and builds the program, build/release/tegata.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh
cmake --preset release >/dev/null
cmake --build --preset release --target tegata
