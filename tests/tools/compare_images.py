#!/usr/bin/env python3
"""Compares a render with a reference: two EXR files of linear RGB radiance of the same size.

  compare_images.py images/06_cornell.exr mine.exr                                 relMSE and mean ratio only
  compare_images.py images/06_cornell.exr mine_seed1.exr --second mine_seed2.exr   and the z-tests
  compare_images.py images/06_cornell.exr mine.exr --error mine.se.exr             the same with an own error image

The reference's standard error is read from NAME.se.exr beside NAME.exr. The noise of the render under test comes
from a second render with another seed and the same samples per pixel (then both are averaged and tested together),
or from an image of the standard error of its mean (out of 32 passes or more). Needs the packages numpy and OpenEXR.

Measures, over pixels and channels, a = render, r = reference, v = variance of a + variance of r + rounding of the files:
  relMSE      mean of (a - r)^2 / (r^2 + 0.01 mean(r)^2); and the part of it that the noise of both explains
  mean ratio  sum(a) / sum(r) per channel, with its own z
  pixel z     (a - r) / sqrt(v): rms, share beyond 4
  tile z      sum(a - r) / sqrt(sum v) over tiles of 16 x 16 pixels: rms, largest (finds small bias in one place)
Prints one line per measure, ends with exit code 0 if none failed, and writes a difference PNG.
"""
import argparse
import os
import struct
import sys
import zlib

import numpy as np
import OpenEXR


def read_exr(path):
    """The pixels as doubles, and the variance that rounding to the file's number type added."""
    with OpenEXR.File(path) as f:
        channels = f.channels()
        packed = next((k for k in ("RGB", "RGBA") if k in channels), None)
        pixels = channels[packed].pixels[..., :3] if packed else np.stack([channels[c].pixels for c in "RGB"], axis=-1)
        step = np.where(np.isfinite(pixels), np.spacing(np.abs(pixels)), 0).astype(np.float64)
        return np.asarray(pixels, dtype=np.float64), step ** 2 / 12


def write_png(path, rgb8):
    h, w, _ = rgb8.shape
    rows = np.concatenate([np.zeros((h, 1), np.uint8), rgb8.reshape(h, w * 3)], axis=1).tobytes()
    chunk = lambda tag, data: struct.pack(">I", len(data)) + tag + data + struct.pack(">I", zlib.crc32(tag + data))
    with open(path, "wb") as f:
        f.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", w, h, 8, 2, 0, 0, 0)) +
                chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def encode(x):
    """Linear to 8-bit sRGB after x / (1 + x)."""
    x = np.clip(x, 0, None)
    x = x / (1 + x)
    return (np.where(x <= 0.0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - 0.055) * 255 + 0.5).astype(np.uint8)


def signed(x):
    """Red where the render is brighter than the reference, blue where it is darker, grey where equal."""
    x = np.clip(x, -1, 1)
    return (np.stack([0.5 + 0.5 * x, 0.5 - 0.5 * np.abs(x), 0.5 - 0.5 * x], -1) * 255 + 0.5).astype(np.uint8)


