"""docs/keys.md is what the program prints from its table of actions."""
import pathlib
import subprocess
import unittest

from support import PROGRAM

PAGE = pathlib.Path(__file__).parents[2] / "docs" / "keys.md"


class Keys(unittest.TestCase):
    def test_the_page_is_up_to_date(self):
        run = subprocess.run([PROGRAM, "--print-keys"], capture_output=True, text=True, timeout=60)
        if run.returncode != 0:
            self.skipTest("this build has no window")
        self.assertEqual(run.stdout, PAGE.read_text(encoding="utf-8"),
                         "keys or their texts have changed: run teapath --print-keys > docs/keys.md")


if __name__ == "__main__":
    unittest.main()
