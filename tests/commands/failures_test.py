#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""failures_test.py GONIO: what fails, what is left behind, and how a batch goes on."""

import json
import pathlib
import resource
import signal
import subprocess
import time
import unittest

from gonio_case import GONIO, SWEPT, GonioCase

SCENES = pathlib.Path(__file__).parents[2] / "bench/scenes"

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


class Failures(GonioCase):
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
        (self.at / "scene.toml").write_text(SWEPT.format(n=90, form="files"))
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

    def test_plan(self):
        (self.at / "s.toml").write_text(SWEPT.format(n=4, form="files"))
        plan = json.loads(self.gonio("plan", "s.toml", "--json"))["tables"][0]
        self.assertEqual(plan["solver"], "closed_form")
        self.assertEqual(plan["tiles"]["count"], 1)
        self.assertFalse(plan["finished"])
        self.gonio("run", "s.toml")
        plan = json.loads(self.gonio("plan", "s.toml", "--json"))["tables"][0]
        self.assertTrue(plan["finished"])
        self.assertEqual(plan["seconds"], 0)
        self.assertIn("an earlier run made it", self.gonio("plan", "s.toml"))
        self.assertIn("0 already finished", self.gonio("run", "s.toml", "--no-plan"))

    def test_plan_of_every_solver(self):
        for name, count in (("brushed_steel", 1), ("dfg", 2), ("slab", 5), ("skin", 7)):
            scene = SCENES / f"{name}.toml"
            plan = json.loads(self.gonio("plan", scene, "-o", "none", "--json"))
            self.assertEqual(len(plan["tables"]), count)
            for table in plan["tables"]:
                self.assertGreater(table["seconds"], 0, table["file"])
                self.assertGreater(table["error"], 0, table["file"])
                self.assertTrue(table["error_of"], table["file"])
        self.assertEqual(list(self.at.iterdir()), [], "a plan wrote something")


if __name__ == "__main__":
    unittest.main()
