#!/usr/bin/env python3
"""Makes the pictures in assets/textures/: everything in them is computed here. Needs numpy.

  make_textures.py FOLDER
"""
import os
import struct
import sys
import zlib

import numpy as np


def write_png(path, rgb):
    """8-bit PNG of values in [0, 1], sRGB-encoded already; shape (h, w, 3 or 4)."""
    data = (np.clip(rgb, 0, 1) * 255 + 0.5).astype(np.uint8)
    h, w, channels = data.shape
    rows = np.concatenate([np.full((h, 1), 0, np.uint8), data.reshape(h, -1)], axis=1)
    # Filter 1 (difference to the left neighbour) packs smooth pictures well.
    filtered = data.astype(np.int16)
    filtered[:, 1:] -= data[:, :-1]
    rows = np.concatenate([np.full((h, 1), 1, np.uint8), filtered.astype(np.uint8).reshape(h, -1)], axis=1)

    def chunk(tag, body):
        return struct.pack(">I", len(body)) + tag + body + struct.pack(">I", zlib.crc32(tag + body))

    with open(path, "wb") as f:
        f.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", w, h, 8, 6 if channels == 4 else 2, 0, 0, 0)) +
                chunk(b"IDAT", zlib.compress(rows.tobytes(), 9)) + chunk(b"IEND", b""))


def write_hdr(path, rgb):
    """Radiance RGBE with run-length coding; linear values."""
    h, w, _ = rgb.shape
    peak = rgb.max(-1)
    mantissa, exponent = np.frexp(np.maximum(peak, 1e-32))
    scale = np.where(peak < 1e-32, 0, mantissa * 256 / np.maximum(peak, 1e-32))
    rgbe = np.concatenate([np.clip(rgb * scale[..., None], 0, 255), (exponent + 128)[..., None]], -1).astype(np.uint8)
    with open(path, "wb") as f:
        f.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (h, w))
        for row in rgbe:
            f.write(bytes([2, 2, w >> 8, w & 255]))
            for c in range(4):
                f.write(run_lengths(row[:, c].tobytes()))


def run_lengths(line):
    out, i = bytearray(), 0
    while i < len(line):
        run = 1
        while run < 127 and i + run < len(line) and line[i + run] == line[i]:
            run += 1
        if run > 3:
            out += bytes([128 + run, line[i]])
            i += run
            continue
        start = i
        while i < len(line) and i - start < 128 and not (i + 3 < len(line) and line[i] == line[i + 1] == line[i + 2] == line[i + 3]):
            i += 1
        out += bytes([i - start]) + line[start:i]
    return bytes(out)


def srgb(linear):
    x = np.clip(linear, 0, 1)
    return np.where(x <= 0.0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - 0.055)


def hash3(i, j, k, seed):
    n = (i * 374761393 + j * 668265263 + k * 2147483647 + seed * 974634777) & 0xffffffff
    n = ((n ^ (n >> 13)) * 1274126177) & 0xffffffff
    n = ((n ^ (n >> 16)) * 2246822519) & 0xffffffff
    return (n ^ (n >> 15)) / 4294967296.0


def value_noise(p, seed):
    """Smooth noise in [0, 1] at points p of shape (..., 3)."""
    cell = np.floor(p).astype(np.int64)
    t = p - cell
    t = t * t * t * (t * (t * 6 - 15) + 10)
    total = 0
    for corner in range(8):
        o = np.array([corner & 1, corner >> 1 & 1, corner >> 2])
        weight = np.prod(np.where(o, t, 1 - t), axis=-1)
        c = cell + o
        total = total + weight * hash3(c[..., 0], c[..., 1], c[..., 2], seed)
    return total


def fractal(p, octaves, seed):
    total, amplitude, norm = 0, 1.0, 0
    for octave in range(octaves):
        total = total + amplitude * value_noise(p * 2.0 ** octave, seed + octave)
        norm += amplitude
        amplitude *= 0.5
    return total / norm