def tiles(x, n=16):
    h, w = x.shape[:2]
    x = np.pad(x, ((0, -h % n), (0, -w % n), (0, 0)))
    return x.reshape(x.shape[0] // n, n, x.shape[1] // n, n, 3).sum((1, 3))


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("reference")
    p.add_argument("render")
    p.add_argument("--second", help="the same render with another seed")
    p.add_argument("--error", help="EXR with the standard error of the render's mean")
    p.add_argument("--reference-error", help="instead of NAME.se.exr beside the reference")
    p.add_argument("--png", help="difference picture (default: beside the render, NAME.diff.png); '-' for none")
    p.add_argument("--max-relmse", type=float, default=None, help="limit on relMSE; default 1e-3, or with a noise estimate 1.3 x noise + 1e-5")
    p.add_argument("--max-mean", type=float, default=0.002, help="limit on |mean ratio - 1| on top of 4 standard errors")
    p.add_argument("--max-rms", type=float, default=1.25, help="limit on the rms of pixel z and of tile z")
    p.add_argument("--max-beyond", type=float, default=0.01, help="limit on the share of pixels with |z| > 4")
    p.add_argument("--max-tile", type=float, default=6.0, help="limit on the largest |tile z|")
    a = p.parse_args()

    (r, rounding_r), (x, rounding_x) = read_exr(a.reference), read_exr(a.render)
    if r.shape != x.shape:
        sys.exit("FAIL size: reference %s, render %s" % (r.shape[:2], x.shape[:2]))
    failed = []

    def verdict(name, text, ok):
        print("%s %-10s %s" % ("PASS" if ok else "FAIL", name, text))
        failed.extend([] if ok else [name])

    verdict("finite", "%d values not finite" % np.sum(~np.isfinite(x)), bool(np.all(np.isfinite(x))))
    x = np.nan_to_num(x, nan=0, posinf=0, neginf=0)

    # variance of both means
    vx = None
    if a.second:
        y = read_exr(a.second)[0]
        vx = (x - y) ** 2 / 4
        # One pair gives one degree of freedom: for the test of single pixels, smooth it over 7 x 7.
        k = 7
        d = np.pad(vx, ((k // 2,) * 2, (k // 2,) * 2, (0, 0)), mode="edge")
        vx_pixel = np.lib.stride_tricks.sliding_window_view(d, (k, k), axis=(0, 1)).mean((-2, -1))
        x = (x + y) / 2
    elif a.error:
        vx = vx_pixel = read_exr(a.error)[0] ** 2
    error_path = a.reference_error or os.path.splitext(a.reference)[0] + ".se.exr"
    vr = read_exr(error_path)[0] ** 2 if os.path.exists(error_path) else np.zeros_like(r)
    rounding = rounding_r + rounding_x

    weight = 1 / (r ** 2 + 0.01 * np.mean(r) ** 2)
    diff = x - r
    relmse = np.mean(diff ** 2 * weight)
    v = vr + (0 if vx is None else vx)
    noise = np.mean((v + rounding) * weight)
    limit = a.max_relmse or (1e-3 if vx is None else 1.3 * noise + 1e-5)
    verdict("relMSE", "%.3e (limit %.3e; noise %s%.3e)" % (relmse, limit, "of the reference " if vx is None else "", noise), relmse <= limit)

    ratio = x.sum((0, 1)) / np.maximum(r.sum((0, 1)), 1e-30)
    slack = 4 * np.sqrt(v.sum((0, 1))) / np.maximum(r.sum((0, 1)), 1e-30) + a.max_mean
    verdict("mean ratio", "%.5f %.5f %.5f (limit 1 +- %.5f)" % (*ratio, slack.max()), bool(np.all(np.abs(ratio - 1) <= slack)))

    if vx is not None:
        floor = (1e-6 * np.mean(r)) ** 2
        z = diff / np.sqrt(vr + vx_pixel + rounding + floor)
        verdict("pixel z", "rms %.3f (limit %.2f)" % (np.sqrt(np.mean(z ** 2)), a.max_rms), np.sqrt(np.mean(z ** 2)) <= a.max_rms)
        beyond = np.mean(np.abs(z) > 4)
        verdict("outliers", "%.4f %% beyond 4 sigma (limit %.2f %%)" % (100 * beyond, 100 * a.max_beyond), beyond <= a.max_beyond)
        # Rounding errors of a flat tile are all alike: they add up as they are, not as noise does.
        noise_sum = np.maximum(tiles(v), tiles(vr + vx_pixel))  # the smoothed one keeps small border tiles honest
        t = tiles(diff) / np.sqrt(noise_sum + tiles(np.sqrt(rounding + floor)) ** 2)
        rms, worst = np.sqrt(np.mean(t ** 2)), np.unravel_index(np.argmax(np.abs(t)), t.shape)
        verdict("tile z", "rms %.3f (limit %.2f)" % (rms, a.max_rms), rms <= a.max_rms)
        verdict("tile max", "%.2f at tile x %d y %d channel %s (limit %.1f)" % (t[worst], worst[1], worst[0], "RGB"[worst[2]], a.max_tile),
                abs(t[worst]) <= a.max_tile)

    if a.png != "-":
        path = a.png or os.path.splitext(a.render)[0] + ".diff.png"
        relative = diff.mean(-1) / np.sqrt((r ** 2).mean(-1) + 0.01 * np.mean(r) ** 2)
        write_png(path, np.concatenate([encode(r), encode(x), signed(relative / 0.1)], axis=1))
        print("     picture    %s: reference, render, difference (full colour at 10 %%)" % path)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
