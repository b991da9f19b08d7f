#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Each rule of rules.py finds what it is there for, and nothing in what is right."""

import pathlib
import tempfile
import unittest

import rules

HEAD = "// SPDX-License-Identifier: Apache-2.0\n// A file.\n"


def found(rule, path, text):
    return [line for line, _ in rule(path, text)]


def in_kernel(path, text):
    return found(rules.kernel_arithmetic, path, text)


class FileRules(unittest.TestCase):
    def test_head(self):
        self.assertEqual(found(rules.head, "host/a.cpp", HEAD), [])
        self.assertEqual(found(rules.head, "dev", "#!/bin/sh\n# SPDX-License-Identifier: "
                                                  "Apache-2.0\n# A script.\n"), [])
        self.assertEqual(found(rules.head, "host/a.cpp", "#pragma once\n"), [1])
        self.assertEqual(found(rules.head, "host/a.cpp", HEAD.replace("// A file.", "")), [2])

    def test_layout(self):
        self.assertEqual(found(rules.layout, "host/a.cpp", "x" * 100 + "\nTO" "DOS\n"), [])
        self.assertEqual(found(rules.layout, "host/a.cpp", "\n" + "x" * 101), [2])
        self.assertEqual(found(rules.layout, "host/a.cpp", "// TO" "DO: more\n"), [1])

    def test_transcendental_builtins(self):
        for call in "exp(x)", "pow (x, y)", "native_sin(x)", "half_exp(x)", "atan2(y, x)":
            code = f"real y = {call};"
            self.assertEqual(in_kernel("kernels/brdf/a.cl", code), [1], call)
            self.assertEqual(in_kernel("kernels/core/math.cl", code), [])
            self.assertEqual(in_kernel("host/reference/a.cpp", code), [])
        for fine in "exp_of_negative(q)", "// exp(x)", "/* a\nlog(x) */", "half_angle(x)":
            self.assertEqual(in_kernel("kernels/brdf/a.cl", fine), [], fine)

    def test_raw_masks(self):
        for code in "if (any(x < y)) f();", "x = all(m);", "select(a, b, ~m)":
            self.assertEqual(in_kernel("kernels/core/math.cl", code), [1], code)
            self.assertEqual(in_kernel("kernels/core/real.cl", code), [])
        self.assertEqual(in_kernel("kernels/table.cl", "any_of(m)"), [])

    def test_double_constants(self):
        for code in "0.5", "1e-3", ".5 * x", "2. * x", "double4 x", "1.5L", "R(1) + 0.5":
            self.assertEqual(in_kernel("kernels/table.cl", code), [1], code)
        for code in "0.5f", "R(0.5)", "R(4.0 * (0.5 + x))", "3", "0x1e5", "v.s0", "a1e5", "1e3F":
            self.assertEqual(in_kernel("kernels/table.cl", code), [], code)

    def test_include_direction(self):
        wrong = {
            "include/gonio/shared/models.inc": '"core/real.cl"',
            "include/gonio/table.hpp": '"output/exr.hpp"',
            "include/gonio/device.hpp": "<CL/opencl.hpp>",
            "kernels/table.cl": '"gonio/table.hpp"',
            "kernels/brdf/ward.cl": "<stdio.h>",
            "host/reference/ward.cpp": '"opencl/device.hpp"',
            "host/reference/phong.cpp": '"brdf/phong.cl"',
            "host/output/exr.cpp": "<CL/opencl.hpp>",
            "host/plan/plan.cpp": '"kernels/table.cl"',
            "host/plan/jobs.cpp": '"../reference/ward.hpp"',
        }
        for path, name in wrong.items():
            self.assertEqual(found(rules.includes, path, f"{HEAD}#include {name}\n"), [3], path)
        right = {
            "include/gonio/shared/models.inc": '"gonio/shared/fields.h"',
            "include/gonio/table.hpp": "<vector>",
            "kernels/table.cl": '"core/real.cl"',
            "kernels/brdf/ward.cl": '"gonio/shared/models.inc"',
            "host/reference/ward.cpp": '"reference/models.hpp"',
            "host/output/exr.cpp": '"gonio/table.hpp"',
            "host/opencl/device.cpp": "<CL/opencl.hpp>",
            "tests/opencl/device_test.cpp": "<CL/opencl.hpp>",
        }
        for path, name in right.items():
            self.assertEqual(found(rules.includes, path, f"{HEAD}#include {name}\n"), [], path)

    def test_opencl_stays_inside(self):
        rule = rules.opencl_stays_inside
        self.assertEqual(found(rule, "host/plan/a.cpp", "\ncl::Buffer b;"), [2])
        self.assertEqual(found(rule, "host/plan/a.cpp", "// cl::Buffer"), [])
        self.assertEqual(found(rule, "host/opencl/a.cpp", "cl::Buffer b;"), [])

    def test_owners(self):
        for code in "p = new int(3);", "delete p;", "delete[] p;", "free(p)", "malloc(3)":
            self.assertEqual(found(rules.owners, "host/a.cpp", code), [1], code)
        for code in "a(const a&) = delete;", "// a new file", "renew(p)", "make_unique<int>(3)":
            self.assertEqual(found(rules.owners, "host/a.cpp", code), [], code)


class TreeRules(unittest.TestCase):
    def tree(self, *files):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        root = pathlib.Path(folder.name)
        registry = root / "include/gonio/shared/models.inc"
        for path in files:
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text(HEAD)
        registry.parent.mkdir(parents=True)
        registry.write_text("// MODEL(id, …)\n#define MODEL(id)\nMODEL(ward, …)\n")
        return [message for _, _, message in rules.models(root)]

    def test_a_block_needs_its_two_files(self):
        self.assertEqual(self.tree("kernels/brdf/ward.cl", "host/reference/ward.cpp"), [])
        self.assertEqual(self.tree("host/reference/ward.cpp"), ["kernels/brdf/ward.cl is missing"])
        self.assertEqual(self.tree("kernels/brdf/ward.cl"), ["host/reference/ward.cpp is missing"])

    def test_a_kernel_needs_its_block(self):
        both = "kernels/brdf/ward.cl", "host/reference/ward.cpp"
        self.assertEqual(self.tree(*both, "kernels/brdf/hapke.cl"), ["no block MODEL(hapke, …)"])
        self.assertEqual(self.tree(*both, "host/reference/bind.cpp"), [])


if __name__ == "__main__":
    unittest.main()
