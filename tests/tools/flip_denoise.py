#!/usr/bin/env python3
"""flip_denoise.py TEAPATH [--folder FOLDER] [--samples N] [--reference N] [--width N] [SCENE …]: how far
pictures are from the finished one before and after denoising, by FLIP (Andersson et al. 2020). Renders
each scene with few samples, noisy and denoised, and with many and another seed, and prints a table in
Markdown. Files that are there already are taken as they are. Needs tests/tools/requirements.txt."""
import argparse
import json
import os
import subprocess
import tempfile

import flip_evaluator
import numpy
import OpenEXR

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCENES = ["cornell_box", "showcase", "thesis/cornell_three_spheres", "thesis/materials", "weekend/12_final"]


def size_of(scene, width):
    """The scene's own shape at this width, in pixels."""
    with open(scene, encoding="utf-8") as file:
        render = json.load(file).get("render", {})
    return width, max(1, round(width * render.get("height", 720) / render.get("width", 1280)))


def render(program, scene, output, size, *options):
    if not os.path.exists(output):
        subprocess.run([program, "render", scene, "-o", output, "--size", "%dx%d" % size, "-q", *options], check=True)


def planes(path):
    """The picture and, where it was denoised, the noisy one: height x width x 3 floats each."""
    with OpenEXR.File(path) as file:
        channels = file.channels()
        picture = next(channels[name] for name in ("RGBA", "RGB") if name in channels).pixels[..., :3]
        noisy = channels["noisy"].pixels if "noisy" in channels else None
        return [numpy.ascontiguousarray(plane, dtype=numpy.float32) for plane in (picture, noisy) if plane is not None]


def shown(radiance):
    """sRGB values in [0, 1]."""
    c = numpy.clip(radiance, 0, 1)
    return numpy.where(c <= 0.0031308, 12.92 * c, 1.055 * c ** (1 / 2.4) - 0.055).astype(numpy.float32)


def flip(reference, test):
    return flip_evaluator.evaluate(shown(reference), shown(test), "LDR")[1]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("teapath")
    parser.add_argument("scenes", nargs="*", default=SCENES, help="paths below scenes/ without .json")
    parser.add_argument("--folder", help="where pictures are kept; otherwise they are not")
    parser.add_argument("--samples", default="16")
    parser.add_argument("--reference", default="2048", help="samples of the finished pictures")
    parser.add_argument("--width", type=int, default=320)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = arguments.folder or temporary
        os.makedirs(folder, exist_ok=True)
        print("| scene | FLIP noisy | FLIP denoised | RMSE noisy | RMSE denoised |\n| --- | --- | --- | --- | --- |")
        for name in arguments.scenes:
            scene = os.path.join(ROOT, "scenes", name + ".json")
            size = size_of(scene, arguments.width)
            files = [os.path.join(folder, "%s_%s.exr" % (name.replace("/", "_"), kind)) for kind in ("few", "many")]
            render(arguments.teapath, scene, files[0], size, "--spp", arguments.samples, "--denoise")
            render(arguments.teapath, scene, files[1], size, "--spp", arguments.reference, "--seed", "1")
            few, finished = planes(files[0]), planes(files[1])[0]
            if len(few) != 2:
                raise SystemExit("the picture was not denoised: is Open Image Denoise there?")
            denoised, noisy = few
            rmse = [float(numpy.sqrt(numpy.mean((shown(p) - shown(finished)) ** 2))) for p in (noisy, denoised)]
            print("| %s | %.3f | %.3f | %.3f | %.3f |" % (name, flip(finished, noisy), flip(finished, denoised), *rmse),
                  flush=True)


if __name__ == "__main__":
    main()
