#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# run.sh BUILD: installs from the folder BUILD into a new prefix, checks what is there, then builds
# and runs the program beside this script against it.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT

cmake --install "$1" --prefix "$prefix" >/dev/null
"$prefix/bin/gonio" --version
if command -v help2man >/dev/null; then grep -q '^.SH NAME' "$prefix/share/man/man1/gonio.1"; fi

# What bash offers after "gonio ta" and "gonio table --gr".
completions() {
    PATH=$prefix/bin:$PATH bash -c '
        . "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _gonio; echo "${COMPREPLY[*]}"
    ' bash "$prefix/share/bash-completion/completions/gonio" "$@"
}
[ "$(completions gonio ta)" = table ]
[ "$(completions gonio table --gr)" = --grid ]

cmake -G Ninja -S "$here" -B "$prefix/consumer" -D CMAKE_PREFIX_PATH="$prefix" >/dev/null
cmake --build "$prefix/consumer" >/dev/null
(cd "$prefix" && consumer/consumer)
