#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Compiles every file of kernels/ alone, at every width, with clang's own OpenCL C front end. A file
# of functions for others uses few of them itself.
set -euo pipefail
cd "$(dirname "$0")/../.."

compile() {
    for width in 1 4 8 16; do
        clang -x cl -cl-std=CL1.2 -fsyntax-only -I kernels -I include -D WIDTH=$width \
            -Wall -Wextra -Wconversion -Wno-unused-parameter -Wno-unused-function -Werror "$1" ||
            { echo "^ $1 at width $width" >&2; return 1; }
    done
}
export -f compile
find kernels -name '*.cl' -print0 | xargs -0 -r -P "$(nproc)" -I '{}' bash -c 'compile {}'
