#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""spectrum_table.py README BENCH: puts what shared photons gain between README's marks.

BENCH: gonio_bench --benchmark_filter=^spectrum/ --benchmark_format=json.
"""

import json
import pathlib
import sys

from readme_table import replace


def row(run):
    return (
        f"| `{run['name'].split('/')[1]}` | {run['bases']:.0f} | {run['shared_s']:.2g} s "
        f"| {run['separate_s']:.3g} s | {run['gain']:.0f} | {run['gain_of_rings']:.1f} |\n"
    )


def main():
    readme, bench = map(pathlib.Path, sys.argv[1:])
    runs = json.loads(bench.read_text())["benchmarks"]
    table = (
        "| model | bases | shared photons | 81 runs | times as fast | by the rings' errors |\n"
        "|---|---|---|---|---|---|\n" + "".join(map(row, runs))
    )
    replace(readme, "spectra", table)


if __name__ == "__main__":
    main()
