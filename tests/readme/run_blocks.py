#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""run_blocks.py README GONIO: runs the marked blocks of README in their order, in one new folder.

A mark is a comment on the line before the fence:
    <!-- test: run -->        sh or python has to exit 0, glsl has to compile (a fragment shader)
    <!-- test: file NAME -->  is written to NAME, for the blocks after it
In that folder build/gonio is the program, bench/ and tests/ are those of the project, and gonio is
on the PATH.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

MARK = re.compile(r"^<!-- test: (.*?) -->\n(?:```(\w+)\n(.*?)^```$)?", re.MULTILINE | re.DOTALL)
COMMANDS = {
    "sh": ["bash", "-euo", "pipefail"],
    "python": [sys.executable],
    "glsl": ["glslangValidator", "-S", "frag"],
}


def marked_blocks(text):
    """(line, mark, language, content) of each block; SystemExit if a mark stands before none."""
    for match in MARK.finditer(text):
        line = text.count("\n", 0, match.start()) + 1
        mark, language, content = match.groups()
        known = language in COMMANDS if mark == "run" else re.fullmatch(r"file [\w.-]+", mark)
        if not language or not known:
            sys.exit(f"README line {line}: mark or language of this block is unknown")
        yield line, mark, language, content


def new_folder(readme, gonio):
    folder = pathlib.Path(tempfile.mkdtemp(prefix="gonio-readme-"))
    for name in "bench", "tests":
        (folder / name).symlink_to(readme.parent / name)
    (folder / "build").mkdir()
    (folder / "build/gonio").symlink_to(gonio)
    return folder


def main():
    readme, gonio = (pathlib.Path(name).resolve() for name in sys.argv[1:])
    folder = new_folder(readme, gonio)
    environment = dict(os.environ, PATH=f"{folder}/build:{os.environ['PATH']}")
    ran = 0
    for line, mark, language, content in marked_blocks(readme.read_text()):
        if mark.startswith("file "):
            (folder / mark.removeprefix("file ")).write_text(content)
            continue
        block = folder / f"line_{line}.{language}"
        block.write_text(content)
        print(f"-- README line {line}: {language}", flush=True)
        result = subprocess.run([*COMMANDS[language], block], cwd=folder, env=environment,
                                stdin=subprocess.DEVNULL, check=False)
        if result.returncode != 0:
            sys.exit(f"README line {line}: exit {result.returncode}; its files are in {folder}")
        ran += 1
    if ran == 0:
        sys.exit("README has no block marked <!-- test: run -->")
    subprocess.run(["rm", "-r", folder], check=True)


if __name__ == "__main__":
    main()
