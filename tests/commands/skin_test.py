#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""skin_test.py GONIO: what a user sees of `gonio skin` and `gonio models --skin`."""

import json
import signal
import subprocess
import time
import unittest

from gonio_case import GONIO, GonioCase


class Skin(GonioCase):
    def test_models_are_listed(self):
        models = json.loads(self.gonio("models", "--skin", "--json"))["skin_models"]
        self.assertEqual(len(models), 7)
        for model in models:
            self.assertIn(model["id"], self.gonio("models", "--skin"))
            self.assertTrue(model["citation"] and model["layers"])
            self.assertIn("Layers", self.gonio("models", "--skin", model["id"]))

    def test_a_ladder_as_json_table_and_picture(self):
        words = ("skin", "jacques_1998", "--melanin", "0.02,0.2", "--theta_i=8", "--error=1e-3")
        sets = json.loads(self.gonio(*words, "--json"))["sets"]
        light, dark = sets
        self.assertEqual(len(light["reflectance"]), 81)
        self.assertEqual(dark["parameters"]["melanin"], 0.2)
        self.assertGreater(light["Lab"][0], dark["Lab"][0])
        self.assertGreater(light["ITA"], dark["ITA"])
        for name in ("skin.csv", "skin.npy", "skin.exr", "skin.svg", "skin.png"):
            self.gonio(*words, "-o", name)
            first = (self.at / name).read_bytes()
            self.gonio(*words, "-o", name)
            self.assertEqual((self.at / name).read_bytes(), first, name)
        rows = [line for line in (self.at / "skin.csv").read_text().splitlines() if line[0] != "#"]
        self.assertTrue(rows[0].startswith("melanin,wavelength,reflectance,specular"))
        self.assertEqual(len(rows), 2 + 2 * 81)
        self.assertEqual(float(rows[2].split(",")[2]), light["reflectance"][0])
        self.assertIn("colour.Lab", self.gonio("info", "skin.npy", "--json"))

    def test_text_has_a_column_for_each_set(self):
        text = self.gonio("skin", "pyxopto", "--blood", "0.01:0.04:3", "--error=1e-3")
        row = next(line for line in text.splitlines() if line.startswith("540 "))
        values = [float(word) for word in row.split()[1:]]
        self.assertEqual(values, sorted(values, reverse=True))
        self.assertIn("sRGB", text)

    def test_a_fit_finds_what_a_spectrum_was_made_of(self):
        words = ("jacques_1998", "--error=1e-3", "--wavelengths", "450:650:10")
        made = json.loads(self.gonio("skin", *words, "--melanin", "0.1", "--json"))
        rows = zip(made["wavelengths"], made["sets"][0]["reflectance"])
        text = "wavelength,r\n" + "".join(f"{at},{r}\n" for at, r in rows)
        (self.at / "made.csv").write_text(text)
        fit = ("skin", "jacques_1998", "--fit", "made.csv", "--wavelengths", "450:650:20")
        free = ("--free", "melanin,blood", "-o", "fit.svg", "-o", "fit.csv")
        found = json.loads(self.gonio(*fit, *free, "--json"))
        self.assertLess(found["mean_residual"], 1e-3)
        self.assertAlmostEqual(found["parameters"]["melanin"]["value"], 0.1, delta=0.003)
        self.assertTrue((self.at / "fit.svg").exists() and (self.at / "fit.csv").exists())
        self.assertIn("mean residual", self.gonio(*fit, "--scattering", "1"))
        (self.at / "made.csv").write_text("wavelength,r\n400,30\n410,31\n")
        self.assertIn("per cent", self.gonio(*fit, code=2))
        self.assertIn("there is no column", self.gonio(*fit, "--column", "x", code=2))
        self.assertIn("a fit starts from one", self.gonio(*fit, "--blood", "0,1", code=2))

    def test_refusals(self):
        for words, part in (
            (("jaques_1998",), "did you mean `jacques_1998`?"),
            (("--melanine", "0.1"), "did you mean `melanin`?"),
            (("--melanin", "2"), "allowed is 0 to 1"),
            (("--melanin", "0.2,0.1,0.3"), "must all ascend or all descend"),
            (("--melanin", "0:1:3:log"), "log needs both above 0"),
            (("--melanin", "0.1", "--melanin", "0.2"), "twice"),
            (("--wavelengths", "300:500:10"), "known at 340 to 1000 nm"),
            (("--wavelengths", "500:300:10"), "FROM:TO:STEP"),
            (("--theta_i", "90"), "allowed is 0 to below 90 deg"),
            (("--error", "1"), "allowed is 1e-8 to 0.1"),
            (("-o", "skin.pdf"), "allowed are .png"),
            (("none.toml",), "none.toml: cannot be read"),
        ):
            self.assertIn(part, self.gonio("skin", *words, code=2))
        self.assertEqual(list(self.at.iterdir()), [])

    def test_ctrl_c_stops_the_brdf_of_layers_at_once(self):
        # A minute of work, half of it in one solution.
        grid = 'grid = { kind = "isotropic", theta_i = 90, theta_o = 90, delta_phi = 9 }'
        (self.at / "s.toml").write_text(
            '[[material]]\nname = "arm"\nskin = "meglinski_2002"\nwavelength = 550\n'
            f'[[table]]\nmaterial = "arm"\nquantity = "brdf"\nmax_error = 1e-6\n{grid}\n'
        )
        command = [GONIO, "run", "s.toml", "-o", "tables"]
        with subprocess.Popen(command, cwd=self.at, stdout=subprocess.PIPE) as running:
            time.sleep(1.5)
            running.send_signal(signal.SIGINT)
            sent = time.monotonic()
            running.communicate()
        self.assertEqual(running.returncode, 130)
        self.assertLess(time.monotonic() - sent, 1)
        self.assertEqual(list((self.at / "tables").iterdir()), [])

    def test_an_own_model_is_read_and_its_mistakes_have_a_place(self):
        text = '[[layers]]\nname = "x"\nd = 0.1\nn = 1.4\nmus = 50\ng = 0.8\nabsorption = '
        (self.at / "own.toml").write_text(text + '{ mixture = { water = 0.7 } }\n')
        self.assertIn("own", self.gonio("skin", "own.toml", "--wavelengths", "500,600"))
        (self.at / "own.toml").write_text(text + '{ mixture = { water = 1.7 } }\n')
        self.assertIn("own.toml:7:14:", self.gonio("skin", "own.toml", code=2))


if __name__ == "__main__":
    unittest.main()
