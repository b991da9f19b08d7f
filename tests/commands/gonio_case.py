# SPDX-License-Identifier: Apache-2.0
"""For tests of what a user sees: the program, named first of the arguments, in its own folder."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

GONIO = pathlib.Path(sys.argv.pop(1)).resolve()

SWEPT = """[output]
directory = "tables"
[[material]]
name = "m"
model = "ward"
[material.parameters]
alpha = {{ values = [0.1, 0.2, 0.3, 0.4], as = "{form}" }}
[[table]]
material = "m"
quantity = "brdf"
grid = {{ kind = "isotropic", theta_i = {n}, theta_o = {n}, delta_phi = 180 }}
"""


class GonioCase(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.at = pathlib.Path(self.folder.name)

    def gonio(self, *words, code=0, text="", **environment):
        done = subprocess.run(
            [GONIO, *words],
            cwd=self.at,
            input=text,
            text=True,
            capture_output=True,
            env={**os.environ, **environment},
        )
        self.assertEqual(done.returncode, code, f"{words}: {done.stdout}{done.stderr}")
        if code:
            self.assertTrue(done.stderr.strip(), "an error without a message")
        return done.stderr if code else done.stdout
