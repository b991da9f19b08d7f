#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""model_table.py README MODELS VERIFY BENCH: puts the table of models between README's marks.

MODELS: gonio models --json; VERIFY: gonio verify --json;
BENCH: gonio_bench --benchmark_format=json.
"""

import json
import pathlib
import re
import sys

BEGIN, END = "<!-- models: made by ./dev readme -->\n", "<!-- /models -->"


def rows(models, verdicts, benches):
    for model in models:
        verdict, bench = verdicts[model["id"]], benches[model["id"]]
        against = (
            f"{bench['vs_tables']:.1f} / {bench['vs_textbook']:.1f}" if "vs_tables" in bench else ""
        )
        yield (
            f"| `{model['id']}` | {model['title']} | {verdict['largest_relative_error']:.1e} "
            f"| {bench['Geval_per_s']:.2f} | {bench['of_store']:.2f} | {against} |\n"
        )


def main():
    readme, *files = map(pathlib.Path, sys.argv[1:])
    models, verify, bench = (json.loads(file.read_text()) for file in files)
    verdicts = {verdict["model"]: verdict for verdict in verify["models"]}
    benches = {run["name"].split("/")[1]: run for run in bench["benchmarks"]}
    table = (
        f"Measured on {verify['device']}, driver {verify['driver']}, "
        f"vector width {verify['width']}. "
        "Peers: g++ `-O3 -march=native -ffast-math`, OpenMP.\n\n"
        "| model | title | largest relative error | Geval/s | of the store rate "
        "| times C++: tables / textbook |\n"
        "|---|---|---|---|---|---|\n" + "".join(rows(models["models"], verdicts, benches))
    )
    text, count = re.subn(
        f"{BEGIN}.*?{END}", lambda _: BEGIN + table + END, readme.read_text(), flags=re.DOTALL
    )
    if count != 1:
        sys.exit(f"{readme} has not the two marks")
    readme.write_text(text)


if __name__ == "__main__":
    main()
