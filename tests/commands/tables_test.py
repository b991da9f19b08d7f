#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""tables_test.py GONIO: what a user sees of the verbs that make and read tables."""

import json
import unittest

from gonio_case import SWEPT, GonioCase


class Tables(GonioCase):
    def test_table_and_info(self):
        for name in ("a.exr", "a.npy", "a.csv"):
            self.gonio("table", "ggx", "--alpha", "0.1", "--grid", "8x8x16", "-o", name)
            info = json.loads(self.gonio("info", name, "--json"))
            self.assertEqual(info["table"]["axes"][0]["name"], "theta_i")
        self.gonio(
            "table",
            "ggx",
            "--grid",
            "90x90x180",
            "--kind",
            "rusinkiewicz",
            "--spacing",
            "merl",
            "-o",
            "m.binary",
        )
        self.assertEqual((self.at / "m.binary").stat().st_size, 12 + 3 * 8 * 90 * 90 * 180)

    def test_half_precision_tells_its_rounding(self):
        half = ("table", "ggx", "--grid", "8x8x16", "--half", "-o")
        self.assertIn("adds up to 4.9e-04 of a value", self.gonio(*half, "a.exr"))
        rounding = json.loads((self.at / "a.json").read_text())["run"]["rounding_to_half"]
        self.assertEqual(list(rounding.values()), [2**-11, 2**-25, 2**-14])
        self.assertNotIn("adds up", self.gonio(*half[:-2], "-o", "b.exr"))
        self.assertIn("--half is for the format exr", self.gonio(*half, "a.npy", code=2))

    def test_table_of_an_integral(self):
        mu, alpha = "mu = { to = 1, count = 3 }", "alpha = { values = [0.1, 0.2] }"
        dfg = ("table", "ggx", "--quantity", "dfg")
        self.gonio(*dfg, "--axis", mu, "--axis", alpha, "-o", "d.npy")
        axes = json.loads(self.gonio("info", "d.npy", "--json"))["table"]["axes"]
        self.assertEqual([axis["name"] for axis in axes], ["mu", "alpha"])
        alpa = ("--axis", alpha.replace("ha", "a"))
        self.assertIn("--axis:2:8: `alpa`", self.gonio(*dfg, "--axis", mu, *alpa, code=2))
        self.assertIn("needs one axis `mu`", self.gonio(*dfg, code=2))
        self.assertIn("no --grid", self.gonio(*dfg, "--grid", "4x4x4", code=2))
        self.assertIn("no --axis", self.gonio("table", "ggx", "--axis", mu, code=2))

    def test_table_by_its_error_or_time(self):
        lambert = ("table", "lambert", "-o", "a.npy")
        rough = ("table", "oren_nayar", "-o", "rough.npy", "--max-error")

        def header(name):
            return json.loads(self.gonio("info", name, "--json"))["table"]

        self.gonio(*rough, "0.02", "--interpolation", "cubic", "--samples", "node")
        about = header("rough.npy")["attributes"]
        self.assertLessEqual(about["interpolation.error"], 0.02)
        self.assertIn("cubic", about["interpolation"])
        self.gonio(*lambert, "--time", "0.1 s")
        self.assertEqual(header("a.npy")["attributes"]["time"], 0.1)
        mu = ("--quantity", "directional_albedo", "--axis", "mu = { to = 1, count = 3 }")
        self.gonio(*lambert, *mu, "--max-error", "1e-3")
        self.assertEqual(header("a.npy")["attributes"]["max_error"], 1e-3)

        none = ("table", "lambert", "-o", "none.npy")
        for words, message in (
            (("--time", "5"), 'allowed is a time such as "5 s"'),
            (("--max-error", "2"), "--max-error is 2; allowed is 1e-14 to 1"),
            (("--max-error", "nan"), "allowed is 1e-14 to 1"),
            (("--max-error", "0"), "allowed is 1e-14 to 1"),
            (("--max-error", "0.1", "--grid", "4x4x4"), "--grid has counts"),
            (("--interpolation", "cubic"), "--max-error or --time"),
        ):
            self.assertIn(message, self.gonio(*none, *words, code=2))
        self.assertFalse((self.at / "none.npy").exists())
        out_of_reach = (*rough, "1e-4", "--time", "0.01 s")
        before = (self.at / "rough.npy").read_bytes()
        self.assertIn("--best-effort", self.gonio(*out_of_reach, code=1))
        self.assertEqual((self.at / "rough.npy").read_bytes(), before)
        self.gonio(*out_of_reach, "--best-effort")
        self.assertGreater(header("rough.npy")["attributes"]["interpolation.error"], 1e-4)

    def test_lookup(self):
        rows = "theta_i,phi_i,theta_o,phi_o\n30.5,400,30.5,220\n12,0,0.2,-77\n"
        model = ["ggx", "--alpha", "0.4"]
        expected = [
            row["reference"][0]
            for row in json.loads(self.gonio("eval", *model, "--json", text=rows))["rows"]
        ]
        for name, grid in (
            ("a.exr", ["--grid", "60x60x120"]),
            ("b.npy", ["--grid", "20x40x20x40", "--samples", "node"]),
            ("c.csv", ["--grid", "40x40x60", "--kind", "rusinkiewicz"]),
            ("d.binary", ["--grid", "90x90x180", "--kind", "rusinkiewicz", "--spacing", "merl"]),
        ):
            self.gonio("table", *model, *grid, "-o", name)
            (self.at / "at.csv").write_text(rows)
            for how, error in (("linear", 0.02), ("cubic", 0.01)):
                lines = self.gonio("lookup", name, "--at", "at.csv", "--interpolation", how)
                found = json.loads(
                    self.gonio("lookup", name, "--interpolation", how, "--json", text=rows)
                )
                for k, line in enumerate(lines.splitlines()[1:]):
                    value = float(line.split(",")[4])
                    self.assertEqual(found["rows"][k]["value"][0], value)
                    self.assertAlmostEqual(value, expected[k], delta=error * expected[k])
            self.assertIn("standard input:1:1", self.gonio("lookup", name, text="91,0,0,0", code=2))
        self.assertIn("nearest", self.gonio("lookup", "a.exr", "--interpolation", "spline", code=2))
        self.gonio("lookup", "missing.exr", code=1)
        (self.at / "text.exr").write_text("not a table")
        self.gonio("lookup", "text.exr", code=2)

    def test_lookup_in_a_swept_table(self):
        (self.at / "scene.toml").write_text(SWEPT.format(n=8, form="axis"))
        self.gonio("run", "scene.toml")
        row = "20,0,20,180\n"
        (table,) = (self.at / "tables").glob("*.exr")
        missing = self.gonio("lookup", table, text=row, code=2)
        self.assertIn("--alpha; it has 0.1, 0.2, 0.3, 0.4", missing)
        elsewhere = self.gonio("lookup", table, "--alpha=0.25", text=row, code=2)
        self.assertIn("0.25 is not in", elsewhere)
        self.assertIn("`alpha`?", self.gonio("lookup", table, "--alphq", "0.1", code=2, text=row))
        values = [
            float(self.gonio("lookup", table, f"--alpha={a}", text=row).split(",")[-1])
            for a in (0.1, 0.2, 0.4)
        ]
        self.assertEqual(values, sorted(values, reverse=True))

    def test_compress(self):
        grid = ["--grid", "30x30x60", "--kind", "rusinkiewicz", "--samples", "node"]
        self.gonio("table", "beckmann", "--f0", "0.9,0.6,0.3", *grid, "-o", "t.npy")
        rows = "30,0,30,180\n5,10,40,150\n"
        for name, least in (("r.exr", 3), ("r.npy", 0.99)):
            report = json.loads(self.gonio("compress", "t.npy", "-o", name, "--json"))
            self.assertLessEqual(report["largest_relative_error"], 1e-3)
            self.assertGreater(report["ratio"], least)
            self.assertIn("root mean square", self.gonio("compress", "t.npy", "-o", name))
            words = ["lebedev", "--residual", name, "--json"]
            for row in json.loads(self.gonio("eval", *words, text=rows))["rows"]:
                for device, reference in zip(row["device"], row["reference"]):
                    self.assertAlmostEqual(device, reference, delta=5e-5 * reference)
        self.gonio("table", "lebedev", "--residual", "r.exr", "--grid", "8x8x16", "-o", "a.exr")
        self.assertIn("r.exr", self.gonio("info", "a.exr"))
        self.assertIn("log(f / lobe)", self.gonio("info", "r.exr"))

    def test_compress_and_residual_refuse_what_they_cannot_read(self):
        self.gonio("table", "ggx", "--grid", "8x8x16", "-o", "a.exr")
        (self.at / "text.csv").write_text("no table\n")
        for name in ("missing.exr", "text.csv", "a.exr", "."):
            for words in ("compress {} -o b.exr", "eval lebedev --residual {}"):
                message = self.gonio(*words.format(name).split(), text="30,0,30,180\n", code=2)
                self.assertIn(f"gonio: {name}: ", message)
                self.assertIn("a residual is a table over theta_h, theta_d, phi_d", message)
        self.assertIn(".npy", self.gonio("compress", "a.exr", "-o", "b.csv", code=2))
        for error in ("nan", "0.6"):
            message = self.gonio("compress", "a.exr", "-o", "b.exr", "--error", error, code=2)
            self.assertIn(f"--error is {error}; allowed is 0 to 0.5", message)
        self.assertFalse((self.at / "b.exr").exists())

    def test_the_same_request_gives_the_same_bytes(self):
        for name, width in (("a.exr", "1"), ("b.exr", "16")):
            self.gonio("table", "beckmann", "--grid", "9x9x33", "--width", width, "-o", name)
        self.assertEqual((self.at / "a.exr").read_bytes(), (self.at / "b.exr").read_bytes())


if __name__ == "__main__":
    unittest.main()
