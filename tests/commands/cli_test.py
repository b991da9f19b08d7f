#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""cli_test.py GONIO: what a user sees of the verbs about models, and of wrong words."""

import json
import math
import unittest

from gonio_case import GonioCase


class Cli(GonioCase):
    def test_help_of_every_verb(self):
        listing = self.gonio("--help")
        verbs = "devices models eval sample table run photon skin info lookup compress verify"
        for verb in verbs.split():
            self.assertIn(verb, listing)
            self.assertIn("Usage", self.gonio(verb, "--help"))

    def test_listings_are_json(self):
        self.assertGreaterEqual(len(json.loads(self.gonio("devices", "--json"))["devices"]), 1)
        models = json.loads(self.gonio("models", "--json"))["models"]
        self.assertIn("torrance_sparrow", [model["id"] for model in models])
        self.assertEqual(
            json.loads(self.gonio("models", "ggx", "--json"))["id"], "torrance_sparrow"
        )

    def test_models_are_measured(self):
        measured = json.loads(self.gonio("models", "lommel_seeliger", "--measure", "--json"))
        (model,) = measured["models"]
        self.assertLess(model["largest_relative_error"], model["bound"])
        self.assertGreater(model["values_per_second"], 1e6)
        # albedo/2 (1 - mu ln(1 + 1/mu)) grows towards grazing light (Hapke 2012, chapter 8)
        exact = (1 - 0.01 * math.log(101)) / 2
        self.assertAlmostEqual(model["largest_albedo"]["value"], exact, delta=1e-3)
        self.assertTrue(model["largest_albedo"]["where"].startswith("n.l = 0.01"))
        self.assertIn("albedo up to", self.gonio("models", "lommel_seeliger", "--measure"))

    def test_plot_of_a_model(self):
        for name, start in (("a.png", b"\x89PNG"), ("a.svg", b"<?xml")):
            self.gonio("models", "ggx", "--plot", name, "--f0", "1,0.8,0.3", "--alpha=0.3")
            first = (self.at / name).read_bytes()
            self.assertTrue(first.startswith(start))
            self.gonio("models", "ggx", "--plot", name, "--f0", "1,0.8,0.3", "--alpha=0.3")
            self.assertEqual((self.at / name).read_bytes(), first)
        self.assertIn(".svg", self.gonio("models", "ggx", "--plot", "a.pdf", code=2))
        self.gonio("models", "--plot", "b.svg", code=2)
        self.gonio("models", "ggx", "--alpha", "0.3", code=2)
        self.gonio("models", "ggx", "--plot", "none/b.svg", code=1)

    def test_eval_agrees_with_the_reference(self):
        rows = "theta_i,phi_i,theta_o,phi_o\n30,0,30,180\n45,0,20,150\n90,0,10,0\n"
        for words in (
            ["ggx", "--alpha_x", "0.2", "--alpha_y=0.4"],
            ["ward", "--rho_s", "0.9,0.7,0.5"],
        ):
            for row in json.loads(self.gonio("eval", *words, "--json", text=rows))["rows"]:
                self.assertEqual(len(row["device"]), 3 if "--rho_s" in words else 1)
                for device, reference in zip(row["device"], row["reference"]):
                    self.assertAlmostEqual(device, reference, delta=1e-5 * abs(reference))

    def test_eval_golden_value(self):
        # At the specular direction of 30 degrees: 1/(4 pi 0.2 0.4 cos 30).
        line = self.gonio(
            "eval",
            "ward",
            "--rho_s",
            "1",
            "--alpha_x",
            "0.2",
            "--alpha_y",
            "0.4",
            text="30,0,30,180\n",
        ).splitlines()[1]
        self.assertAlmostEqual(float(line.split(",")[4]), 1.14860187, delta=1e-6)

    def test_sample(self):
        words = ["sample", "ggx", "--alpha_x", "0.1", "--f0", "1,0.5", "-n", "300", "--seed", "7"]
        lines = self.gonio(*words).splitlines()
        self.assertEqual(lines[0], "theta_o,phi_o,pdf,weight.R,weight.G")
        self.assertEqual(len(lines), 301)
        found = json.loads(self.gonio(*words, "--json"))
        self.assertEqual(len(found["rows"]), 300)
        below = [row for row in found["rows"] if row["theta_o"] >= 90]
        self.assertEqual(len(below), found["below_horizon"])
        self.assertTrue(all(row["pdf"] == 0 and row["weight"] == [0, 0] for row in below))
        for channel in 0, 1:
            mean = sum(row["weight"][channel] for row in found["rows"]) / 300
            self.assertAlmostEqual(mean, found["directional_albedo"][channel], delta=1e-6)
        for line, row in zip(lines[1:], found["rows"]):
            self.assertAlmostEqual(float(line.split(",")[0]), row["theta_o"], places=4)
        wrong = self.gonio("sample", "oren_nayar", code=2)
        self.assertIn("torrance_sparrow", wrong)
        self.gonio("sample", "lambert", "--theta_i", "90", code=2)
        self.gonio("sample", "lambert", "-n", "0", code=2)

    def test_bad_command_lines(self):
        self.assertIn("did you mean `ward`", self.gonio("table", "wrd", code=2))
        self.assertIn(
            "did you mean `alpha_x`", self.gonio("table", "ward", "--alpha_z", "1", code=2)
        )
        self.assertIn("1e-05 to 1", self.gonio("table", "ward", "--alpha", "2", code=2))
        self.assertIn("not a number", self.gonio("table", "ward", "--alpha", "wide", code=2))
        self.assertIn("nan", self.gonio("table", "ward", "--alpha", "nan", code=2))
        self.gonio("table", "ward", "--grid", "0x4x4", code=2)
        self.gonio("table", "ward", "--grid", "4x4", code=2)
        self.gonio("table", "ward", "-o", "a.tiff", code=2)
        self.gonio("--nonsense", code=2)
        self.gonio("eval", "ward", "--at", "missing.csv", code=2)
        below = self.gonio("eval", "ward", text="1,2,3,4\n10,95,91,0\n", code=2)
        self.assertIn("standard input:2:7", below)
        self.gonio("run", "missing.toml", code=2)
        self.gonio("info", "missing.exr", code=1)
        self.gonio("verify", "--width", "3", code=2)
        self.assertIn("`lambert`", self.gonio("verify", "--extreme", "lambert", code=2))

    def test_extreme_cases_of_one_model(self):
        report = json.loads(self.gonio("verify", "--extreme", "oren_nayar", "--json"))
        self.assertNotIn("media", report)
        self.assertEqual(len(report["spots"]), 3)
        for spot in report["spots"]:
            self.assertTrue(spot["name"].startswith("Oren-Nayar"), spot["name"])
            self.assertTrue(spot["passed"], spot["name"])


if __name__ == "__main__":
    unittest.main()
