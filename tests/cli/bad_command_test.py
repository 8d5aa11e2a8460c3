#!/usr/bin/env python3
"""Command lines that are wrong: exit code 2 and a sentence with the option and the remedy, before
anything is rendered or written."""
import unittest

from support import BACKEND, DEVICE, INPUT, USAGE, CommandTest, main

# Options behind `render scene.json -o a.png`, and what the message must have.
BAD_OPTIONS = [
    ("--size -5x5", "--size: '-5x5' is not a size", "1920x1080"),
    ("--size 0x5", "--size: 0 is out of range", "1 to 65536"),
    ("--size 5x0", "--size: 0 is out of range"),
    ("--size 100000x100000", "--size: 100000 is out of range", "1 to 65536"),
    ("--size 65536x65536", "--size: 65536 x 65536 pixels are too many", "16384 x 16384"),
    ("--size 99999999999x1", "--size: 99999999999 is out of range"),
    ("--size 640", "--size: '640' is not a size"),
    ("--size large", "--size: 'large' is not a size"),
    ("--spp 0", "--spp: 0 is out of range", "from 1 to 1073741824"),
    ("--spp -3", "--spp: -3 is out of range"),
    ("--spp 1e3", "--spp: '1e3' is not a whole number"),
    ("--spp 2000000000", "--spp: 2000000000 is out of range"),
    ("--depth 0", "--depth: 0 is out of range", "from 1 to 4096"),
    ("--depth 4097", "--depth: 4097 is out of range"),
    ("--seed -1", "--seed: '-1' is not a seed", "or random"),
    ("--seed 18446744073709551616", "--seed:", "is not a seed"),
    ("--camera fronnt", "--camera: the scene has no camera 'fronnt'", "did you mean 'front'?",
     "'above'"),
    ("--backend gpu", "--backend: there is no backend 'gpu'", "auto, cuda, host"),
    ("--device -1", "--device: -1 is out of range"),
    ("--device first", "--device: 'first' is not a whole number"),
    ("--backend host --device 0", "--device: the host backend has no device numbers"),
    ("--threads 0", "--threads: 0 is out of range", "from 1 to 1024"),
    ("--threads many", "--threads: 'many' is not a whole number"),
    ("--time 0", "--time: '0' is not a time", "seconds above 0"),
    ("--time -4", "--time: '-4' is not a time"),
    ("--time nan", "--time: 'nan' is not a time"),
    ("--time inf", "--time: 'inf' is not a time"),
    ("--set camera.vertical_fov=0", "--set camera.vertical_fov:", "0 degrees is no field of view",
     "above 0 and below 180"),
    ("--set camera.vertical_fov=180", "--set camera.vertical_fov:", "180 degrees"),
    ("--set camera.vertical_fov=-20", "--set camera.vertical_fov:", "above 0 and below 180"),
    ("--set camera.vertical_fov=NaN", "--set camera.vertical_fov:", "expected a number"),
    ("--set camera.vertical_fov=1e400", "--set camera.vertical_fov:", "1e400 is too large"),
    ("--set camera.look_at=[0,1,4]", "--set camera.look_at:", "looks at where it is"),
    ("--set camera.up=[0,0.5,4]", "--set camera.up:", "parallel"),
    ("--set render.width=-32", "--set render.width: -32 is out of range", "from 1 to 65536"),
    ("--set render.height=0", "--set render.height: 0 is out of range"),
    ("--set render.wdth=10", "--set render.wdth:", 'unknown key "wdth"', 'did you mean "width"?'),
    ("--set render.sampler=soble", "--set render.sampler:", 'unknown value "soble"', "sobol"),
    ("--set objects[7].visible=false", "--set objects[7].visible:", 'no element "7"',
     "3 elements"),
    ("--set objects[0].material=gray", "--set objects[0].material:", 'did you mean "grey"?'),
    ("--set render", "--set: 'render' has no value", "display.exposure=1.5"),
    ("--set =3", "--set: '=3' has no value"),
    ("--spp", "--spp: its value is missing", "render --help"),
    ("--sp 3", "has no option --sp", "did you mean '--spp'?"),
    ("--sampels=3", "has no option --sampels", "render --help"),
    ("-x", "has no option -x"),
    ("other.json", "does not know what to do with 'other.json'"),
    ("b.png", "does not know what to do with 'b.png'", "-o b.png"),
]

