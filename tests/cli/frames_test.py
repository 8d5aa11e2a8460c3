#!/usr/bin/env python3
"""Frames of an animation: files with numbers, times, Ctrl-C, errors, and what info says of it."""
import base64
import json
import signal
import struct
import subprocess
import time
import unittest

from support import BACKEND, INTERRUPTED, OUTPUT, USAGE, CommandTest, main, run, start

signal.signal(signal.SIGINT, signal.default_int_handler)


def moving_model():
    """A large triangle that leaves the picture to the right within a second."""
    pieces = [struct.pack("<9f", -1, -1, 0, 1, -1, 0, 0, 1, 0), struct.pack("<2f", 0, 1),
              struct.pack("<6f", 0, 0, 0, 30, 0, 0)]
    views, data = [], b""
    for piece in pieces:
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(piece)})
        data += piece
    return {
        "asset": {"version": "2.0"},
        "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64,"
                     + base64.b64encode(data).decode()}],
        "bufferViews": views,
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR"},
            {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "nodes": [{"name": "triangle", "mesh": 0}],
        "animations": [{"name": "leave", "samplers": [{"input": 1, "output": 2}],
                        "channels": [{"sampler": 0,
                                      "target": {"node": 0, "path": "translation"}}]}],
    }


SCENE = {
    "teapath": 1,
    "camera": {"look_from": [0, 0, 4], "look_at": [0, 0, 0]},
    "render": {"width": 16, "height": 12, "samples": 2, "integrator": "flat"},
    "background": {"type": "constant", "color": 0},
    "models": [{"file": "leave.gltf"}],
}


class Frames(CommandTest):
    def setUp(self):
        super().setUp()
        for name, content in (("leave.gltf", moving_model()), ("scene.json", SCENE)):
            with open(f"{self.folder}/{name}", "w", encoding="utf-8") as file:
                json.dump(content, file)

    def render(self, *arguments):
        return run("render", "scene.json", "--backend", BACKEND, *arguments, cwd=self.folder)

    def test_each_frame_is_the_picture_at_its_time(self):
        done = self.render("-o", "f_###.png", "-o", "f_###.pfm", "--frames", "0-3", "--fps", "4")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("wrote 4 of 4 frames", done.stderr)
        self.assertEqual([f for f in self.files() if f.startswith("f_")],
                         sorted(f"f_{n:03}.{kind}" for n in range(4) for kind in ("png", "pfm")))
        for n in range(4):
            self.render("-o", "one.pfm", "--set", f"render.time={n / 4}")
            self.assertEqual(self.read("one.pfm"), self.read(f"f_{n:03}.pfm"))
        self.assertNotEqual(self.read("f_000.pfm"), self.read("f_003.pfm"))

    def test_one_frame_and_no_padding(self):
        self.assertEqual(self.render("-o", "#.pfm", "--frames", "12").returncode, 0)
        self.assertIn("12.pfm", self.files())

    def test_an_animation_that_does_not_play(self):
        self.render("-o", "still_#.pfm", "--frames", "0-9", "--fps", "9",
                    "--set", "models[0].animation=none")
        self.assertEqual(self.read("still_0.pfm"), self.read("still_9.pfm"))

    def test_refusals(self):
        for arguments, code, words in (
                (("-o", "a.png", "--frames", "0-3"), USAGE, "####"),
                (("-o", "a#.png", "--frames", "3-0"), USAGE, "ends before it begins"),
                (("-o", "a#.png", "--frames", "x"), USAGE, "no range of frames"),
                (("-o", "a#.png", "--frames", "-1-3"), USAGE, "--frames"),
                (("-o", "a#.png", "--fps", "24"), USAGE, "--frames 0-47"),
                (("-o", "a#.png", "--frames", "0-3", "--fps", "0"), USAGE, "--fps"),
                (("-o", "no/a#.png", "--frames", "0-3"), OUTPUT, "no/a0.png")):
            with self.subTest(arguments):
                done = self.render(*arguments)
                self.assertEqual(done.returncode, code, done.stderr)
                self.assertIn(words, done.stderr)

    def test_an_interrupt_keeps_what_is_whole(self):
        process = start("render", "scene.json", "--backend", BACKEND, "-o", "f_####.png",
                        "--frames", "0-99999", "--set", "render.samples=64", cwd=self.folder,
                        stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.kill)
        for _ in range(600):
            if "f_0002.png" in self.files():
                break
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, INTERRUPTED, errors)
        self.assertIn("interrupted: the frames so far are there", errors)
        frames = [f for f in self.files() if f.startswith("f_")]
        self.assertIn(f"wrote {len(frames)} of 100000 frames", errors)
        self.assertEqual(frames, [f"f_{n:04}.png" for n in range(len(frames))])

    def test_info(self):
        text = run("info", "leave.gltf", cwd=self.folder).stdout
        self.assertRegex(text, r"Animations +leave\.gltf: leave 1\.00 s")
        scene = json.loads(run("info", "leave.gltf", "--json", cwd=self.folder).stdout)["scene"]
        self.assertEqual(scene["animations"],
                         [{"model": "leave.gltf", "name": "leave", "seconds": 1.0}])


if __name__ == "__main__":
    main()
