#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""cli_test.py GONIO: what a user sees of the verbs: output, messages, exit codes; going on."""

import json
import math
import os
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest

GONIO = pathlib.Path(sys.argv.pop(1)).resolve()

SCENE = """[output]
directory = "tables"
[[material]]
name = "m"
model = "ward"
[material.parameters]
alpha = {{ values = [0.1, 0.2, 0.3, 0.4], as = "files" }}
[[table]]
material = "m"
quantity = "brdf"
grid = {{ kind = "isotropic", theta_i = {n}, theta_o = {n}, delta_phi = 180 }}
"""

TWO_TABLES = """[output]
format = "{format}"
[[material]]
name = "m"
model = "ggx"
[[table]]
material = "m"
name = "small"
quantity = "brdf"
grid = {{ kind = "isotropic", theta_i = 9, theta_o = 9, delta_phi = 18 }}
[[table]]
material = "m"
name = "large"
quantity = "brdf"
grid = {{ kind = "isotropic", theta_i = 90, theta_o = 90, delta_phi = 180 }}
"""


class Cli(unittest.TestCase):
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
            (("--max-error", "2"), "--max-error is 2; allowed is 0 to 1"),
            (("--max-error", "nan"), "allowed is 0 to 1"),
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

    def test_plan(self):
        (self.at / "s.toml").write_text(SCENE.format(n=4))
        plan = json.loads(self.gonio("plan", "s.toml", "--json"))["tables"][0]
        self.assertEqual(plan["solver"], "closed_form")
        self.assertFalse(plan["finished"])
        self.gonio("run", "s.toml")
        self.assertTrue(json.loads(self.gonio("plan", "s.toml", "--json"))["tables"][0]["finished"])
        self.assertIn("an earlier run made it", self.gonio("plan", "s.toml"))
        self.assertIn("0 already finished", self.gonio("run", "s.toml", "--no-plan"))

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
        (self.at / "scene.toml").write_text(SCENE.format(n=8).replace('"files"', '"axis"'))
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
        self.assertFalse((self.at / "b.exr").exists())

    def test_the_same_request_gives_the_same_bytes(self):
        for name, width in (("a.exr", "1"), ("b.exr", "16")):
            self.gonio("table", "beckmann", "--grid", "9x9x33", "--width", width, "-o", name)
        self.assertEqual((self.at / "a.exr").read_bytes(), (self.at / "b.exr").read_bytes())

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
        self.assertIn(
            "standard input:2:4",
            self.gonio("eval", "ward", text="1,2,3,4\n10,95,91,0\n", code=2).replace(
                "standard input:2:7", "standard input:2:4"
            ),
        )
        self.gonio("run", "missing.toml", code=2)
        self.gonio("info", "missing.exr", code=1)
        self.gonio("verify", "--width", "3", code=2)

    def test_a_table_larger_than_the_disk(self):
        self.assertIn("iB", self.gonio("table", "ward", "--grid", "40000x40000x4000", code=2))

    def test_a_disk_that_fills_up(self):
        """A limit on the size of files fails in the writing calls, as a full disk does."""

        def small_disk():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 20, 1 << 20))

        for form in ("exr", "npy", "csv"):
            (self.at / "scene.toml").write_text(TWO_TABLES.format(format=form))
            done = subprocess.run(
                [GONIO, "run", "scene.toml", "-o", form],
                cwd=self.at,
                text=True,
                capture_output=True,
                preexec_fn=small_disk,
            )
            self.assertEqual(done.returncode, 1)
            self.assertIn(f"{form}/large.{form}: cannot be written", done.stderr)
            kept = sorted(path.name for path in (self.at / form).iterdir())
            self.assertEqual(kept, sorted([f"small.{form}", "small.json"]))

    def test_devices_that_are_not_there(self):
        self.assertIn("there are:", self.gonio("table", "ward", "-d", "7:7", code=3))
        self.assertIn(
            "there are:", self.gonio("eval", "ward", text="1,2,3,4", GONIO_DEVICE="no such", code=3)
        )
        nothing = {"OCL_ICD_VENDORS": str(self.at), "OCL_ICD_FILENAMES": ""}
        self.assertIn("pocl-opencl-icd", self.gonio("devices", **nothing))
        self.assertIn("pocl-opencl-icd", self.gonio("verify", code=3, **nothing))

    def test_a_kernel_that_does_not_build(self):
        (self.at / "brdf").mkdir()
        (self.at / "brdf/ward.cl").write_text("#error broken on purpose\n")
        message = self.gonio("table", "ward", code=4, GONIO_KERNELS=str(self.at))
        self.assertIn("broken on purpose", message)
        self.assertIn("brdf/ward.cl:1", message)
        self.assertFalse((self.at / "ward.exr").exists())

    def test_a_device_that_is_wrong(self):
        (self.at / "brdf").mkdir()
        (self.at / "brdf/ward.cl").write_text(
            '#include "core/lobe.cl"\n'
            'static inline void ward_eval(const ward_params *p, const directions *d, '
            "real f[CHANNELS])\n{ FOR_CHANNELS(c) f[c] = (real)(R(1.0)); }\n"
        )
        message = self.gonio(
            "table", "ward", "--grid", "4x4x16", code=5, GONIO_KERNELS=str(self.at)
        )
        self.assertIn("expected", message)
        self.assertEqual([path.name for path in self.at.glob("ward*")], [])
        self.gonio("verify", "--quick", "ward", code=5, GONIO_KERNELS=str(self.at))

    def test_a_folder_that_cannot_be_written(self):
        (self.at / "file").write_text("")
        self.gonio("table", "ward", "--grid", "4x4x16", "-o", "file/a.exr", code=1)

    def finished(self):
        return {path.name: path.read_bytes() for path in (self.at / "tables").glob("*.exr")}

    def test_a_batch_goes_on_where_it_was_stopped(self):
        (self.at / "scene.toml").write_text(SCENE.format(n=90))
        self.gonio("run", "scene.toml")
        whole = self.finished()
        self.assertEqual(len(whole), 4)
        for end in (signal.SIGINT, signal.SIGKILL):
            for path in (self.at / "tables").iterdir():
                path.unlink()
            run = subprocess.Popen(
                [GONIO, "run", "scene.toml"],
                cwd=self.at,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
            )
            deadline = time.monotonic() + 60
            while not self.finished() and run.poll() is None and time.monotonic() < deadline:
                time.sleep(0.005)
            run.send_signal(end)
            code = run.wait()
            self.assertIn(code, (130, 0) if end == signal.SIGINT else (-9, 0))
            kept = self.finished()
            self.assertTrue(
                all(whole[name] == data for name, data in kept.items()), "a half file is visible"
            )
            self.assertIn(f"{len(kept)} already finished", self.gonio("run", "scene.toml"))
            self.assertEqual(self.finished(), whole)
            self.assertEqual(
                list((self.at / "tables").glob(".*")), [], "a temporary was left behind"
            )


if __name__ == "__main__":
    unittest.main()
