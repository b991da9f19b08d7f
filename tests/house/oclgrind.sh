#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# oclgrind.sh GONIO: runs every kernel in Oclgrind, which reports reads and writes out of bounds,
# races and uninitialised values. Oclgrind exits 0 whatever it finds: only an empty log is good.
set -euo pipefail
command -v oclgrind >/dev/null || { echo "SKIPPED: oclgrind is not installed"; exit 77; }
"$1" verify --help >/dev/null 2>&1 || { echo "SKIPPED: there is no gonio verify"; exit 77; }
log=$(mktemp)
trap 'rm -f "$log"' EXIT
oclgrind --log "$log" --uninitialized --data-races "$1" verify --quick --width 1
[ ! -s "$log" ] || { head -n 100 "$log"; exit 1; }