# Whole command lines.
BAD_COMMANDS = [
    ("rendr scene.json", "there is no command 'rendr'", "did you mean 'render'?"),
    ("paint", "there is no command 'paint'", "render, info, random"),
    ("--frobnicate", "has no option --frobnicate", "teapath --help"),
    ("scene.json -o a.png", "to render it: teapath render scene.json -o image.png"),
    ("render", "no scene is named", "teapath render scene.json -o image.png"),
    ("render -o a.png", "no scene is named"),
    ("info scene.json other.json", "teapath info does not know what to do with 'other.json'"),
    ("info --jsn", "teapath info has no option --jsn", "did you mean '--json'?"),
    ("random", "nothing is asked for", "--bytes"),
]


class BadCommandLines(CommandTest):
    def test_each_bad_option_of_render(self):
        self.scene()
        for words, *fragments in BAD_OPTIONS:
            with self.subTest(words):
                options = words.split()
                if "--backend" not in options and "--device" not in options:
                    options += ["--backend", BACKEND] if options[-1] != "--spp" else []
                result = self.teapath("render", "scene.json", "-o", "a.png", *options)
                self.assert_error(result, USAGE, *fragments)
                self.assertEqual(self.files(), ["scene.json"])

    def test_each_bad_command(self):
        self.scene()
        for words, *fragments in BAD_COMMANDS:
            with self.subTest(words):
                self.assert_error(self.teapath(*words.split()), USAGE, *fragments)
                self.assertEqual(self.files(), ["scene.json"])

    def test_an_empty_word(self):
        self.scene()
        self.assert_error(self.teapath("render", ""), USAGE)
        self.assert_error(self.teapath("render", "", "-o", "a.png"), INPUT)
        self.assert_error(self.teapath("render", "scene.json", "-o", "a.png", "--size", ""), USAGE,
                          "--size: '' is not a size")

    def test_bytes_that_are_no_text(self):
        self.scene()
        result = self.teapath("render", "scene.json", "-o", "a.png", "--camera",
                              b"\xff\xfe\x80".decode(errors="surrogateescape"))
        self.assert_error(result, USAGE, "--camera")

    def test_a_very_long_word(self):
        self.scene()
        for option in ("--size", "--spp", "--camera", "--set"):
            self.assert_error(self.teapath("render", "scene.json", "-o", "a.png", option,
                                           "9" * 100000), USAGE, option)


class Help(CommandTest):
    def test_every_command_has_help(self):
        for command, words in (((), ("render", "info", "random", "Exit codes", "130")),
                               (("render",), ("--spp", "--time", "--size", "--depth", "--seed",
                                              "--camera", "--backend", "--device", "--threads",
                                              "--set", "--output", "Ctrl-C", "exr")),
                               (("info",), ("SCENE", "--json")),
                               (("random",), ("--key", "--block", "--rounds", "--seed",
                                              "--device", "--bytes"))):
            for option in ("--help", "-h"):
                result = self.teapath(*command, option)
                self.assert_done(result)
                self.assertEqual(result.stderr, "")
                for word in ("Usage: teapath", *command, *words):
                    self.assertIn(word, result.stdout)
                self.assertLessEqual(max(map(len, result.stdout.splitlines())), 100)

    def test_version(self):
        result = self.teapath("--version")
        self.assert_done(result)
        self.assertRegex(result.stdout, r"^Teapath \d+\.\d+\.\d+")


class NoDevice(CommandTest):
    """Where there is no GPU, or it is hidden: exit code 4 for who insists, the host for who does
    not."""

    HIDDEN = {"CUDA_VISIBLE_DEVICES": ""}

    def test_no_gpu(self):
        self.scene()
        result = self.teapath("render", "scene.json", "-o", "a.png", "--backend", "cuda",
                              env=self.HIDDEN)
        self.assert_error(result, DEVICE, "--backend host")
        self.assertEqual(self.files(), ["scene.json"])

    def test_a_device_number_that_is_not_there(self):
        self.scene()
        for number in (99, 1023):
            result = self.teapath("render", "scene.json", "-o", "a.png", "--device", number)
            self.assert_error(result, DEVICE)
            self.assertRegex(result.stderr, "this build has no CUDA|teapath info|--backend host")
            self.assertEqual(self.files(), ["scene.json"])

    def test_auto_takes_the_host_and_says_so(self):
        self.scene()
        result = self.teapath("render", "scene.json", "-o", "a.png", env=self.HIDDEN)
        self.assert_done(result)
        lines = [line for line in result.stderr.splitlines() if line.startswith("info: ")]
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertIn("no CUDA device, rendering on the host", lines[0])
        self.assertIn("on host, ", result.stderr)


if __name__ == "__main__":
    main()
