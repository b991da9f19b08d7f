#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""picture_table.py README BENCH: puts times and errors of pictures between README's marks.

BENCH: gonio_bench --benchmark_filter=^pictures/ --benchmark_format=json.
"""

import json
import pathlib
import sys

from readme_table import replace


def main():
    readme, bench = map(pathlib.Path, sys.argv[1:])
    runs = json.loads(bench.read_text())["benchmarks"]
    faces = [run for run in runs if "seconds" in run]
    skins = [run for run in runs if "edge" in run]
    table = (
        f"Measured on {faces[0]['label']}; {faces[0]['megapixels']:.2f} megapixels, "
        "2 × 2 rays in each.\n\n"
        "| scene | s |\n|---|---|\n"
        + "".join(f"| `{run['name'].split('/')[1]}` | {run['seconds']:.1f} |\n" for run in faces)
        + "\n| skin | largest error behind the edge of a half-plane of light "
        "| of the BRDF's separable shape, 600 nm, up to 60° |\n|---|---|---|\n"
        + "".join(
            f"| `{run['name'].split('/')[2]}` | {run['edge']:.4f} | {100 * run['shape']:.1f} % |\n"
            for run in skins
        )
    )
    replace(readme, "pictures", table)


if __name__ == "__main__":
    main()
