#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""bench_test.py GONIO ROOT: what a user sees of `gonio bench`: numbers, plots, and a page that a
browser shows without a complaint."""

import csv
import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import PIL.Image
import jsonschema
import numpy

ROOT = pathlib.Path(sys.argv.pop()).resolve()
GONIO = pathlib.Path(sys.argv.pop()).resolve()
# Without those that take most of the time, and one of each kind.
SECTIONS = ["lookup", "split-sum", "tallies", "time-to-error", "generators", "generator-errors",
            "device-generators", "scaling", "work-size", "tiles", "start"]
STRIP = 700  # pixels
LEGEND = 730  # pixels from the left: beyond are the legends of plots
COLOURS = [0x3B5A7A, 0xD8504A, 0x3A9A55, 0x8A63B8, 0xC98A1B, 0x2A9AA8, 0x8C564B, 0x6B6B6B, 0xC2519C,
           0x7F9A1B]  # of series, in their order


def gonio(*words, code=0):
    done = subprocess.run([GONIO, "bench", *words], text=True, capture_output=True)
    assert done.returncode == code, f"{words}: {done.returncode} {done.stdout}{done.stderr}"
    return done.stderr if code else done.stdout


class Bench(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.at = pathlib.Path(cls.folder.name) / "report"
        cls.text = gonio("--quick", "-o", cls.at, *SECTIONS)
        cls.results = json.loads((cls.at / "results.json").read_text())

    def plot(self, name):
        return next(plot for plot in self.results["plots"] if plot["id"] == name)

    def test_results_fit_their_schema(self):
        schema = json.loads((ROOT / "tests/commands/bench.schema.json").read_text())
        jsonschema.validate(self.results, schema)
        self.assertEqual([plot["id"] for plot in self.results["plots"]], SECTIONS)
        for plot in self.results["plots"]:
            for point in plot["points"]:
                for axis in ("x", "y"):
                    value = point[axis]
                    self.assertLessEqual(value["low"], value["median"])
                    self.assertLessEqual(value["median"], value["high"])

    def test_the_table_holds_the_same_points(self):
        with open(self.at / "results.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        points = [point for plot in self.results["plots"] for point in plot["points"]]
        self.assertEqual(len(rows), len(points))
        for row, point in zip(rows, points):
            self.assertEqual(row["label"], point["label"])
            self.assertEqual(float(row["x"]), point["x"]["median"])
            self.assertEqual(float(row["y"]), point["y"]["median"])
            for name in ("extrapolated", "Geval_per_s"):
                if name in row:
                    self.assertEqual(row[name], str(int(point["more"][name]))
                                     if name in point["more"] else "")

    def test_what_is_best_is_beaten_by_nothing(self):
        measured = self.plot("lookup")["points"]
        reference = [p for p in measured if p["y"]["median"] == 0]
        self.assertEqual([(p["series"], p["best"]) for p in reference],
                         [("reference, one core", False)])
        points = [p for p in measured if p not in reference]
        for point in points:
            beaten = any(
                other["x"]["median"] <= point["x"]["median"]
                and other["y"]["median"] <= point["y"]["median"]
                and other is not point
                and (other["x"], other["y"]) != (point["x"], point["y"])
                for other in points
            )
            self.assertNotEqual(point["best"], beaten, point)

    def test_finer_tables_are_closer_and_cubic_beats_linear(self):
        points = self.plot("lookup")["points"]
        errors = {(p["series"], p["label"]): p["y"]["median"] for p in points}
        for how in ("nearest", "linear", "cubic"):
            series = f"{how}, float32"
            self.assertLess(errors[series, "32x32x64"], errors[series, "8x8x16"] / 2, how)
        self.assertLess(errors["cubic, float32", "32x32x64"],
                        errors["linear, float32", "32x32x64"])
        self.assertLess(errors["device, list of pairs", "float32"], 1e-5)

    def test_quadrature_beats_sampling(self):
        points = self.plot("split-sum")["points"]
        quadrature = [p["y"]["median"] for p in points if p["series"] == "quadrature"]
        sampling = [p["y"]["median"] for p in points if p["series"] != "quadrature"]
        self.assertLess(100 * max(quadrature), min(sampling))

    def test_photons_tell_their_errors(self):
        """Seeds are given, so these are the same on every device."""
        points = self.plot("tallies")["points"]
        errors = {(p["series"], p["label"]): p["y"]["median"] for p in points}
        for tally in ("R(alpha)", "A(z)"):
            for photons in ("2^12 photons", "2^14 photons"):
                off = errors[f"{tally}, true", photons]
                told = errors[f"{tally}, standard error", photons]
                self.assertLess(abs(off / told - 1), 0.5, (tally, photons))
        for tally in ("R(alpha)", "A(z)", "R(r)", "R(t)"):
            ratio = (errors[f"{tally}, standard error", "2^12 photons"]
                     / errors[f"{tally}, standard error", "2^14 photons"])
            self.assertLess(abs(ratio / 2 - 1), 0.3, tally)

    def test_stages_have_names(self):
        plot = self.plot("start")
        for point in plot["points"]:
            self.assertEqual(plot["x"]["names"][round(point["x"]["median"]) - 1], point["label"])

    def test_pictures_have_ink(self):
        for name in SECTIONS:
            self.assertIn(b"<svg", (self.at / f"{name}.svg").read_bytes()[:200])
            self.assertGreater((self.at / f"{name}.png").stat().st_size, 10_000)

    def test_a_report_is_itself(self):
        text = gonio("--compare", self.at, self.at / "results.json")
        self.assertIn("same", text)
        self.assertNotIn("*\n", text.split("\n", 1)[1])
        self.columns_are_straight(text)
        slower = json.loads(json.dumps(self.results))
        for plot in slower["plots"]:
            for point in plot["points"]:
                for key in ("median", "low", "high"):
                    point["x"][key] *= 3
        other = self.at / "slower.json"
        other.write_text(json.dumps(slower))
        self.assertRegex(gonio("--compare", self.at, other), r" 3\.000 \([0-9.]+ to [0-9.]+\)")

    def columns_are_straight(self, text):
        for plot in self.results["plots"]:
            rows = text[text.index(f"\n{plot['title']}\n"):].split("\n\n")[0].splitlines()[2:]
            at = rows[0].index(plot["x"]["title"])
            self.assertEqual(len(rows), 1 + len(plot["points"]))
            for row, point in zip(rows[1:], plot["points"]):
                self.assertEqual(row[:at].split(), (point["series"] + " " + point["label"]).split())
                self.assertRegex(row[at - 2:], r"^  \S")

    def test_a_browser_shows_the_page(self):
        page = (self.at / "report.html").read_text()
        # Every plot on a strip of its own, to look for ink in each.
        strips = "<style>body > :not(#plots) { display: none } body { margin: 0 !important } " \
            f"section {{ height: {STRIP}px; overflow: hidden }} </style></head>"
        (self.at / "strips.html").write_text(page.replace("</head>", strips))
        done = subprocess.run(
            ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--enable-logging=stderr",
             f"--window-size=1000,{STRIP * len(SECTIONS)}", "--virtual-time-budget=20000",
             f"--user-data-dir={self.at}/profile", f"--screenshot={self.at}/page.png",
             (self.at / "strips.html").as_uri()],
            text=True, capture_output=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([line for line in done.stderr.splitlines() if "CONSOLE" in line], [])
        picture = numpy.asarray(PIL.Image.open(self.at / "page.png").convert("RGB"), dtype=int)
        codes = picture @ [1 << 16, 1 << 8, 1]
        for k, name in enumerate(SECTIONS):
            strip = codes[k * STRIP:(k + 1) * STRIP, :LEGEND]
            ink = sum((strip == colour).sum() for colour in COLOURS)
            self.assertGreater(ink, 5 * len(self.plot(name)["points"]), name)

    def test_bad_input(self):
        self.assertIn("did you mean `start`", gonio("strat", code=2))
        self.assertIn("no such file", gonio("--compare", self.at / "none", self.at, code=2))
        bad = self.at / "bad.json"
        bad.write_text("{}")
        self.assertIn("not the results of `gonio bench`", gonio("--compare", bad, self.at, code=2))

    def test_what_is_finished_is_kept(self):
        at = self.at / "stopped"
        process = subprocess.Popen([GONIO, "bench", "--quick", "-o", at, "tiles", "models"],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        time.sleep(2)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, errors)
        self.assertEqual([plot["id"] for plot in
                          json.loads((at / "results.json").read_text())["plots"]], ["tiles"])


if __name__ == "__main__":
    unittest.main(verbosity=0)
