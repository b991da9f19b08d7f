#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""photon_table.py README BENCH: puts the speed of photons between README's marks.

BENCH: gonio_bench --benchmark_filter=^photons/ --benchmark_format=json.
"""

import json
import pathlib
import sys

from readme_table import replace

TITLES = {
    "slab": "slab, van de Hulst 1980",
    "sample": "three layers, MCML's sample",
    "skin": "seven-layer skin, 600 nm",
    "giovanelli": "half-space, Giovanelli 1955",
    "skin5": "five-layer skin, 633 nm",
}


def row(run):
    name = run["name"].split("/")[1].removesuffix(".mco")
    return (
        f"| {TITLES[name]} | {run['photons_per_core']:.3g} | {run['at_1e_4']:.3g} "
        f"| {run['vs_scalar']:.1f} | {run['vs_mcml']:.1f} | {run['vs_pyxopto']:.1f} "
        f"| {run['vs_mcx_cl']:.0f} | {run['vs_width_1']:.1f} | {run['cores']:.2f} "
        f"| {run['with_absorption']:.2f} |\n"
    )


def main():
    readme, bench = map(pathlib.Path, sys.argv[1:])
    runs = json.loads(bench.read_text())["benchmarks"]
    table = (
        f"Measured on {runs[0]['label']}.\n\n"
        "| medium | photons a second and core | with MCML's roulette, 1e-4 | times the scalar "
        "reference | times MCML 2.0 | times PyXOpto | times MCX-CL | times width 1 | two cores "
        "over one | time with A(r, z) |\n"
        "|---|---|---|---|---|---|---|---|---|---|\n"
        + "".join(map(row, runs))
    )
    replace(readme, "photons", table)


if __name__ == "__main__":
    main()
