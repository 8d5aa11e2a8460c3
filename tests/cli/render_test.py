#!/usr/bin/env python3
"""What `teapath render` puts into its files: formats, settings, seeds, equal runs."""
import os
import struct
import unittest

from pictures import Bmp, Exr, Hdr, Pfm, Png, Ppm, Tga
from support import BACKEND, CommandTest, main


class Formats(CommandTest):
    def test_all_formats_of_one_render_agree(self):
        self.scene()
        names = ["a.png", "a.ppm", "a.p3.ppm", "a.bmp", "a.tga", "a.jpg", "a.jpeg", "a.hdr",
                 "a.pfm", "a.exr"]
        result = self.render("scene.json", *[word for name in names for word in ("-o", name)])
        self.assert_done(result)
        self.assertEqual(self.files(), sorted(names + ["scene.json"]))
        png = Png(self.read("a.png"))
        self.assertEqual((png.width, png.height), (32, 24))
        self.assertGreater(len(set(png.pixels)), 20, "a picture, not one colour")
        for name, reader, kind in (("a.ppm", Ppm, "P6"), ("a.p3.ppm", Ppm, "P3"),
                                   ("a.bmp", Bmp, ""), ("a.tga", Tga, "")):
            picture = reader(self.read(name))
            self.assertEqual(getattr(picture, "kind", ""), kind)
            self.assertEqual((picture.width, picture.height), (32, 24), name)
            self.assertEqual(picture.pixels, png.pixels, name)
        for name in ("a.jpg", "a.jpeg"):
            data = self.read(name)
            self.assertTrue(data.startswith(b"\xff\xd8") and data.endswith(b"\xff\xd9"))

        exr, pfm, hdr = Exr(self.read("a.exr")), Pfm(self.read("a.pfm")), Hdr(self.read("a.hdr"))
        for c, channel in enumerate("RGB"):
            self.assertEqual(exr.channels[channel],
                             struct.pack(f"<{32 * 24}f", *pfm.values[c::3]), channel)
        for i in range(0, len(pfm.values), 3):
            largest = max(pfm.values[i:i + 3])
            for have, want in zip(hdr.values[i:i + 3], pfm.values[i:i + 3]):
                self.assertLessEqual(abs(have - want), largest / 128, "RGBE has 8 bits")

    def test_extensions_may_be_upper_case(self):
        self.scene()
        self.assert_done(self.render("scene.json", "-o", "A.PNG", "-o", "A.Exr"))
        Png(self.read("A.PNG"))
        Exr(self.read("A.Exr"))

    def test_exr_has_the_planes_of_the_film(self):
        self.scene()
        self.assert_done(self.render("scene.json", "-o", "a.exr", "--spp", 16))
        exr = Exr(self.read("a.exr"))
        self.assertEqual(sorted(exr.types), sorted([
            "R", "G", "B", "A", "albedo.R", "albedo.G", "albedo.B", "normal.X", "normal.Y",
            "normal.Z", "depth.Z", "object_id.id", "material_id.id", "standard_error.Y",
            "samples.count"]))
        corner, middle = 0, 13 * 32 + 16  # sky, sphere
        self.assertEqual(exr.floats("A")[corner], 0)
        self.assertEqual(exr.floats("A")[middle], 1)
        self.assertAlmostEqual(exr.floats("albedo.R")[middle], 0.5, places=5)
        self.assertEqual(exr.floats("depth.Z")[corner], 0)
        self.assertTrue(3 < exr.floats("depth.Z")[middle] < 4.2)
        self.assertGreater(exr.floats("normal.Z")[middle], 0.8)
        self.assertEqual(exr.integers("object_id.id")[corner], 0)
        self.assertEqual(exr.integers("object_id.id")[middle], 1)
        self.assertEqual(set(exr.floats("samples.count")), {16})
        self.assertTrue(all(error >= 0 for error in exr.floats("standard_error.Y")))
        for channel in ("R", "G", "B"):
            self.assertTrue(all(value >= 0 for value in exr.floats(channel)))

    def test_metadata_says_how_the_picture_was_made(self):
        self.scene()
        self.assert_done(self.render("scene.json", "-o", "a.png", "-o", "a.exr", "-o", "a.ppm",
                                     "-o", "a.hdr", "-o", "a.jpg", "-o", "a.tga", "--seed", 77, "--depth", 5, "--camera", "above"))
        want = {"program": "Teapath", "scene": "scene.json", "camera": "above", "seed": "77",
                "samples": "4", "size": "32x24", "depth": "5", "integrator": "path",
                "sampler": "tea", "exposure": "0", "tone_curve": "srgb"}
        png, exr = Png(self.read("a.png")).text, Exr(self.read("a.exr")).attributes
        for key, value in want.items():
            self.assertEqual(png[key], value)
            self.assertEqual(exr[key], value)
        self.assertIn("seed: 77", Ppm(self.read("a.ppm")).comments)
        self.assertIn(b"# seed: 77\n", self.read("a.hdr"))
        self.assertIn(b"seed: 77\n", self.read("a.jpg"))
        self.assertIn("seed: 77\n", Tga(self.read("a.tga")).comment)
        self.assertRegex(png["version"], r"^\d+\.\d+\.\d+$")
        self.assertGreaterEqual(float(exr["seconds"]), 0)
        self.assertNotIn("seconds", png)


