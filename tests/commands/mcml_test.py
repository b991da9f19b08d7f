#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""mcml_test.py GONIO: MCML's input files, and the .mco files that come of them."""

import json
import math
import pathlib
import signal
import subprocess
import time
import unittest

from gonio_case import GONIO, GonioCase


CASES = pathlib.Path(__file__).parents[2] / "bench/scenes/mcml.mci"

# Adding-doubling of this project; the slab: van de Hulst 1980, table 35, 0.09739 and 0.66096.
EXACT = {
    "slab": (0.0973946, 0.6609577),
    "sample": (0.2378563, 0.0960477),
    "skin": (0.5625850, 0.0032634),
    "giovanelli": (0.2199186, 0),
    "skin5": (0.2408819, 0.0214911),
}
# Two-sided, ten z-tests with a chance of 1e-4 in all to fail (Sidak).
SIGMAS = 4.42

SMALL = """1.0
1
small.mco A
20000
0.01 0.02
20 10 3
1
1.0
1.4 1 50 0.8 0.1
1.0
"""


class Mco:
    """The numbers of a .mco file by the name of their block."""

    def __init__(self, text):
        lines = [line.split("#")[0].split() for line in text.splitlines()]
        lines = [words for words in lines if words]
        self.blocks = {}
        for words in lines:
            if words[0][0].isalpha() and words[0] != "A1":
                name = words[0]
                self.blocks[name] = []
                words = words[1:]
            if self.blocks and name not in ("InParm", "small.mco"):
                self.blocks[name] += map(float, words)

    def __getitem__(self, name):
        return self.blocks[name]


class Mcml(GonioCase):
    def photon(self, text, *words, code=0):
        (self.at / "in.mci").write_text(text)
        return self.gonio("photon", "in.mci", *words, code=code)

    def test_goes_on_after_an_interruption(self):
        # Some seconds of work, in folders of their own.
        text = SMALL.replace("20000", "12000000")
        self.photon(text, "-o", "whole")
        command = [GONIO, "photon", "in.mci", "-o", "parts"]
        with subprocess.Popen(command, cwd=self.at, stdout=subprocess.PIPE) as running:
            time.sleep(1)
            running.send_signal(signal.SIGINT)
            running.communicate()
        self.assertEqual(running.returncode, 130)
        self.assertTrue((self.at / "parts/small.mco.checkpoint").exists())
        self.assertFalse((self.at / "parts/small.mco").exists())
        self.photon(text, "-o", "parts")
        self.assertEqual(
            (self.at / "parts/small.mco").read_bytes(), (self.at / "whole/small.mco").read_bytes()
        )
        self.assertFalse((self.at / "parts/small.mco.checkpoint").exists())

    def test_totals_are_right(self):
        self.photon(CASES.read_text().replace("200000", "100000"))
        for name, (reflectance, transmittance) in EXACT.items():
            budget = json.loads((self.at / f"{name}.json").read_text())["budget"]
            self.assertLessEqual(
                abs(budget["diffuse_reflectance"]["mean"] - reflectance),
                SIGMAS * budget["diffuse_reflectance"]["error"],
            )
            parts = [budget[f"{kind}_transmittance"] for kind in ("unscattered", "diffuse")]
            self.assertLessEqual(
                abs(sum(part["mean"] for part in parts) - transmittance),
                SIGMAS * math.hypot(*(part["error"] for part in parts)),
            )

    def test_bins_add_up_to_the_totals(self):
        self.photon(SMALL)
        mco = Mco((self.at / "small.mco").read_text())
        beyond = json.loads((self.at / "small.json").read_text())["beyond_the_bins"]
        rings = [math.pi * 0.02**2 * (2 * k + 1) for k in range(10)]
        edges = [math.cos(math.pi / 6 * k) for k in range(4)]
        angles = [2 * math.pi * (edges[k] - edges[k + 1]) for k in range(3)]
        specular, reflected, absorbed, transmitted = mco["RAT"]
        self.assertAlmostEqual(specular, (0.4 / 2.4) ** 2, places=6)
        self.assertAlmostEqual(specular + reflected + absorbed + transmitted, 1, delta=2e-3)
        for side, total in ("Rd", reflected), ("Tt", transmitted):
            lost = beyond["reflected" if side == "Rd" else "transmitted"]
            by_radius = [f * area for f, area in zip(mco[f"{side}_r"], rings)]
            self.assertAlmostEqual(sum(by_radius) + lost, total, delta=1e-4)
            by_angle = [f * solid for f, solid in zip(mco[f"{side}_a"], angles)]
            self.assertAlmostEqual(sum(by_angle), total, delta=1e-4)
            both = mco[f"{side}_ra"]
            for k, part in enumerate(by_radius):
                here = sum(f * solid for f, solid in zip(both[3 * k : 3 * k + 3], angles))
                self.assertAlmostEqual(here * rings[k], part, delta=1e-4)
        self.assertAlmostEqual(sum(mco["A_l"]), absorbed, delta=1e-4)
        self.assertAlmostEqual(sum(mco["A_z"]) * 0.01, absorbed, delta=2e-4)
        by_radius = [sum(mco["A_rz"][20 * k : 20 * k + 20]) * rings[k] * 0.01 for k in range(10)]
        self.assertAlmostEqual(sum(by_radius) + beyond["absorbed"], absorbed, delta=2e-4)

    def test_the_same_bytes_and_what_is_finished_is_kept(self):
        self.photon(SMALL)
        first = (self.at / "small.mco").read_bytes()
        self.assertIn("already finished", self.photon(SMALL))
        self.assertNotIn("already finished", self.photon(SMALL, "--seed", "2"))
        self.assertNotEqual((self.at / "small.mco").read_bytes(), first)
        self.photon(SMALL, "--width", "1", "-o", "other")
        self.assertEqual((self.at / "other/small.mco").read_bytes(), first)

    def test_broken_files(self):
        for right, wrong, message in (
            ("1.0\n1\n", "2.0\n1\n", "in.mci:1: the version of the file is `2.0`"),
            ("\n1\nsmall", "\n0\nsmall", "in.mci:2: 0 must be a whole number from 1 to 100000"),
            ("small.mco A", "small.mco B", "in.mci:3: output in the format `B`"),
            ("small.mco A", "../small.mco A", "in.mci:3: `../small.mco` must be a file's name"),
            ("20000", "many", "in.mci:4: `many` is not a number"),
            ("0.01 0.02", "0.01", "in.mci:5: expected dz and dr, and found 1 of 2 values"),
            ("0.01 0.02", "0.01 -1", "in.mci:5: -1 must be above 0"),
            ("20 10 3", "20 10 1e20", "in.mci:6: 1e20 must be a whole number"),
            ("0.8 0.1\n", "1.0 0.1\n", "in.mci:10: the layers that end here: "),
            ("1.4 1 50 0.8 0.1\n1.0\n", "", "in.mci:8: the file ends where"),
        ):
            self.assertIn(right, SMALL)
            self.assertIn(message, self.photon(SMALL.replace(right, wrong, 1), code=2))
            self.assertEqual([path.name for path in self.at.iterdir()], ["in.mci"])
        twice = SMALL.replace("\n1\n", "\n2\n", 1) + "".join(SMALL.splitlines(True)[2:])
        self.assertIn("another run of this file writes", self.photon(twice, code=2))


if __name__ == "__main__":
    unittest.main()