def directions(width, height, environment=False):
    """Unit vectors of the pixels of an equirectangular picture; environment: as Teapath's backgrounds."""
    u, v = np.meshgrid((np.arange(width) + 0.5) / width, (np.arange(height) + 0.5) / height)
    phi, theta = 2 * np.pi * u, np.pi * v
    if environment:
        return np.stack([np.sin(phi) * np.sin(theta), np.cos(theta), -np.cos(phi) * np.sin(theta)], -1)
    return np.stack([-np.cos(phi) * np.sin(theta), np.cos(theta), np.sin(phi) * np.sin(theta)], -1)


def smooth(low, high, x):
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def mix(a, b, t):
    return np.asarray(a) * (1 - t[..., None]) + np.asarray(b) * t[..., None]


def globe(width=1024, height=512):
    d = directions(width, height)
    warp = np.stack([fractal(d * 2 + s, 4, 90 + s) for s in (0, 7, 13)], -1) - 0.5
    land = fractal(d * 1.7 + warp * 0.9, 7, 3)
    relief = fractal(d * 7 + warp, 5, 40)
    shore = smooth(0.505, 0.525, land)
    latitude = np.abs(d[..., 1])
    sea = mix([0.01, 0.05, 0.16], [0.03, 0.22, 0.34], smooth(0.40, 0.51, land))
    dry = smooth(0.35, 0.6, fractal(d * 3, 4, 70) + 0.35 * np.exp(-((latitude - 0.38) / 0.16) ** 2) - 0.1)
    ground = mix([0.05, 0.16, 0.04], [0.42, 0.30, 0.14], dry)
    ground = mix([0.10, 0.20, 0.07], [1, 1, 1], np.zeros_like(dry)) * 0.25 + ground * 0.75
    ground = ground * (0.65 + 0.7 * relief[..., None])
    color = mix([0, 0, 0], [1, 1, 1], np.zeros_like(shore)) + sea * (1 - shore[..., None]) + ground * shore[..., None]
    ice = smooth(0.80, 0.88, latitude + 0.12 * (relief - 0.5) + 0.08 * (land - 0.5))
    color = color * (1 - ice[..., None]) + np.array([0.82, 0.87, 0.92]) * ice[..., None]
    clouds = smooth(0.52, 0.72, fractal(d * np.array([2.2, 3.6, 2.2]) + warp * 2.2 + 11, 6, 120))
    color = color * (1 - 0.85 * clouds[..., None]) + 0.85 * 0.92 * clouds[..., None]
    return srgb(color)


def coverage(distance, width):
    """Antialiased inside of a signed distance in units where a pixel is `width`."""
    return np.clip(0.5 - distance / width, 0, 1)


