#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# oclgrind.sh TESTS: runs every kernel on every grid at every width in Oclgrind, which reports reads
# and writes out of bounds and races. Oclgrind exits 0 whatever it finds: only an empty log is good.
# Its search for uninitialised values does not know LLVM's freeze instruction and cannot be used.
set -euo pipefail
command -v oclgrind >/dev/null || { echo "SKIPPED: oclgrind is not installed"; exit 77; }
log=$(mktemp)
trap 'rm -f "$log"' EXIT
oclgrind --log "$log" --data-races "$1" --gtest_brief=1 \
    --gtest_filter='Registry/EveryModel.*:Grids.*'
[ ! -s "$log" ] || { head -n 100 "$log"; exit 1; }
