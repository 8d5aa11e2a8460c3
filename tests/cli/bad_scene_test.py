#!/usr/bin/env python3
"""Scenes that are wrong: a clear sentence with file, place and remedy, exit code 3, nothing else."""
import json
import math
import os
import random
import re
import unittest

from pictures import Exr, Pfm, exr_bytes
from support import INPUT, CommandTest, main


class Refusals(CommandTest):
    def refused(self, name, *fragments):
        """Both commands refuse the file, and no picture is left."""
        before = self.files()
        result = self.render(name, "-o", "a.png")
        self.assert_error(result, INPUT, name, *fragments)
        self.assertEqual(self.files(), before)
        self.assert_error(self.teapath("info", name), INPUT, name, *fragments)


class BadFiles(Refusals):
    def test_missing_file(self):
        self.refused("nothing.json", "no such file", "check the path")

    def test_empty_file(self):
        self.write("empty.json", "")
        self.refused("empty.json", "empty", "docs/scene_format.md")
        self.write("blank.json", " \n\t\n")
        self.refused("blank.json", "empty")

    def test_random_bytes(self):
        for seed in range(3):
            self.write("noise.json", random.Random(seed).randbytes(1 << 20))
            self.refused("noise.json", "not valid JSON", "line", "column")

    def test_random_text(self):
        letters = '{}[]",:0123456789.eE+-truefalsn \n\\u'
        generator = random.Random(7)
        for _ in range(20):
            self.write("noise.json", "".join(generator.choices(letters, k=10000)))
            self.refused("noise.json")

    def test_truncated_json(self):
        text = self.read(self.scene()).decode()
        for length in (1, len(text) // 3, len(text) // 2, len(text) - 1):
            self.write("cut.json", text[:length])
            self.refused("cut.json", "not valid JSON at line 1, column")

    def test_deep_nesting(self):
        self.write("deep.json", "[" * 1000000)
        self.refused("deep.json", "nest deeper")

    def test_a_folder(self):
        os.mkdir(self.path("folder.json"))
        self.refused("folder.json", "this is a folder")

    def test_other_json(self):
        for text in ("[]", "1", '"scene"', "null", "true"):
            self.write("other.json", text)
            self.refused("other.json", "expected an object")
        self.write("other.json", "{}")
        self.refused("other.json", '"teapath" is missing')
        self.write("other.json", '{"teapath": 2}')
        self.refused("other.json", "version 2", "version 1")


# What is changed in the test's scene, and what the message must have.
BAD_VALUES = {
    "wrong type": (lambda s: s["render"].update(samples="many"),
                   "render.samples", "expected a number"),
    "a list for a number": (lambda s: s["render"].update(width=[1]), "render.width"),
    "half a sample": (lambda s: s["render"].update(samples=2.5), "render.samples", "whole number"),
    "negative size": (lambda s: s["render"].update(width=-32), "render.width", "out of range"),
    "size 0": (lambda s: s["render"].update(height=0), "render.height", "out of range"),
    "too many pixels": (lambda s: s["render"].update(width=100000, height=100000),
                        "render.width", "out of range"),
    "too many pixels in all": (lambda s: s["render"].update(width=65536, height=65536),
                               "render", "too many", "16384"),
    "no samples": (lambda s: s["render"].update(samples=0), "render.samples"),
    "no depth": (lambda s: s["render"].update(max_depth=0), "render.max_depth"),
    "negative seed": (lambda s: s["render"].update(seed=-1), "render.seed"),
    "field of view 0": (lambda s: s["cameras"][0].update(vertical_fov=0),
                        "cameras[0].vertical_fov", "above 0 and below 180"),
    "field of view 180": (lambda s: s["cameras"][0].update(vertical_fov=180),
                          "cameras[0].vertical_fov", "above 0 and below 180"),
    "look-from is look-at": (lambda s: s["cameras"][0].update(look_at=[0, 1, 4]),
                             "cameras[0].look_at", "looks at where it is"),
    "up parallel to the view": (lambda s: s["cameras"][1].update(look_from=[0, 6, 0]),
                                "cameras[1].up", "parallel"),
    "negative aperture": (lambda s: s["cameras"][0].update(aperture=-1), "cameras[0].aperture"),
    "two cameras of one name": (lambda s: s["cameras"][1].update(name="front"), "cameras",
                                "twice"),
    "unknown active camera": (lambda s: s.update(active_camera="frnt"), "active_camera",
                              'did you mean "front"?'),
    "unknown material": (lambda s: s["objects"][0].update(material="gray"),
                         "objects[0].material", 'unknown material "gray"',
                         'did you mean "grey"?'),
    "unknown texture": (lambda s: s["materials"]["grey"].update(color="wood"),
                        "materials.grey.color", 'unknown texture "wood"'),
    "unknown key": (lambda s: s["render"].update(sample=3), 'unknown key "sample"',
                    'did you mean "samples"?'),
    "unknown shape": (lambda s: s["objects"][0]["shape"].update(type="spere"),
                      "objects[0].shape.type", 'did you mean "sphere"?'),
    "unknown material type": (lambda s: s["materials"]["grey"].update(type="lambert"),
                              "materials.grey.type"),
    "no shape": (lambda s: s["objects"][0].pop("shape"), "objects[0]", '"shape" is missing'),
    "texture in itself": (
        lambda s: s.update(textures={"a": {"type": "checker", "even": "a", "odd": 1}}),
        "textures.a", "contains itself"),
    "textures in a circle": (
        lambda s: s.update(textures={"a": {"type": "checker", "even": "b", "odd": 1},
                                     "b": {"type": "checker", "even": 0, "odd": "c"},
                                     "c": {"type": "checker", "even": "a", "odd": 0}}),
        "textures.", "contains itself"),
    "negative colour": (lambda s: s["materials"]["grey"].update(color=[-1, 0, 0]),
                        "materials.grey.color", "negative"),
    "colour of two numbers": (lambda s: s["materials"]["grey"].update(color=[1, 0]),
                              "materials.grey.color", "3 numbers"),
    "scale 0": (lambda s: s["objects"][0].update(transform={"scale": [1, 0, 1]}),
                "objects[0].transform.scale"),
    "corners swapped": (lambda s: s["objects"][1]["shape"].update(low=[5, 5]),
                        "objects[1].shape.low", "swap"),
    "too many generated spheres": (
        lambda s: s.update(generate=[{"type": "sphere_grid", "columns": 65535, "rows": 65535}]),
        "generate[0]", "20 million"),
    "a huge number": (lambda s: s["objects"][0]["shape"].update(radius=1e300),
                      "objects[0].shape.radius", "too large"),
}


class BadValues(Refusals):
    def test_each_bad_value(self):
        for title, (change, *fragments) in BAD_VALUES.items():
            with self.subTest(title):
                self.scene(change=change)
                self.refused("scene.json", *fragments)

    def test_numbers_that_json_has_not(self):
        for number, fragment in (("NaN", "not valid JSON"), ("nan", "not valid JSON"),
                                 ("Infinity", "not valid JSON"), ("1e400", "too large"),
                                 ("-1e400", "too large")):
            with self.subTest(number):
                text = self.read(self.scene()).decode()
                self.write("number.json", text.replace('"radius": 0.5', f'"radius": {number}'))
                self.refused("number.json", fragment)

    def test_a_key_twice(self):
        text = self.read(self.scene()).decode()
        self.write("twice.json", text.replace('"radius": 0.5', '"radius": 0.5, "radius": 0.6'))
        self.refused("twice.json", '"radius" stands twice')

    def test_the_place_of_a_mistake(self):
        self.write("place.json", '{\n  "teapath": 1,\n  "name": oops\n}\n')
        self.refused("place.json", "line 3, column 11")


class InvalidRadiance(CommandTest):
    """Samples that come out as no number: black, counted, told; the rest of the picture is right."""

    def check(self, image, content):
        self.write(image, content)

        def change(scene):
            scene["objects"][0]["material"] = {"type": "diffuse_light", "strength": 1,
                                               "emission": {"type": "image", "file": image}}
        self.scene(change=change)
        result = self.render("scene.json", "-o", "a.exr", "-o", "a.png", "-o", "a.hdr", "-o",
                             "a.pfm", "--spp", 50, "--quiet")
        self.assert_done(result)
        lines = result.stderr.splitlines()
        self.assertEqual(len(lines), 1, result.stderr)
        found = re.fullmatch(r"warning: (\d+) of (\d+) samples had a radiance that is NaN, infinite "
                             r"or beyond 1e\+14; they count as black \(look .*\)", lines[0])
        self.assertTrue(found, result.stderr)
        invalid, samples = map(int, found.groups())
        self.assertEqual(samples, 50 * 32 * 24)
        self.assertTrue(0.02 * samples < invalid < 0.9 * samples)
        exr = Exr(self.read("a.exr"))
        for channel, kind in exr.types.items():
            if kind != "uint":
                self.assertTrue(all(map(math.isfinite, exr.floats(channel))), channel)
        self.assertTrue(all(map(math.isfinite, Pfm(self.read("a.pfm")).values)))
        middle, corner = 13 * 32 + 16, 0
        self.assertEqual(exr.floats("R")[middle], 0)
        self.assertAlmostEqual(exr.floats("R")[corner], 0.2, places=5)

    def test_not_a_number(self):
        self.check("nan.exr", exr_bytes(2, 1, [math.nan] * 6))

    def test_infinite(self):
        self.check("infinite.exr", exr_bytes(2, 1, [math.inf, 1, 1, 1, math.inf, 1]))

    def test_beyond_what_can_be_summed(self):
        self.check("large.hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\xff\xff\xff\xff")


class OddButAllowed(CommandTest):
    """A warning at most, and a picture."""

    def warned(self, change, *fragments):
        self.scene(change=change)
        result = self.render("scene.json", "-o", "a.png")
        self.assert_done(result)
        warnings = [line for line in result.stderr.splitlines() if line.startswith("warning: ")]
        self.assertEqual(len(warnings), 1, result.stderr)
        for fragment in ("scene.json", *fragments):
            self.assertIn(fragment, warnings[0])
        self.assertIn("a.png", self.files())
        quiet = self.render("scene.json", "-o", "a.png", "--quiet")
        self.assertEqual(quiet.stderr.splitlines(), warnings, "warnings are never hidden")

    def test_radius_0(self):
        self.warned(lambda s: s["objects"][0]["shape"].update(radius=0), "objects[0].shape.radius",
                    "never hit")

    def test_rectangle_without_area(self):
        self.warned(lambda s: s["objects"][1]["shape"].update(low=[3, -3]), "objects[1].shape",
                    "never hit")
        flat = {"type": "rectangle", "corner": [0, 0, 0], "edge_u": [1, 0, 0],
                "edge_v": [2, 0, 0]}
        self.warned(lambda s: s["objects"][1].update(shape=flat), "objects[1].shape", "never hit")

    def test_missing_image(self):
        self.warned(self.with_image("nothing.png"), "nothing.png", "cyan")

    def test_image_with_a_wrong_header(self):
        for content in (b"", b"\x89PNG\r\n\x1a\n", b"\x89PNG\r\n\x1a\n" + bytes(1000),
                        b"\xff\xd8\xff\xe0" + bytes(100), b"BM" + b"\xff" * 200,
                        b"\x76\x2f\x31\x01" + b"\xff" * 100, b"#?RADIANCE\n\n-Y 9999999 +X 9\n",
                        b"P6 99999999 99999999 255\n", random.Random(1).randbytes(100000)):
            with self.subTest(content[:12]):
                self.write("bad.png", content)
                self.warned(self.with_image("bad.png"), "bad.png", "cyan")

    def test_image_that_is_a_folder(self):
        os.mkdir(self.path("folder.png"))
        self.warned(self.with_image("folder.png"), "folder.png", "cyan")

    def test_an_empty_scene(self):
        self.write("scene.json", '{"teapath": 1}')
        self.assert_done(self.render("scene.json", "-o", "a.png", "--spp", 1, "--size", "8x8"))

    def test_a_million_spheres_in_one_place(self):
        sphere = json.dumps({"shape": {"type": "sphere", "radius": 0.5}, "material": "grey"})
        text = self.read(self.scene()).decode()
        start = text.index('"objects": [') + len('"objects": [')
        count = int(os.environ.get("TEAPATH_TEST_SPHERES", "1000000"))
        self.write("many.json", text[:start] + f"{sphere}, " * count + text[start:])
        result = self.render("many.json", "-o", "a.png", "--spp", 1, "--size", "4x4", timeout=600)
        if result.returncode == 0:
            self.assertIn("a.png", self.files())
        else:
            self.assert_error(result, INPUT, "many.json")

    @staticmethod
    def with_image(name):
        def change(scene):
            scene["materials"]["grey"]["color"] = {"type": "image", "file": name}
        return change


if __name__ == "__main__":
    main()
