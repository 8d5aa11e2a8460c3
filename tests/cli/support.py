"""What the tests of the command line share: running the program, small scenes, reading pictures.

Plain Python 3 without packages. The program is $TEAPATH_PROGRAM, the backend $TEAPATH_BACKEND
(host by default).
"""
import copy
import json
import os
import signal
import subprocess
import sys
import tempfile
import unittest

REPOSITORY = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("TEAPATH_PROGRAM",
                         os.path.join(REPOSITORY, "build", "release", "teapath"))
BACKEND = os.environ.get("TEAPATH_BACKEND", "host")

USAGE, INPUT, DEVICE, OUTPUT, INTERRUPTED = 2, 3, 4, 5, 130

# A lit sphere on a floor: every feature plane has something to show.
SCENE = {
    "teapath": 1,
    "name": "Test",
    "cameras": [
        {"name": "front", "look_from": [0, 1, 4], "look_at": [0, 0.5, 0]},
        {"name": "above", "look_from": [0, 6, 0.5], "look_at": [0, 0, 0]},
    ],
    "render": {"width": 32, "height": 24, "samples": 4, "max_depth": 8},
    "background": {"type": "constant", "color": [0.2, 0.3, 0.4]},
    "materials": {
        "grey": {"type": "lambertian", "color": 0.5},
        "lamp": {"type": "diffuse_light", "emission": [4, 4, 4]},
    },
    "objects": [
        {"shape": {"type": "sphere", "center": [0, 0.5, 0], "radius": 0.5}, "material": "grey"},
        {"shape": {"type": "xz_rect", "low": [-3, -3], "high": [3, 3]}, "material": "grey"},
        {"shape": {"type": "sphere", "center": [2, 3, 1], "radius": 0.3}, "material": "lamp"},
    ],
}


def restore_signals():
    """In the child: a test run started in the background may have them ignored."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGPIPE):
        signal.signal(number, signal.SIG_DFL)


def run(*arguments, cwd=None, env=None, timeout=120, **more):
    """Runs the program; the result has returncode, stdout and stderr (text)."""
    environment = dict(os.environ, **(env or {}))
    more.setdefault("stdout", subprocess.PIPE)
    more.setdefault("stderr", subprocess.PIPE)
    more.setdefault("preexec_fn", restore_signals)
    return subprocess.run([PROGRAM, *map(str, arguments)], cwd=cwd, env=environment,
                          stdin=subprocess.DEVNULL, timeout=timeout, errors="replace", **more)


def start(*arguments, cwd=None, **more):
    """Starts the program and returns the process."""
    return subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=cwd, stdin=subprocess.DEVNULL,
                            preexec_fn=restore_signals, **more)


class CommandTest(unittest.TestCase):
    """A test in an empty folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="teapath-test-")
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def files(self):
        """Every file under the folder, so that a test can say that nothing was left behind."""
        return sorted(os.path.relpath(os.path.join(root, name), self.folder)
                      for root, _, names in os.walk(self.folder) for name in names)

    def write(self, name, content):
        data = content if isinstance(content, bytes) else content.encode()
        with open(self.path(name), "wb") as file:
            file.write(data)
        return self.path(name)

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def scene(self, name="scene.json", change=None):
        """Writes the test scene, after change(scene) if given; returns its name."""
        scene = copy.deepcopy(SCENE)
        if change:
            change(scene)
        self.write(name, json.dumps(scene))
        return name

    def teapath(self, *arguments, **more):
        result = run(*arguments, cwd=self.folder, **more)
        self.assertGreaterEqual(result.returncode, 0,
                                f"{arguments}: killed by a signal\n{result.stderr}")
        return result

    def render(self, *arguments, **more):
        """teapath render on the backend of the tests."""
        return self.teapath("render", *arguments, "--backend", BACKEND, **more)

    def assert_done(self, result):
        self.assertEqual(result.returncode, 0, result.stderr)

    def assert_error(self, result, code, *fragments):
        """The exit code, one error line on stderr with these fragments, and no other noise."""
        self.assertEqual(result.returncode, code, result.stderr)
        errors = [line for line in result.stderr.splitlines() if line.startswith("error: ")]
        self.assertEqual(len(errors), 1, result.stderr)
        for fragment in fragments:
            self.assertIn(fragment, errors[0])
        self.assertEqual(result.stdout or "", "")


def main():
    print(f"{os.path.basename(sys.argv[0])}: {PROGRAM}, backend {BACKEND}", file=sys.stderr)
    unittest.main(verbosity=int(os.environ.get("TEAPATH_TEST_VERBOSITY", "1")))
