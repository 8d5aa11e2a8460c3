#!/usr/bin/env python3
"""Ctrl-C and progress: what is there is saved with exit code 130, a second Ctrl-C leaves at once;
a bar on a terminal, plain lines elsewhere, nothing when asked to be quiet."""
import os
import pty
import re
import select
import signal
import subprocess
import time
import unittest

from pictures import Exr, Png
from support import BACKEND, INTERRUPTED, PROGRAM, CommandTest, main, start

FOREVER = ("--spp", str(1 << 30))

# A shell starts what it puts into the background with SIGINT ignored, and so would be its children.
signal.signal(signal.SIGINT, signal.default_int_handler)


class Interrupts(CommandTest):
    def setUp(self):
        super().setUp()
        self.scene()

    def begin(self, *arguments):
        """Starts a render and returns it when its first step is under way."""
        process = start("render", "scene.json", "--backend", BACKEND, *arguments, cwd=self.folder,
                        stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.kill)
        self.assertIn("seed 0, on ", process.stderr.readline())
        time.sleep(0.3)
        self.assertIsNone(process.poll())
        return process

    def end(self, process):
        _, errors = process.communicate(timeout=60)
        return process.returncode, errors

    def test_what_is_there_is_saved(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(number.name):
                process = self.begin("-o", "a.png", "-o", "a.exr", *FOREVER)
                process.send_signal(number)
                code, errors = self.end(process)
                self.assertEqual(code, INTERRUPTED, errors)
                self.assertIn("wrote a.png", errors)
                self.assertIn("interrupted: the picture holds the samples so far", errors)
                self.assertEqual(self.files(), ["a.exr", "a.png", "scene.json"])
                samples = int(Exr(self.read("a.exr")).attributes["samples"])
                self.assertGreater(samples, 0)
                self.assertEqual(Png(self.read("a.png")).text["samples"], str(samples))

    def test_a_picture_interrupted_is_the_one_of_as_many_samples(self):
        process = self.begin("-o", "a.exr", *FOREVER)
        process.send_signal(signal.SIGINT)
        self.assertEqual(self.end(process)[0], INTERRUPTED)
        interrupted = Exr(self.read("a.exr"))
        self.assert_done(self.render("scene.json", "-o", "b.exr", "--spp",
                                     interrupted.attributes["samples"]))
        if BACKEND == "host":
            self.assertEqual(interrupted.channels, Exr(self.read("b.exr")).channels)

    def test_time_without_end(self):
        process = self.begin("-o", "a.exr", "--time", "100000")
        process.send_signal(signal.SIGINT)
        self.assertEqual(self.end(process)[0], INTERRUPTED)
        self.assertIn("a.exr", self.files())

    @unittest.skipUnless(BACKEND == "host", "a step of a GPU is over too soon")
    def test_a_second_one_leaves_at_once(self):
        # Within a white ball that loses nothing, one sample of every pixel takes a minute.
        def change(scene):
            scene["materials"]["grey"]["color"] = 1
            scene["objects"] = [{"shape": {"type": "sphere", "radius": 9}, "material": "grey"}]
            scene["render"].update(max_depth=4096, roulette_depth=0, width=256, height=256)
        self.scene(change=change)
        process = self.begin("-o", "a.png", *FOREVER, "--threads", "1")
        process.send_signal(signal.SIGINT)
        time.sleep(0.2)
        self.assertIsNone(process.poll(), "it ends the sample that it has begun")
        process.send_signal(signal.SIGINT)
        began = time.monotonic()
        self.assertEqual(self.end(process)[0], INTERRUPTED)
        self.assertLess(time.monotonic() - began, 5)
        self.assertEqual(self.files(), ["scene.json"])

    def test_before_the_first_sample_nothing_is_written(self):
        # A scene from a pipe that nobody fills: the program waits in the middle of loading.
        os.mkfifo(self.path("pipe.json"))
        process = start("render", "pipe.json", "-o", "a.png", "--backend", BACKEND,
                        cwd=self.folder, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.kill)
        with open(self.path("pipe.json"), "w"):
            time.sleep(0.1)
            process.send_signal(signal.SIGINT)
            code, errors = self.end(process)
        self.assertEqual((code, errors), (INTERRUPTED, ""))
        self.assertEqual(self.files(), ["pipe.json", "scene.json"])

    def test_the_last_sample_is_not_an_interruption(self):
        result = self.render("scene.json", "-o", "a.png")
        self.assert_done(result)
        self.assertNotIn("interrupted", result.stderr)


class ProgressOutput(CommandTest):
    def setUp(self):
        super().setUp()
        self.scene()

    def on_a_terminal(self, *arguments, keys=None):
        """Exit code and all that a terminal gets to see; `keys` are pressed at the first bar."""
        child, terminal = pty.fork()
        if child == 0:
            os.chdir(self.folder)
            os.execve(PROGRAM, [PROGRAM, "render", "scene.json", "--backend", BACKEND, *arguments],
                      dict(os.environ, TERM="xterm"))
        seen = b""
        try:
            while select.select([terminal], [], [], 60)[0]:
                piece = os.read(terminal, 65536)
                if not piece:
                    break
                seen += piece
                if keys and b"left" in seen:
                    os.write(terminal, keys)
                    keys = None
        except OSError:
            pass  # the other end is closed
        os.close(terminal)
        return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), seen.decode(errors="replace")

    def test_a_bar_on_a_terminal(self):
        # So many that the bar is drawn more than once.
        samples = "400" if BACKEND == "host" else "100000"
        code, seen = self.on_a_terminal("-o", "a.png", "--spp", samples, "--size", "160x120")
        self.assertEqual(code, 0, seen)
        bars = [part[:-3] for part in seen.split("\r") if part.endswith("\x1b[K") and len(part) > 3]
        self.assertTrue(bars, seen)
        self.assertTrue(any(re.search(r"\d+/" + samples + r" spp.*samples/s.*left", bar) for bar in bars), bars)
        self.assertTrue(all(len(bar) < 80 for bar in bars), bars)
        self.assertIn("wrote a.png", seen)

    def test_control_c_on_a_terminal(self):
        code, seen = self.on_a_terminal("-o", "a.png", *FOREVER, keys=b"\x03")
        self.assertEqual(code, INTERRUPTED, seen)
        self.assertIn("interrupted: the picture holds the samples so far", seen)
        self.assertIn("a.png", self.files())

    def test_plain_lines_elsewhere(self):
        result = self.render("scene.json", "-o", "a.png")
        self.assert_done(result)
        self.assertNotIn("\r", result.stderr)
        self.assertNotIn("\x1b", result.stderr)
        first, *_, before, last = result.stderr.splitlines()
        self.assertRegex(first, r"^scene.json: 32 x 24, 4 spp, seed 0, on ")
        self.assertRegex(before, r"^4 spp in \d+\.\d+ s, [\d.]+ [kM]?samples/s$")
        self.assertEqual(last, "wrote a.png")
        self.assertEqual(result.stdout, "")

    def test_quiet(self):
        result = self.render("scene.json", "-o", "a.png", "--quiet")
        self.assert_done(result)
        self.assertEqual(result.stderr, "")
        self.assertEqual(self.on_a_terminal("-o", "a.png", "--quiet"), (0, ""))

    def test_a_reader_that_goes_away(self):
        process = start("render", "scene.json", "-o", "a.png", "--backend", BACKEND, "--spp",
                        "2000", cwd=self.folder, stderr=subprocess.PIPE)
        process.stderr.close()
        self.assertEqual(process.wait(timeout=60), 0)
        self.assertIn("a.png", self.files())


if __name__ == "__main__":
    main()