def logo(size=512):
    """A teapot in profile and a ray of light that leaves its spout."""
    x, y = np.meshgrid((np.arange(size) + 0.5) / size * 2 - 1, 1 - (np.arange(size) + 0.5) / size * 2)
    pixel = 2 / size

    def ellipse(cx, cy, rx, ry):
        return (np.hypot((x - cx) / rx, (y - cy) / ry) - 1) * min(rx, ry)

    def segment(x0, y0, x1, y1, r0, r1):
        t = np.clip(((x - x0) * (x1 - x0) + (y - y0) * (y1 - y0)) / ((x1 - x0) ** 2 + (y1 - y0) ** 2), 0, 1)
        return np.hypot(x - x0 - t * (x1 - x0), y - y0 - t * (y1 - y0)) - (r0 + t * (r1 - r0))

    body = np.maximum(ellipse(-0.08, -0.20, 0.46, 0.40), -(y + 0.52))
    lid = np.maximum(ellipse(-0.08, 0.08, 0.30, 0.16), -(y - 0.10))
    knob = ellipse(-0.08, 0.30, 0.07, 0.07)
    spout = np.minimum(segment(0.28, -0.28, 0.52, -0.02, 0.13, 0.075), segment(0.52, -0.02, 0.66, 0.10, 0.075, 0.05))
    handle = np.abs(ellipse(-0.52, -0.12, 0.23, 0.24)) - 0.055
    foot = np.maximum(ellipse(-0.08, -0.55, 0.30, 0.06), 0 * x - 1)
    pot = np.minimum.reduce([body, lid, knob, spout, np.maximum(handle, x + 0.30), foot])
    ray = np.minimum.reduce([segment(0.68, 0.13, 0.90, 0.42, 0.022, 0.022), segment(0.90, 0.42, 0.55, 0.80, 0.022, 0.022),
                             segment(0.55, 0.80, 0.25, 0.62, 0.022, 0.012)])
    amber, ink = np.array([0.91, 0.64, 0.24]), np.array([0.13, 0.14, 0.16])
    pot_c, ray_c = coverage(pot, 1.5 * pixel), coverage(ray, 1.5 * pixel)
    shine = coverage(np.maximum(ellipse(-0.20, -0.12, 0.16, 0.20), -ellipse(-0.15, -0.16, 0.17, 0.22)), 3 * pixel) * 0.5
    color = ink * (1 - shine[..., None]) + np.array([0.6, 0.62, 0.66]) * shine[..., None]
    color = color * (1 - ray_c[..., None]) + amber * ray_c[..., None]
    alpha = np.maximum(pot_c, ray_c)
    return np.concatenate([color, alpha[..., None]], -1)


def logo_tile(size=512):
    """The logo on paper, without transparency."""
    rgba = logo(size)
    paper = np.array([0.93, 0.90, 0.83])
    return rgba[..., :3] * rgba[..., 3:] + paper * (1 - rgba[..., 3:])


def milky_way(width=1024, height=512):
    d = directions(width, height, True)
    axis = np.array([0.35, 0.85, 0.4])
    axis /= np.linalg.norm(axis)
    across = d @ axis
    warp = fractal(d * 2.5, 5, 10) - 0.5
    band = np.exp(-((across + 0.16 * warp) / 0.17) ** 2)
    core = np.exp(-(((d - np.array([0.75, -0.5, 0.42])) ** 2).sum(-1)) / 0.5)
    dust = smooth(0.46, 0.66, fractal(d * 5 + warp[..., None], 6, 30)) * np.exp(-((across + 0.1 * warp) / 0.09) ** 2)
    glow = band * (0.10 + 0.5 * core) * (0.5 + fractal(d * 9, 5, 60)) * (1 - 0.85 * dust)
    color = mix([0.55, 0.62, 0.95], [1.0, 0.82, 0.62], np.clip(core * 1.6, 0, 1)) * (glow * 0.55)[..., None] + np.array([0.004, 0.005, 0.010])
    rng = np.random.default_rng(7)
    count = 9000
    v = rng.normal(size=(count, 3))
    v /= np.linalg.norm(v, axis=1, keepdims=True)
    keep = rng.random(count) < 0.35 + 0.65 * np.exp(-((v @ axis) / 0.25) ** 2)
    v = v[keep]
    px = ((np.arctan2(v[:, 0], -v[:, 2]) / (2 * np.pi)) % 1 * width).astype(int) % width
    py = np.clip((np.arccos(np.clip(v[:, 1], -1, 1)) / np.pi * height).astype(int), 0, height - 1)
    bright = 0.06 * (1 - rng.random(len(v))) ** -0.75
    tint = mix([0.7, 0.8, 1.0], [1.0, 0.85, 0.65], rng.random(len(v)))
    np.add.at(color, (py, px), tint * np.minimum(bright, 2.5)[:, None])
    for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1)):
        big = bright > 0.5
        np.add.at(color, (np.clip(py[big] + dy, 0, height - 1), (px[big] + dx) % width), tint[big] * np.minimum(bright[big] * 0.25, 0.6)[:, None])
    return srgb(color)


