#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# oclgrind.sh TESTS GONIO: runs every kernel in Oclgrind, which reports accesses out of bounds,
# races and uninitialised values. It exits 0 whatever it finds: only an empty log is good.
set -euo pipefail
command -v oclgrind >/dev/null || { echo "SKIPPED: oclgrind is not installed"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# The code as it is written: Oclgrind does not know what LLVM's optimiser puts in (freeze, scopes of
# restrict).
run() {
    oclgrind --build-options -cl-opt-disable --log "$scratch/log" "$@" >"$scratch/out" ||
        { cat "$scratch/out"; return 1; }
    [ ! -s "$scratch/log" ] || { echo "oclgrind $*"; head -n 100 "$scratch/log"; return 1; }
}

# On every grid, at every width.
run --data-races "$1" --gtest_filter='Registry/EveryModel.*:Grids.*'
grep -q "PASSED.* [1-9][0-9]* test" "$scratch/out"

# Photons: every kind of row, beam, phase function and bottom, in a few hundred of them.
run --uninitialized "$1" --gtest_filter='SmallSimulations.*'
grep -q "PASSED.* [1-9][0-9]* test" "$scratch/out"

# Light that spreads in pictures.
run --uninitialized --data-races "$1" --gtest_filter='Spread.EvenLight*'
grep -q "PASSED.* [1-9][0-9]* test" "$scratch/out"

# Where formulas are ill-conditioned, within their bounds here too.
run --uninitialized "$2" verify --extreme \
    ggx ward phong blinn_phong ashikhmin_shirley oren_nayar beckmann_kirchhoff

models=$("$2" models --json | sed -n 's/^ *"id": "\(.*\)",$/\1/p')
for model in ${models:?}; do
    run --uninitialized "$2" eval "$model" --at - <<<$'30,0,40,180\n0,0,0,0\n90,0,80,10'
    if "$2" models "$model" --json | grep '"sampled": true' >/dev/null; then
        run --uninitialized "$2" sample "$model" -n 32
    fi
done