class Settings(CommandTest):
    def test_size(self):
        self.scene()
        for width, height in ((1, 1), (17, 3), (3, 17), (33, 25)):
            self.assert_done(self.render("scene.json", "-o", "a.pfm", "--size",
                                         f"{width}x{height}"))
            picture = Pfm(self.read("a.pfm"))
            self.assertEqual((picture.width, picture.height), (width, height))

    def test_camera(self):
        self.scene()
        self.assert_done(self.render("scene.json", "-o", "a.pfm"))
        self.assert_done(self.render("scene.json", "-o", "b.pfm", "--camera", "front"))
        self.assert_done(self.render("scene.json", "-o", "c.pfm", "--camera", "above"))
        self.assertEqual(self.read("a.pfm"), self.read("b.pfm"))
        self.assertNotEqual(self.read("a.pfm"), self.read("c.pfm"))

    def test_options_equal_settings_of_the_file(self):
        def change(scene):
            scene["render"].update(samples=3, max_depth=2, seed=9, width=20, height=10)

        self.scene("other.json", change)
        self.scene()
        self.assert_done(self.render("other.json", "-o", "a.pfm"))
        self.assert_done(self.render("scene.json", "-o", "b.pfm", "--spp", 3, "--depth", 2,
                                     "--seed", 9, "--size", "20x10"))
        self.assert_done(self.render("scene.json", "-o", "c.pfm", "--set", "render.samples=3",
                                     "--set", "render.max_depth=2", "--set", "render.seed=9",
                                     "--set", "render.width=20", "--set", "render.height=10"))
        self.assertEqual(self.read("a.pfm"), self.read("b.pfm"))
        self.assertEqual(self.read("a.pfm"), self.read("c.pfm"))

    def test_an_option_of_its_own_has_the_last_word(self):
        self.scene()
        self.assert_done(self.render("scene.json", "-o", "a.exr", "--spp", 2, "--set",
                                     "render.samples=7"))
        self.assertEqual(Exr(self.read("a.exr")).attributes["samples"], "2")

    def test_the_last_of_two_equal_options_counts(self):
        self.scene()
        self.assert_done(self.render("scene.json", "-o", "a.exr", "--spp", 7, "--spp", 2))
        self.assertEqual(Exr(self.read("a.exr")).attributes["samples"], "2")

    def test_exposure_changes_the_picture_but_not_the_radiance(self):
        self.scene()
        self.assert_done(self.render("scene.json", "-o", "a.png", "-o", "a.pfm"))
        self.assert_done(self.render("scene.json", "-o", "b.png", "-o", "b.pfm", "--set",
                                     "display.exposure=-2"))
        self.assertEqual(self.read("a.pfm"), self.read("b.pfm"))
        self.assertLess(sum(Png(self.read("b.png")).pixels), sum(Png(self.read("a.png")).pixels))

    def test_objects_and_materials_can_be_set(self):
        self.scene()
        self.assert_done(self.render("scene.json", "-o", "a.exr", "--set",
                                     "materials.grey.color=[0.25, 0.25, 0.25]"))
        self.assertAlmostEqual(Exr(self.read("a.exr")).floats("albedo.G")[13 * 32 + 16], 0.25,
                               places=5)

    def test_time_stops_and_takes_at_least_one_sample(self):
        self.scene()
        result = self.render("scene.json", "-o", "a.exr", "--time", 0.5)
        self.assert_done(result)
        exr = Exr(self.read("a.exr")).attributes
        self.assertGreater(int(exr["samples"]), 4, "not the scene's number of samples")
        self.assertLess(float(exr["seconds"]), 10)
        self.assert_done(self.render("scene.json", "-o", "b.exr", "--time", 1e-9))
        self.assertGreaterEqual(int(Exr(self.read("b.exr")).attributes["samples"]), 1)

    def test_samples_stop_before_the_time(self):
        self.scene()
        self.assert_done(self.render("scene.json", "-o", "a.exr", "--time", 1000, "--spp", 3))
        self.assertEqual(Exr(self.read("a.exr")).attributes["samples"], "3")