def sunset(width=1024, height=512):
    d = directions(width, height, True)
    y = d[..., 1]
    sun = np.array([0.55, 0.11, -0.82])
    sun /= np.linalg.norm(sun)
    near = np.clip(d @ sun, -1, 1)
    up = np.clip(y, 0, 1)
    sky = mix([1.35, 0.55, 0.20], [0.10, 0.20, 0.55], smooth(0.0, 0.55, up ** 0.6))
    sky = sky + np.array([1.6, 0.75, 0.28]) * (np.exp((near - 1) * 9) * np.exp(-up * 2.2))[..., None]
    sky = sky + np.array([2.5, 1.5, 0.7]) * np.exp((near - 1) * 120)[..., None]
    plane = d / np.maximum(y, 0.04)[..., None]
    shape = fractal(np.stack([plane[..., 0] * 0.55, plane[..., 2] * 1.1, 0 * y], -1) + 3, 6, 55)
    cloud = smooth(0.52, 0.74, shape) * smooth(0.02, 0.12, y)
    lit = np.array([1.9, 0.85, 0.42]) * (0.35 + 1.1 * np.exp((near - 1) * 3))[..., None] + np.array([0.12, 0.12, 0.2])
    sky = sky * (1 - 0.75 * cloud[..., None]) + lit * (0.75 * cloud * (1.15 - 0.6 * smooth(0.62, 0.9, shape)))[..., None]
    ground = np.array([0.10, 0.075, 0.06]) * (0.6 + 0.8 * np.exp((near - 1) * 3))[..., None]
    below = smooth(0.01, -0.01, y)
    color = sky * (1 - below[..., None]) + ground * below[..., None]
    disc = smooth(np.cos(np.radians(3.2)), np.cos(np.radians(2.4)), near)
    return color * (1 - disc[..., None]) + np.array([42.0, 26.0, 12.0]) * disc[..., None]


def wood(size=512):
    """Planks; repeats in both directions."""
    u, v = np.meshgrid((np.arange(size) + 0.5) / size, (np.arange(size) + 0.5) / size)
    plank = np.floor(v * 4)
    shade = hash3(plank.astype(np.int64), plank.astype(np.int64) * 0 + 5, plank.astype(np.int64) * 0, 9)
    angle = 2 * np.pi * u
    ring = np.stack([np.cos(angle) * 0.35 + plank * 3.7, np.sin(angle) * 0.35, v * 10 % 2.5], -1)
    grain = fractal(ring * np.array([1.2, 1.2, 5]), 5, 21)
    lines = 0.5 + 0.5 * np.sin((grain * 9 + (v * 4 % 1) * 3) * 2 * np.pi)
    fine = fractal(np.stack([np.cos(angle) * 1.5 + plank, np.sin(angle) * 1.5, v * 160], -1), 3, 33)
    tone = np.clip(0.25 + 0.35 * lines * grain * 1.6 + 0.25 * fine + 0.25 * (shade - 0.5), 0, 1)
    color = mix([0.16, 0.075, 0.03], [0.52, 0.31, 0.15], tone)
    gap = np.minimum(v * 4 % 1, 1 - v * 4 % 1) < 0.012
    return srgb(color * np.where(gap, 0.25, 1)[..., None])


def corners():
    """Four texels whose bilinear blend is the first picture of Ray Tracing in One Weekend: red grows to
    the right, green upwards, blue stays 0.25. Linear values, not sRGB."""
    return np.array([[[0, 1, 0.25], [1, 1, 0.25]], [[0, 0, 0.25], [1, 0, 0.25]]])


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = sys.argv[1]
    os.makedirs(folder, exist_ok=True)
    write_png(os.path.join(folder, "corners.png"), corners())
    write_png(os.path.join(folder, "globe.png"), globe())
    write_png(os.path.join(folder, "logo.png"), logo())
    write_png(os.path.join(folder, "logo_tile.png"), logo_tile())
    write_png(os.path.join(folder, "milky_way.png"), milky_way())
    write_png(os.path.join(folder, "wood.png"), wood())
    write_hdr(os.path.join(folder, "sunset.hdr"), sunset())


if __name__ == "__main__":
    main()
