#!/usr/bin/env python3
"""A GPU that runs out of memory or is lost, at every CUDA call of a render: exit code 4, a sentence
with the remedy, no picture. Failures are injected at the one place that checks CUDA calls
(TEAPATH_CUDA_FAIL=CALL:CODE), so this needs a GPU: TEAPATH_BACKEND=cuda."""
import re
import unittest

from support import BACKEND, DEVICE, USAGE, CommandTest, main

OUT_OF_MEMORY, LAUNCH_FAILURE, DEVICE_UNAVAILABLE = 2, 719, 46
MOST_CALLS = 200


@unittest.skipUnless(BACKEND == "cuda", "needs a GPU")
class InjectedFailures(CommandTest):
    def failing(self, call, code, *arguments):
        return self.teapath("render", "scene.json", "-o", "a.png", "-o", "a.exr", *arguments,
                            env={"TEAPATH_CUDA_FAIL": f"{call}:{code}"})

    def test_every_call(self):
        self.scene()
        codes = {OUT_OF_MEMORY: ("out of memory", "smaller picture or scene"),
                 LAUNCH_FAILURE: ("launch failure", "the scene is not"),
                 DEVICE_UNAVAILABLE: ("unavailable", "the scene is not")}
        failures = 0
        for call in range(MOST_CALLS):
            code = list(codes)[call % len(codes)]
            result = self.failing(call, code, "--backend", "cuda")
            if result.returncode == 0:
                break
            with self.subTest(call=call, code=code):
                self.assert_error(result, DEVICE, "CUDA: ", *codes[code], "--backend host")
                self.assertRegex(result.stderr, r"error: \w+\.(cu|cuh):\d+: ")
                self.assertEqual(self.files(), ["scene.json"])
            failures += 1
        self.assertGreater(failures, 10, "the calls of a render were not reached")
        self.assertLess(failures, MOST_CALLS)

    def test_auto_renders_on_the_host_where_the_gpu_does_not_start(self):
        self.scene()
        result = self.failing(0, DEVICE_UNAVAILABLE)
        self.assert_done(result)
        self.assertIn("rendering on the host", result.stderr)
        self.assertEqual(self.files(), ["a.exr", "a.png", "scene.json"])

    def test_an_old_picture_stays(self):
        self.scene()
        self.write("a.png", "old")
        self.assert_error(self.failing(8, OUT_OF_MEMORY, "--backend", "cuda"), DEVICE)
        self.assertEqual(self.read("a.png"), b"old")


@unittest.skipUnless(BACKEND == "cuda", "needs a GPU")
class DeviceNumbers(CommandTest):
    def test_the_first_device_is_there_and_the_hundredth_is_not(self):
        self.scene()
        self.assert_done(self.teapath("render", "scene.json", "-o", "a.png", "--device", 0))
        result = self.teapath("render", "scene.json", "-o", "b.png", "--device", 99)
        self.assert_error(result, DEVICE, "99", "teapath info")
        self.assertNotIn("b.png", self.files())
        self.assert_error(self.teapath("render", "scene.json", "-o", "b.png", "--device", -1), USAGE)

    def test_info_lists_it(self):
        self.assertRegex(self.teapath("info").stdout, re.compile(r"^Devices +0: ", re.M))


if __name__ == "__main__":
    main()
