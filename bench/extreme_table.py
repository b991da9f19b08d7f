#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""extreme_table.py README VERIFIED: puts the stiff and extreme cases between README's marks.

VERIFIED: gonio verify --extreme --json.
"""

import json
import pathlib
import sys

from readme_table import replace


def error(spot, form):
    lost = spot[form + "not_finite"]
    return f"{lost} not finite" if lost else f"{spot[form + 'relative_error']:.1e}"


def spot_row(spot):
    return (
        f"| {spot['name']} | {error(spot, '')} "
        f"| {spot['bound']:.0e} | {spot['condition']:.1e} | {error(spot, 'textbook_')} |\n"
    )


def medium_row(medium):
    return (
        f"| {medium['name']} | {medium['exact']:.4f} | {medium['measured']:.4f} "
        f"| {medium['deviation']:.1f} |\n"
    )


def main():
    readme, verified = map(pathlib.Path, sys.argv[1:])
    report = json.loads(verified.read_text())
    total = report["sum"]
    table = (
        f"Measured on {report['device']}, driver {report['driver']}.\n\n"
        "| reflectance models | largest relative error | bound | condition number "
        "| textbook form in float32 |\n|---|---|---|---|---|\n"
        + "".join(map(spot_row, report["spots"]))
        + f"| sum of {total['photons']:.0e} photons | {total['relative_error']:.0e} | 0 |  "
        f"| {total['textbook_relative_error']:.3f} |\n\n"
        "| photons in layers: diffuse reflectance | exact | measured | standard errors off |\n"
        "|---|---|---|---|\n" + "".join(map(medium_row, report["media"]))
    )
    replace(readme, "extremes", table)


if __name__ == "__main__":
    main()