class EqualRuns(CommandTest):
    def test_same_seed_same_picture(self):
        self.scene()
        for name in ("a", "b"):
            self.assert_done(self.render("scene.json", "-o", f"{name}.png", "-o", f"{name}.exr",
                                         "--seed", 5))
        self.assertEqual(self.read("a.png"), self.read("b.png"))
        self.assertEqual(Exr(self.read("a.exr")).channels, Exr(self.read("b.exr")).channels)

    def test_other_seed_other_picture(self):
        self.scene()
        for name, seed in (("a", 5), ("b", 6), ("c", 2**32 + 5), ("d", "random"), ("e", "random")):
            self.assert_done(self.render("scene.json", "-o", f"{name}.pfm", "--seed", seed))
        pictures = {self.read(f"{name}.pfm") for name in "abcde"}
        self.assertEqual(len(pictures), 5)

    def test_a_random_seed_can_be_repeated(self):
        self.scene()
        self.assert_done(self.render("scene.json", "-o", "a.png", "-o", "a.pfm", "--seed",
                                     "random"))
        seed = Png(self.read("a.png")).text["seed"]
        self.assert_done(self.render("scene.json", "-o", "b.pfm", "--seed", seed))
        self.assertEqual(self.read("a.pfm"), self.read("b.pfm"))

    @unittest.skipUnless(BACKEND == "host", "threads are the host's")
    def test_any_number_of_threads_gives_the_same_picture(self):
        self.scene()
        for threads in (1, 2, 7):
            self.assert_done(self.render("scene.json", "-o", f"{threads}.png", "-o",
                                         f"{threads}.exr", "--threads", threads, "--spp", 37))
        for threads in (2, 7):
            self.assertEqual(self.read("1.png"), self.read(f"{threads}.png"))
            self.assertEqual(Exr(self.read("1.exr")).channels,
                             Exr(self.read(f"{threads}.exr")).channels)

    def test_an_existing_file_is_replaced(self):
        self.scene()
        self.write("a.png", b"old" * 100000)
        self.assert_done(self.render("scene.json", "-o", "a.png"))
        Png(self.read("a.png"))

    def test_names_with_spaces_and_other_alphabets(self):
        os.mkdir(self.path("Öfen & Töpfe 茶"))
        self.scene("Öfen & Töpfe 茶/scène finale.json")
        name = "Öfen & Töpfe 茶/чайник 🫖.png"
        self.assert_done(self.render("Öfen & Töpfe 茶/scène finale.json", "-o", name))
        self.assertEqual(Png(self.read(name)).text["scene"], "scène finale.json")

    def test_a_link_stays_a_link(self):
        self.scene()
        os.mkdir(self.path("far"))
        self.write("far/picture.png", b"old")
        os.symlink("far/picture.png", self.path("a.png"))
        self.assert_done(self.render("scene.json", "-o", "a.png"))
        self.assertTrue(os.path.islink(self.path("a.png")))
        Png(self.read("far/picture.png"))


class Denoising(CommandTest):
    def test_without_the_library_the_picture_keeps_its_noise_and_a_warning_says_why(self):
        self.scene()
        self.assert_done(self.render("scene.json", "-o", "noisy.png", "--spp", 4))
        result = self.render("scene.json", "-o", "a.png", "-o", "a.exr", "--spp", 4, "--denoise",
                             env={"TEAPATH_OIDN": "/nowhere"})
        self.assert_done(result)
        self.assertIn("no denoiser", result.stderr)
        self.assertIn("TEAPATH_OIDN", result.stderr, "the remedy")
        self.assertEqual(Png(self.read("a.png")).pixels, Png(self.read("noisy.png")).pixels)
        self.assertNotIn("noisy.R", Exr(self.read("a.exr")).types)


if __name__ == "__main__":
    main()
