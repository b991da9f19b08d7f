#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The rules of the house that no compiler holds: `rules.py ROOT` prints each breach; 1 if any.

A rule takes the path and the text of a file and gives (line, message) for each breach.
"""

import pathlib
import re
import sys

CODE = {".cpp", ".hpp", ".cl", ".h", ".inc", ".py", ".sh", ".cmake", ".bash"}
FOLDERS = ("kernels", "include", "host", "tests", "bench")

# Built-ins whose last bits differ between widths, or which are not as exact as they look.
TRANSCENDENTAL = (
    r"(?:exp|exp2|exp10|expm1|log|log2|log10|log1p|sin|cos|tan|sincos|sinpi|cospi|tanpi|asin|acos"
    r"|atan|atan2|asinpi|acospi|atanpi|atan2pi|sinh|cosh|tanh|asinh|acosh|atanh|pow|powr|pown|rootn"
    r"|cbrt|hypot|erf|erfc|tgamma|lgamma|native_\w+"
    r"|half_(?:cos|divide|exp|exp2|exp10|log|log2|log10|powr|recip|rsqrt|sin|sqrt|tan))")
FLOATING = re.compile(
    r"(?<![\w.])(?!0[xX])(?:(?:\d+\.\d*|\.\d+)(?:[eE][+-]?\d+)?|\d+[eE][+-]?\d+)(\w*)")


def without_comments(text):
    """The text with comments and strings blanked, each line where it was."""
    blank = lambda match: re.sub(r"[^\n]", " ", match.group())
    return re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', blank, text, flags=re.DOTALL)


def without_real_macro(text):
    """The text with the arguments of R(…) blanked: this macro gives constants their type."""
    out, depth = list(text), 0
    for i, char in enumerate(text):
        if depth:
            depth += {"(": 1, ")": -1}.get(char, 0)
            out[i] = char if char == "\n" else " "
        elif char == "(" and re.search(r"\bR$", text[max(0, i - 2):i]):
            depth = 1
    return "".join(out)


def matches(pattern, text, message):
    for match in re.finditer(pattern, text):
        yield text.count("\n", 0, match.start()) + 1, message.format(match.group(1))


def head(path, text):
    lines = text.splitlines()[text.startswith("#!"):][:2] + ["", ""]
    if "SPDX-License-Identifier: Apache-2.0" not in lines[0]:
        yield 1, "the SPDX line is missing"
    elif not re.match(r"(//|#|\"\"\"|/\*) *\w", lines[1]):
        yield 2, "a comment on the line after SPDX says what the file is for"


def layout(path, text):
    for number, line in enumerate(text.splitlines(), 1):
        # A registry is a table, and what info prints is text: their lines are not broken.
        if len(line) > 100 and not path.endswith((".inc", "describe_test.cpp")):
            yield number, f"{len(line)} columns, 100 are allowed"
        if re.search(r"\b(TO" r"DO|FIX" r"ME|XX" r"X)\b", line):
            yield number, "unfinished business belongs into an issue"


def kernel_arithmetic(path, text):
    if not path.startswith("kernels/"):
        return
    code = without_comments(text)
    if path != "kernels/core/real.cl":
        yield from matches(r"\b(any|all) *\(", code, "raw {}(): a scalar mask needs any_of, all_of")
        yield from matches(r"(~)", code, "raw {}: a scalar mask needs not_")
    if path.startswith("kernels/core/"):
        return
    yield from matches(rf"\b({TRANSCENDENTAL}) *\(", code,
                       "built-in {}(): take the one of core/math, which is the same at every width")
    yield from matches(r"\b(double\d*)\b", code, "{}: kernels are written in real")
    for match in FLOATING.finditer(without_real_macro(code)):
        if match.group(1) not in ("f", "F"):
            yield (code.count("\n", 0, match.start()) + 1,
                   f"{match.group()} is a double constant: write R({match.group()})")


# Who may include what, by folder: the first prefix that fits the including file rules.
MAY_INCLUDE = {
    "include/gonio/shared/": (r"gonio/shared/", r"<c(stdint|stddef|math)>"),
    "include/": (r"gonio/", r"<(?!CL/)"),
    "kernels/": (r"(core|directions|brdf|photon)/|[a-z_]+\.(h|cl)$|gonio/shared/",),
    "host/reference/": (r"reference/|gonio/|parallel\.hpp", r"<(?!CL/)"),
    "host/opencl/": (r"",),
    "host/": (r"(?!kernels/|tests/|bench/|<CL/)",),
}


def includes(path, text):
    allowed = next((a for prefix, a in MAY_INCLUDE.items() if path.startswith(prefix)), None)
    if allowed is None:
        return
    for match in re.finditer(r"^ *# *include +(\"([^\"]+)\"|<[^>]+>)", text, re.MULTILINE):
        name = match.group(2) or match.group(1)
        if ".." in name or not any(re.match(pattern, name) for pattern in allowed):
            yield text.count("\n", 0, match.start()) + 1, f"{path} must not include {name}"


def opencl_stays_inside(path, text):
    if path.startswith(("host/", "include/")) and not path.startswith("host/opencl/"):
        yield from matches(r"\b(cl)::", without_comments(text), "{}:: outside of host/opencl")


def owners(path, text):
    if path.startswith(("host/", "include/")):
        code = re.sub(r"= *delete\b", "", without_comments(text))
        calls = r"\b(new|delete|malloc|free)\b *[\w(\[]"
        yield from matches(calls, code, "{}: an object owns what is allocated")


def models(root):
    """Every block of models.inc has its kernel and its reference, every kernel its block."""
    registry = root / "include/gonio/shared/models.inc"
    if not registry.exists():
        return
    text = registry.read_text()
    ids = set()
    for match in re.finditer(r"^MODEL\((\w+)", text, re.MULTILINE):
        ids.add(match.group(1))
        for path in f"kernels/brdf/{match.group(1)}.cl", f"host/reference/{match.group(1)}.cpp":
            if not (root / path).exists():
                line = text.count("\n", 0, match.start()) + 1
                yield "include/gonio/shared/models.inc", line, f"{path} is missing"
    # An orphan among the references does not compile: its parameter struct comes from the block.
    for path in sorted((root / "kernels/brdf").glob("*.cl")):
        if path.stem not in ids:
            yield path.relative_to(root).as_posix(), 1, f"no block MODEL({path.stem}, …)"


FILE_RULES = (head, layout, kernel_arithmetic, includes, opencl_stays_inside, owners)


def breaches(root):
    """All (path, line, message) of the tree under root."""
    for path, text in sources(root):
        for rule in FILE_RULES:
            for line, message in rule(path, text):
                yield path, line, message
    yield from models(root)


def sources(root):
    paths = [root / name for name in ("CMakeLists.txt", "dev", ".ci/run")]
    for folder in FOLDERS:
        paths += sorted((root / folder).rglob("*"))
    for path in paths:
        is_code = path.suffix in CODE or path.name in ("CMakeLists.txt", "dev", "run")
        if is_code and path.is_file():
            yield path.relative_to(root).as_posix(), path.read_text()


def main():
    root = pathlib.Path(sys.argv[1])
    for path, text in sources(root):
        lines = text.count("\n")
        if lines > 300:
            print(f"{path}: warning: {lines} lines; is it one idea?")
    found = list(breaches(root))
    for path, line, message in found:
        print(f"{path}:{line}: {message}")
    print(f"{len(found)} breaches of the house rules")
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
