#!/usr/bin/env python3
"""Pictures that cannot be written: said before the first sample where it can be known, with exit
code 5 (2 for a name that means no format), and no file left behind, whole or in part."""
import os
import resource
import shutil
import subprocess
import unittest

from support import BACKEND, OUTPUT, PROGRAM, USAGE, CommandTest, main, run

NOBODY = 65534

# Runs the program in a file system of 64 KiB, then lists what is there.
ON_A_SMALL_DISK = """
mount -t tmpfs -o size=64k none "$1" || exit 99
shift
"$@"
code=$?
ls -A disk
exit $code
"""


def may_mount():
    """Whether a namespace with a mount of its own can be made here."""
    if not shutil.which("unshare"):
        return False
    done = subprocess.run(["unshare", "-rm", "sh", "-c", "mount -t tmpfs -o size=64k none /tmp"],
                          stderr=subprocess.DEVNULL, check=False)
    return done.returncode == 0


def limit_files():
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))


class BadNames(CommandTest):
    def refused(self, output, code, *fragments, before=()):
        """The output is refused before anything is rendered, and nothing new lies there."""
        self.scene()
        files = self.files()
        result = self.render("scene.json", *before, "-o", output, "--spp", 1000000, "--size",
                             "4096x4096")
        self.assert_error(result, code, *fragments)
        self.assertNotIn("spp", result.stderr)
        self.assertEqual(self.files(), files)

    def test_missing_folder(self):
        self.refused("nowhere/a.png", OUTPUT, "nowhere/a.png: cannot write",
                     "there is no folder nowhere", "mkdir -p nowhere")

    def test_a_folder(self):
        os.mkdir(self.path("folder.png"))
        self.refused("folder.png", OUTPUT, "folder.png: cannot write: it is a folder",
                     "add the name of a file")

    def test_a_file_in_the_place_of_a_folder(self):
        self.write("plain", "")
        self.refused("plain/a.png", OUTPUT, "plain/a.png: cannot write: plain is not a folder")

    def test_a_device(self):
        os.symlink("/dev/full", self.path("full.png"))
        self.refused("full.png", OUTPUT, "full.png: cannot write: it is not a plain file")

    def test_a_folder_that_takes_no_files(self):
        self.refused("/proc/a.png", OUTPUT, "/proc/a.png: cannot write:",
                     "name a file in a folder that you may write to")

    def test_a_name_that_is_too_long(self):
        self.refused("a" * 300 + ".png", OUTPUT, "File name too long")

    def test_unknown_extension(self):
        self.refused("a.gif", USAGE, "a.gif: '.gif' is not a format that can be written",
                     ".png", ".exr")
        self.refused("a", USAGE, "a: a name without extension does not say which format")
        self.refused("", USAGE, "-o: the name of a file is missing")
        self.refused("-", USAGE, "a picture cannot go to standard output", "-o image.png")

    def test_the_same_file_twice(self):
        self.refused("./a.png", USAGE, "./a.png: the same file is named twice",
                     before=("-o", "a.png"))

    def test_one_wrong_name_of_two(self):
        self.refused("nowhere/b.exr", OUTPUT, "nowhere/b.exr", before=("-o", "a.png"))

    def test_no_output_at_all(self):
        self.scene()
        self.assert_error(self.render("scene.json"), USAGE, "no file to write is named",
                          "add -o image.png")


class NoPermission(CommandTest):
    """As a user who is not root, for whom every permission holds."""

    def setUp(self):
        super().setUp()
        self.user = {}
        if os.geteuid() == 0:
            self.user = {"user": NOBODY, "group": NOBODY, "extra_groups": []}
            os.chmod(self.folder, 0o755)
            try:
                if run("--version", **self.user).returncode != 0:
                    self.skipTest("the program cannot be run by another user")
            except PermissionError:
                self.skipTest("the program lies where another user cannot go")

    def test_a_folder_without_permission(self):
        self.scene()
        os.mkdir(self.path("closed"), 0o555)
        result = self.render("scene.json", "-o", "closed/a.png", **self.user)
        self.assert_error(result, OUTPUT, "closed/a.png: cannot write: Permission denied",
                          "name a file in a folder that you may write to")
        self.assertEqual(self.files(), ["scene.json"])

    def test_a_file_without_permission(self):
        self.scene()
        os.mkdir(self.path("open"))
        self.write("open/a.png", "old")
        os.chmod(self.path("open"), 0o777)
        os.chmod(self.path("open/a.png"), 0o444)
        result = self.render("scene.json", "-o", "open/a.png", **self.user)
        self.assert_error(result, OUTPUT, "open/a.png: cannot write: Permission denied",
                          "allow writing to it")
        self.assertEqual(self.read("open/a.png"), b"old")

    def test_a_scene_without_permission(self):
        self.scene()
        os.chmod(self.path("scene.json"), 0)
        result = self.teapath("info", "scene.json", **self.user)
        self.assert_error(result, 3, "scene.json: the file cannot be opened: Permission denied",
                          "check its permissions")


class FullDisk(CommandTest):
    def test_a_disk_that_fills_up(self):
        if not may_mount():
            self.skipTest("a small disk cannot be mounted here")
        self.scene()
        os.mkdir(self.path("disk"))
        command = [PROGRAM, "render", "scene.json", "--backend", BACKEND, "--spp", "1", "--size",
                   "256x256", "-o", "disk/a.exr", "-o", "disk/b.png", "-o", "whole.pfm"]
        result = subprocess.run(["unshare", "-rm", "sh", "-c", ON_A_SMALL_DISK, "sh", "disk",
                                 *command], cwd=self.folder, capture_output=True, text=True,
                                timeout=120, check=False)
        # The large file leaves nothing behind, so that the small one finds room.
        self.assertEqual(result.stdout, "b.png\n")
        result.stdout = ""
        self.assert_error(result, OUTPUT, "disk/a.exr", "could not be written whole",
                          "No space left on device", "free some space")
        self.assertEqual(self.files(), ["scene.json", "whole.pfm"])

    def test_a_limit_on_the_size_of_files(self):
        self.scene()
        self.write("a.png", "old")
        result = self.render("scene.json", "-o", "a.png", "-o", "b.exr", preexec_fn=limit_files)
        self.assert_error(result, OUTPUT, "a.png", "could not be written whole", "File too large")
        self.assertEqual(self.files(), ["a.png", "scene.json"])
        self.assertEqual(self.read("a.png"), b"old", "the old file is still whole")

    def test_standard_output(self):
        self.scene()
        for command in (["info"], ["info", "scene.json"], ["info", "--json"], ["--help"],
                        ["render", "--help"], ["--version"]):
            with open("/dev/full", "w") as full, self.subTest(command):
                result = self.teapath(*command, stdout=full)
                self.assert_error(result, OUTPUT, "cannot write to standard output",
                                  "No space left on device")


if __name__ == "__main__":
    main()
