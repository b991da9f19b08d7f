# SPDX-License-Identifier: Apache-2.0
"""Puts a measured table between its two marks in README."""

import re
import sys


def replace(readme, name, table):
    begin, end = f"<!-- {name}: made by ./dev readme -->\n", f"<!-- /{name} -->"
    text, count = re.subn(
        f"{begin}.*?{end}", lambda _: begin + table + end, readme.read_text(), flags=re.DOTALL
    )
    if count != 1:
        sys.exit(f"{readme} has not the two marks of {name}")
    readme.write_text(text)
