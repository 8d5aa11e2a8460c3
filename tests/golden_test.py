#!/usr/bin/env python3
"""R1: the twelve chapters of the book still look as they did: few samples against a picture of many, by structural
similarity (Wang et al., "Image Quality Assessment", 2004), which must be above 0.98.

  golden_test.py                   # the test; $TEAPATH_PROGRAM, $TEAPATH_BACKEND as in tests/cli
  golden_test.py --renew [NAME …]  # makes the pictures anew, after a change that is meant to be seen

The pictures were looked at before they were taken in. A failing scene leaves reference, render and
difference in build/golden/. Needs numpy."""
import glob
import json
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(HERE)
sys.path.insert(0, os.path.join(HERE, "cli"))
from pictures import Png  # noqa: E402
from support import BACKEND, PROGRAM  # noqa: E402

GOLDEN = os.path.join(HERE, "references", "golden")
WIDTH = 80
LIMIT = 0.98
SAMPLES, GOLDEN_SAMPLES = 256, 2048


def scenes():
    """Name and file of every chapter."""
    files = sorted(glob.glob(os.path.join(ROOT, "scenes", "weekend", "*.json")))
    return {os.path.splitext(os.path.relpath(file, os.path.join(ROOT, "scenes")))[0].replace(os.sep, "_"): file
            for file in files}


def golden_file(name):
    return os.path.join(GOLDEN, name + ".png")


def render(file, samples, seed, output):
    with open(file, encoding="utf-8") as text:
        size = json.load(text).get("render", {})
    height = round(WIDTH * size.get("height", 720) / size.get("width", 1280))
    subprocess.run([PROGRAM, "render", file, "-o", output, "--size", f"{WIDTH}x{height}", "--spp", str(samples),
                    "--seed", str(seed), "--set", "render.sampler=sobol", "--backend", BACKEND, "--quiet"], check=True)


def pixels_of(file):
    with open(file, "rb") as data:
        png = Png(data.read())
    return np.array(list(png.pixels), dtype=np.float64).reshape(png.height, png.width, 3)


def blurred(image):
    """A Gaussian of sigma 1.5 pixels over 11 x 11, where it lies within the picture."""
    taps = np.exp(-0.5 * (np.arange(-5, 6) / 1.5) ** 2)
    taps /= taps.sum()
    for axis in (0, 1):
        length = image.shape[axis] - 10
        image = sum(tap * np.take(image, range(i, i + length), axis) for i, tap in enumerate(taps))
    return image


def similarity(a, b):
    """Mean structural similarity of two pictures of 0 to 255, over pixels and channels."""
    c1, c2 = (0.01 * 255) ** 2, (0.03 * 255) ** 2
    mean_a, mean_b = blurred(a), blurred(b)
    variance_a, variance_b = blurred(a * a) - mean_a ** 2, blurred(b * b) - mean_b ** 2
    covariance = blurred(a * b) - mean_a * mean_b
    quotient = ((2 * mean_a * mean_b + c1) * (2 * covariance + c2)
                / ((mean_a ** 2 + mean_b ** 2 + c1) * (variance_a + variance_b + c2)))
    return float(quotient.mean())


def save_ppm(path, image):
    with open(path, "wb") as file:
        file.write(b"P6\n%d %d\n255\n" % (image.shape[1], image.shape[0]))
        file.write(np.clip(image, 0, 255).astype(np.uint8).tobytes())


class Golden(unittest.TestCase):
    def test_every_scene_has_its_picture(self):
        stored = {os.path.splitext(name)[0] for name in os.listdir(GOLDEN) if name.endswith(".png")}
        self.assertEqual(stored, set(scenes()))

    def test_every_scene_looks_as_before(self):
        with tempfile.TemporaryDirectory() as folder:
            output = os.path.join(folder, "render.png")
            for name, file in scenes().items():
                with self.subTest(name):
                    render(file, SAMPLES, 1, output)
                    have, want = pixels_of(output), pixels_of(golden_file(name))
                    self.assertEqual(have.shape, want.shape)
                    found = similarity(have, want)
                    print("%-28s %.4f" % (name, found), file=sys.stderr)
                    if found <= LIMIT:
                        kept = os.path.join(ROOT, "build", "golden")
                        os.makedirs(kept, exist_ok=True)
                        row = np.concatenate([want, have, np.abs(have - want)], axis=1)
                        save_ppm(os.path.join(kept, name + ".ppm"), row)
                    self.assertGreater(found, LIMIT)

    def test_the_measure_finds_a_change(self):
        want = pixels_of(golden_file("weekend_12_final"))
        self.assertEqual(similarity(want, want), 1)
        self.assertLess(similarity(np.roll(want, 1, axis=1), want), LIMIT)
        self.assertLess(similarity(want[:, ::-1], want), 0.9)
        darker = want * 0.8
        self.assertLess(similarity(darker, want), LIMIT)


def renew(names):
    os.makedirs(GOLDEN, exist_ok=True)
    for name, file in scenes().items():
        if not names or name in names:
            print(name, flush=True)
            render(file, GOLDEN_SAMPLES, 0, golden_file(name))


if __name__ == "__main__":
    if "--renew" in sys.argv:
        renew(sys.argv[sys.argv.index("--renew") + 1:])
    else:
        unittest.main(verbosity=int(os.environ.get("TEAPATH_TEST_VERBOSITY", "1")))
