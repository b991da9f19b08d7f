#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""picture_test.py GONIO: what a user sees of `gonio picture`."""

import json
import os
import pty
import signal
import struct
import subprocess
import unittest

from gonio_case import GONIO, GonioCase


SCENE = """
[[material]]
name = "grey"
model = "lambert"

[picture]
width = 32
height = 16
camera = {{ from = [0, 0, 3], to = [0, 0, 0] }}
mesh = [{{ file = "{mesh}", material = "{material}" }}]
light = [{{ kind = "{kind}", towards = [0, 0, 1], irradiance = 1 }}]
"""


class Picture(GonioCase):
    def setUp(self):
        super().setUp()
        (self.at / "a.obj").write_text("v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n")

    def picture(self, *words, code=0):
        return self.gonio("picture", *words, code=code)

    def scene(self, mesh="a.obj", material="grey", kind="directional"):
        text = SCENE.format(mesh=mesh, material=material, kind=kind)
        (self.at / "scene.toml").write_text(text)
        return "scene.toml"

    def test_both_formats_and_the_same_bytes_again(self):
        self.assertEqual(self.picture(self.scene(), "-o", "a.png", "-o", "a.exr"), "a.png\na.exr\n")
        first = [(self.at / name).read_bytes() for name in ("a.png", "a.exr")]
        self.picture("scene.toml", "-o", "a.png", "-o", "a.exr", "--width", "1")
        self.assertEqual([(self.at / name).read_bytes() for name in ("a.png", "a.exr")], first)

    def test_the_size_keeps_the_shape_and_the_scene_gives_the_name(self):
        self.assertEqual(self.picture(self.scene(), "--size", "40"), "scene.png\n")
        header = (self.at / "scene.png").read_bytes()[16:24]
        self.assertEqual(struct.unpack(">II", header), (80, 40))

    def test_mistakes_are_told_with_their_place_and_leave_no_file(self):
        for message, scene in (
                ("scene.toml:10:18: b.obj: cannot be read", {"mesh": "b.obj"}),
                ("scene.toml:10:38: there is no material `gray`; did you mean `grey`",
                 {"material": "gray"}),
                ("scene.toml:11:19: `kind` cannot be \"directinal\"; did you mean `directional`",
                 {"kind": "directinal"}),
                ("scene.toml:11:30: unknown key `towards`", {"kind": "uniform"})):
            self.assertIn(message, self.picture(self.scene(**scene), "-o", "a.png", code=2))
        (self.at / "a.obj").write_text("v 1 2 three\n")
        self.assertIn("a.obj:1: `v` needs three", self.picture(self.scene(), "-o", "a.png", code=2))
        self.assertIn(".exr and .png", self.picture(self.scene(), "-o", "a.jpg", code=2))
        self.assertEqual(list(self.at.glob("a.[pe]*")), [])

    def test_a_sheet_holds_several_scenes(self):
        self.scene()
        made = self.picture("scene.toml", "scene.toml", "--sheet", "two.png")
        self.assertEqual(made, "two.png\n")
        width, height = struct.unpack(">II", (self.at / "two.png").read_bytes()[16:24])
        self.assertGreater(width, 2 * 32)
        self.assertGreater(height, 16)
        self.assertIn("--sheet", self.picture("scene.toml", "scene.toml", "-o", "a.png", code=2))

    def interrupted_at(self, step, *words):
        """Ctrl-C as soon as the line of progress tells of a step; returns that line."""
        master, slave = pty.openpty()
        run = subprocess.Popen([GONIO, "picture", *words], cwd=self.at, stderr=slave,
                               stdout=subprocess.DEVNULL)
        os.close(slave)
        told = ""
        while step not in told:
            told += os.read(master, 4096).decode()
        run.send_signal(signal.SIGINT)
        self.assertEqual(run.wait(), 130, told)
        os.close(master)
        return told

    def test_ctrl_c_leaves_what_is_finished_and_no_half_file(self):
        self.scene()
        layers = SCENE.replace('model = "lambert"', "layers = [{{ mua = 1, mus = 100 }}]").format(
            mesh="a.obj", material="grey", kind="directional")
        many = layers.replace("width = 32", "width = 32\nphotons = 1000000000")
        (self.at / "many.toml").write_text(many)
        (self.at / "large.toml").write_text(
            layers.replace("width = 32", "width = 8000\nsamples = 16\nphotons = 1000"))
        told = self.interrupted_at("many.toml: photons", "scene.toml", "many.toml")
        self.assertRegex(told, r" \d+ %, .* left")
        self.assertEqual([path.name for path in self.at.glob("*.png")], ["scene.png"])
        self.interrupted_at("large.toml: rays", "scene.toml", "large.toml", "--sheet", "two.png")
        self.interrupted_at("large.toml: rays", "large.toml", "-o", "a.exr", "-o", "a.png")
        names = {"a.obj", "scene.toml", "many.toml", "large.toml", "scene.png"}
        self.assertEqual({path.name for path in self.at.iterdir()}, names)

    def test_plan_tells_what_a_picture_computes(self):
        plan = subprocess.run([GONIO, "plan", self.scene(), "--json"], cwd=self.at, check=True,
                              capture_output=True).stdout
        picture = json.loads(plan)["picture"]
        self.assertGreater(picture["seconds"], 0)
        self.assertEqual([stage["kernel"] for stage in picture["stages"]], ["", "table.cl"])
        self.assertIn({"what": "albedo of `grey`", "why": "there is no uniform light"},
                      picture["left_out"])

    def test_layers_are_grey(self):
        (self.at / "layers.toml").write_text(
            SCENE.replace('model = "lambert"', "layers = [{{ mua = 1, mus = 100 }}]").format(
                mesh="a.obj", material="grey", kind="directional"))
        self.picture("layers.toml", "-o", "a.png")
        swept = (self.at / "layers.toml").read_text().replace(
            "mua = 1", "mua = {{ values = [1, 2] }}".format())
        (self.at / "swept.toml").write_text(swept)
        self.assertIn("swept.toml:2:1: material `grey` has sweeps; a picture shows one value",
                      self.picture("swept.toml", code=2))

    def test_a_scene_without_a_picture(self):
        (self.at / "none.toml").write_text("[[material]]\nname = 'a'\nmodel = 'lambert'\n"
                                           "[[table]]\nquantity = 'mean_albedo'\n")
        self.assertIn("has no [picture]", self.picture("none.toml", code=2))


if __name__ == "__main__":
    unittest.main()
