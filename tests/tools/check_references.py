#!/usr/bin/env python3
"""Renders the reference scenes with two seeds and compares them with the images of another renderer.

  check_references.py --program build/release/teapath [--samples N] [--backend host|cuda] [--only 06] [--keep DIR]

Prints a table (scene, samples, relMSE, mean ratio, tile z) and, last, how many passed. A failing
scene leaves reference, render and difference as a picture in DIR. Needs numpy and OpenEXR.
"""
import argparse
import glob
import os
import re
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
REFERENCES = os.path.join(os.path.dirname(HERE), "references")

# Caustics, and light close to a sphere, have heavy tails: a short render's own error estimate is
# poor there. These scenes take this many times the samples of the others.
MORE_SAMPLES = {"07_cornell_glass": 16, "15_sphere_light": 4, "04_glass": 2, "11_lens": 2}


def run(command):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def render(args, scene, output, samples, seed):
    command = [args.program, "render", scene, "-o", output, "--spp", str(samples), "--seed", str(seed), "--backend", args.backend, "--quiet"]
    result = run(command)
    if result.returncode != 0:
        sys.exit("%s\n%s" % (" ".join(command), result.stdout))


def check(args, reference, folder):
    """Renders one scene twice and compares; returns (row of the table, passed)."""
    name = os.path.splitext(os.path.basename(reference))[0]
    samples = args.samples * MORE_SAMPLES.get(name, 1)
    scene = os.path.join(folder, name + ".json")
    converted = run([sys.executable, os.path.join(HERE, "convert_reference.py"), reference, scene])
    if converted.returncode != 0:
        sys.exit(converted.stdout)
    images = [os.path.join(folder, "%s_%d.exr" % (name, seed)) for seed in (1, 2)]
    for seed, image in zip((1, 2), images):
        render(args, scene, image, samples, seed)
    result = run([sys.executable, os.path.join(HERE, "compare_images.py"), os.path.join(REFERENCES, "images", name + ".exr"), images[0], "--second", images[1]])

    def figure(measure):
        found = re.search(r"(PASS|FAIL) %s\s+(.*)" % measure, result.stdout)
        return found.group(2).split(" (limit")[0] if found else "?"

    row = "%-20s %7d  %-10s  %-24s  %-10s  %s" % (name, 2 * samples, figure("relMSE"), figure("mean ratio"), figure("tile z").replace("rms ", ""), figure("tile max").split(" at")[0])
    failed = re.findall(r"FAIL (\S+(?: \S+)?)\s", result.stdout)
    if result.returncode != 0:
        row += "  FAIL " + ", ".join(failed) + "\n" + result.stdout
    return row, result.returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--samples", type=int, default=64, help="per pixel and seed (times more for caustics)")
    parser.add_argument("--backend", default="auto")
    parser.add_argument("--only", default="", help="scenes whose name begins so")
    parser.add_argument("--keep", default=None, help="folder for renders and difference pictures")
    args = parser.parse_args()
    passed = total = 0
    print("%-20s %7s  %-10s  %-24s  %-10s  %s" % ("scene", "samples", "relMSE", "mean ratio R G B", "tile z rms", "max"))
    with tempfile.TemporaryDirectory() as temporary:
        folder = args.keep or temporary
        os.makedirs(folder, exist_ok=True)
        for reference in sorted(glob.glob(os.path.join(REFERENCES, "scenes", args.only + "*.json"))):
            row, ok = check(args, reference, folder)
            print(row, flush=True)
            passed += ok
            total += 1
    print("references: %d passed, %d failed" % (passed, total - passed))
    sys.exit(0 if passed == total else 1)


if __name__ == "__main__":
    main()
