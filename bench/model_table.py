#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""model_table.py README MODELS MEASURED BENCH: puts the table of models between README's marks.

MODELS: gonio models --json; MEASURED: gonio models --measure --json;
BENCH: gonio_bench --benchmark_format=json.
"""

import json
import pathlib
import sys

from readme_table import replace


def rows(models, measured, benches):
    for model in models:
        found, bench = measured[model["id"]], benches[model["id"]]
        albedo = found["largest_albedo"]
        against = (
            f"{bench['vs_tables']:.1f} / {bench['vs_textbook']:.1f}" if "vs_tables" in bench else ""
        )
        where = f": {albedo['where']}" if albedo["value"] > 1.001 else ""
        yield (
            f"| `{model['id']}` | {model['title']} | {found['largest_relative_error']:.1e} "
            f"| {bench['Geval_per_s']:.2f} | {bench['of_store']:.2f} | {against} "
            f"| {albedo['value']:.4g}{where} |\n"
        )


def main():
    readme, *files = map(pathlib.Path, sys.argv[1:])
    models, measured, bench = (json.loads(file.read_text()) for file in files)
    found = {model["id"]: model for model in measured["models"]}
    benches = {run["name"].split("/")[1]: run for run in bench["benchmarks"]}
    table = (
        f"Measured on {measured['device']}, driver {measured['driver']}, "
        f"vector width {measured['width']}. "
        "Peers: g++ `-O3 -march=native -ffast-math`, OpenMP. Albedo: the largest directional one "
        "over a model's options, numbers and incidences, with colours of 1.\n\n"
        "| model | title | largest relative error | Geval/s | of the store rate "
        "| times C++: tables / textbook | albedo up to |\n"
        "|---|---|---|---|---|---|---|\n" + "".join(rows(models["models"], found, benches))
    )
    replace(readme, "models", table)


if __name__ == "__main__":
    main()
