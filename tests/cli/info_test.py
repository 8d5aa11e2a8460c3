#!/usr/bin/env python3
"""`teapath info`: counts, lights, memory, devices; as text and as JSON."""
import json
import os
import unittest

from support import INPUT, REPOSITORY, CommandTest, main


class Info(CommandTest):
    def info(self, *arguments):
        result = self.teapath("info", *arguments)
        self.assert_done(result)
        self.assertEqual(result.stderr, "")
        return result.stdout

    def test_a_scene_as_text(self):
        self.scene()
        text = self.info("scene.json")
        for line in (r"^Scene +Test \(scene\.json\)$", r"^Render +32 x 24, 4 samples, depth 8, "
                     r"path, tea, seed 0$", r"^Cameras +front \(active\), above$",
                     r"^Objects +3: 2 sphere, 1 xz_rect$",
                     r"^Materials +2: 1 lambertian, 1 diffuse_light$", r"^Textures +0$",
                     r"^Background +constant$", r"^Lights +1$", r"^Tree +\d+ nodes, \d+ levels",
                     r"^Memory +[\d.]+ (B|KiB)$", r"^Devices +\S", r"^Host +\d+ threads$"):
            self.assertRegex(text, "(?m)" + line)

    def test_a_scene_as_json(self):
        def change(scene):
            scene["objects"][1]["visible"] = False
            scene["textures"] = {"wood": {"type": "image", "file": "wood.png"}}
            scene["generate"] = [{"type": "sphere_grid", "columns": 10, "rows": 10}]
        self.scene(change=change)
        with open(os.path.join(REPOSITORY, "assets", "textures", "wood.png"), "rb") as file:
            self.write("wood.png", file.read())
        report = json.loads(self.info("scene.json", "--json"))
        scene = report["scene"]
        self.assertEqual(scene["name"], "Test")
        self.assertEqual(scene["render"], {"width": 32, "height": 24, "samples": 4, "max_depth": 8,
                                           "integrator": "path", "sampler": "tea", "seed": 0})
        self.assertEqual(scene["cameras"], ["front", "above"])
        self.assertEqual(scene["active_camera"], "front")
        self.assertEqual(scene["objects"], {"total": 103, "sphere": 102, "xz_rect": 1})
        self.assertEqual((scene["generators"], scene["generated_objects"]), (1, 100))
        self.assertEqual(scene["hidden_objects"], 1)
        self.assertEqual(scene["materials"]["total"], 102)
        self.assertEqual(scene["lights"], 1)
        self.assertEqual(scene["textures"], {"total": 1, "image": 1})
        image = scene["images"][0]
        self.assertEqual(image["bytes"], image["width"] * image["height"] * image["channels"])
        self.assertGreater(scene["scene_bytes"], image["bytes"] + 102 * 64)
        self.assertGreater(scene["tree"]["nodes"], 10)

    def test_the_machine(self):
        report = json.loads(self.info("--json"))
        self.assertNotIn("scene", report)
        self.assertEqual(report["program"]["name"], "Teapath")
        machine = report["machine"]
        self.assertGreaterEqual(machine["host_threads"], 1)
        # Devices, or why there are none.
        self.assertTrue(machine["cuda_devices"] or machine["cuda_status"])
        for device in machine["cuda_devices"]:
            self.assertEqual(set(device), {"index", "name", "compute", "multiprocessors",
                                           "memory_bytes", "uuid"})
        text = self.info()
        self.assertRegex(text, r"(?m)^Program +Teapath \d")
        self.assertRegex(text, r"(?m)^Devices +\S")

    def test_a_missing_image_is_named(self):
        self.scene(change=lambda s: s["materials"]["grey"].update(
            color={"type": "image", "file": "gone.png"}))
        result = self.teapath("info", "scene.json", "--json")
        self.assert_done(result)
        self.assertIn("warning: ", result.stderr)
        image = json.loads(result.stdout)["scene"]["images"][0]
        self.assertEqual(image, {"path": "gone.png", "missing": True})

    def test_every_shipped_scene(self):
        folder = os.path.join(REPOSITORY, "scenes")
        count = 0
        for root, _, names in os.walk(folder):
            for name in filter(lambda n: n.endswith(".json"), names):
                report = json.loads(self.info(os.path.join(root, name), "--json"))
                self.assertTrue(report["scene"]["cameras"], name)
                self.assertFalse([i for i in report["scene"]["images"] if i.get("missing")], name)
                count += 1
        self.assertGreaterEqual(count, 21)

    def test_names_that_are_no_utf8_stop_nothing(self):
        text = self.read(self.scene()).replace(b'"Test"', b'"\xc3\xa9t\xc3\xa9"')
        self.write("scene.json", text)
        self.assertEqual(json.loads(self.info("scene.json", "--json"))["scene"]["name"], "été")

    def test_a_missing_scene(self):
        self.assert_error(self.teapath("info", "gone.json", "--json"), INPUT, "gone.json",
                          "no such file")


if __name__ == "__main__":
    main()
