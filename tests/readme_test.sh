#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The tegata authors
# SPDX-License-Identifier: Apache-2.0
#
# What README.md tells to type works: its scripts are there, its commands run one after the other in
# an empty folder, and its links lead to something.
# usage: readme_test.sh PROGRAM
set -euo pipefail
program=$1
root=$(cd "$(dirname "$0")/.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
# TEGATA_VIEWER=OFF builds a program that has no report page, and says so before all else.
page=with-page
case $("$program" report "$scratch" 2>&1 || true) in
  *TEGATA_VIEWER=OFF*) page=without-page ;;
esac
fail() {
  echo "README.md: $*"
  exit 1
}

lines=$(wc -l <"$root/README.md")
[ "$lines" -lt 125 ] || fail "$lines lines, fewer than 125 are read"

commands=$(awk '/^```sh$/ { inside = 1; next } /^```/ { inside = 0 } inside' "$root/README.md" |
  sed 's/[[:space:]]*#.*//' | grep -v '^$')
mkdir -p "$scratch/build/release"
ln -s "$program" "$scratch/build/release/tegata"
run_count=0
while read -r command; do
  case $command in
    scripts/*)
      [ -x "$root/${command%% *}" ] || fail "${command%% *} is no script that runs"
      ;;
    build/release/tegata\ report\ * | build/release/tegata\ view\ *)
      if [ "$page" = without-page ]; then
        (cd "$scratch" && bash -c "$command" </dev/null) && fail "worked without the page: $command"
        continue
      fi
      ;;&
    build/release/tegata\ *)
      (cd "$scratch" && bash -c "$command" </dev/null) || fail "failed: $command"
      run_count=$((run_count + 1))
      ;;
    *) fail "this test does not know what to do with: $command" ;;
  esac
done <<<"$commands"
[ "$run_count" -ge 4 ] || fail "only $run_count commands of the program were found"

for document in README.md CONTRIBUTING.md CHANGELOG.md docs/formats.md docs/design.md; do
  # shellcheck disable=SC2013  # no link has a space
  for link in $(grep -oE '\]\([^)#]+' "$root/$document" | sed 's/^](//' | grep -v '^http'); do
    [ -e "$root/$(dirname "$document")/$link" ] || fail "$document: the link $link leads nowhere"
  done
done
