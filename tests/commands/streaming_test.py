#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""streaming_test.py GONIO: a table of 16 GiB is made in at most 512 MiB of resident memory."""

import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile

SIZE, MEMORY_KIB = 16 << 30, 512 << 10
SKIPPED = 77

with tempfile.TemporaryDirectory() as folder:
    if shutil.disk_usage(folder).free < SIZE * 1.1:
        print(f"{folder} has no room for a table of 16 GiB")
        sys.exit(SKIPPED)
    table = pathlib.Path(folder, "ggx.exr")
    subprocess.run(
        [sys.argv[1], "table", "ggx", "--alpha", "0.1", "--f0", "1,0.9,0.8,0.7"]
        + ["--grid", "96x360x90x360", "--compression", "none", "-o", table],
        check=True,
    )
    size = table.stat().st_size
    resident = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    print(f"{size} bytes of file, {resident} KiB resident at most")
    sys.exit(size < SIZE or resident > MEMORY_KIB)
