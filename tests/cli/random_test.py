#!/usr/bin/env python3
"""What `teapath random` prints and writes, and what it refuses. Plain Python 3 without packages; the
program is $TEAPATH_PROGRAM."""
import os
import pty
import signal
import struct
import subprocess
import unittest

REPOSITORY = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("TEAPATH_PROGRAM", os.path.join(REPOSITORY, "build", "release", "teapath"))

KEY = "a341316c,c8013ea4,ad90777d,7e95761e"
USAGE, OUTPUT = 2, 5


def tea(block, key, rounds):
    """TEA as published, to check the whole way to standard output."""
    v0, v1 = block
    total = 0
    for _ in range(rounds):
        total = (total + 0x9e3779b9) & 0xffffffff
        v0 = (v0 + (((v1 << 4) + key[0]) ^ (v1 + total) ^ ((v1 >> 5) + key[1]))) & 0xffffffff
        v1 = (v1 + (((v0 << 4) + key[2]) ^ (v0 + total) ^ ((v0 >> 5) + key[3]))) & 0xffffffff
    return v0, v1


def tea_key(device, seed):
    ik = (0xa341316c, 0xc8013ea4, 0xad90777d, 0x7e95761e)
    a = tea((device, seed), ik, 16)
    b = tea((device, seed), (ik[1], a[0], ik[3], a[1]), 16)
    return b[0], a[0], b[1], a[1]


def random(*arguments, **more):
    more.setdefault("stdout", subprocess.PIPE)
    return subprocess.run([PROGRAM, "random", *map(str, arguments)], stdin=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, timeout=60, check=False, **more)


def stream(*arguments):
    result = random(*arguments)
    assert result.returncode == 0, result.stderr
    return result.stdout


class Blocks(unittest.TestCase):
    def test_known_answers(self):
        for block, rounds, words in (("0,0", 2, "2993bc2c 7014a5d2"), ("0,0", 16, "741c187d 4d3e2c53"),
                                     ("3039,7", 8, "be0aecb6 6edf0078"), ("0x3039,0X7", 32, "d0291b06 b154e57a")):
            result = random("--key", KEY, "--block", block, "--rounds", rounds)
            self.assertEqual((result.returncode, result.stdout.decode()), (0, words + "\n"))
        self.assertEqual(stream("--key", "0,0,0,0", "--block", "0,0"), b"ed285da1 455b33c1\n", "8 rounds by default")

    def test_a_full_disk_is_said(self):
        with open("/dev/full", "wb") as full:
            self.assertEqual(random("--key", KEY, "--block", "0,0", stdout=full).returncode, OUTPUT)


class Streams(unittest.TestCase):
    def test_words_are_those_of_the_counters(self):
        for device, rounds in ((0, 8), (1, 8), (7, 3), (0, 32)):
            data = stream("--seed", 1234567890, "--device", device, "--rounds", rounds, "--bytes", 400)
            key = tea_key(device, 1234567890)
            words = [word for i in range(50) for word in tea((i, 0), key, rounds)]
            self.assertEqual(data, struct.pack("<100I", *words))
        self.assertEqual(stream("--seed", 1234567890, "--bytes", 16).hex(), "ad52332b789226cd81af85a3a03f0045")

    def test_any_length(self):
        whole = stream("--bytes", 600001)  # more than two chunks
        self.assertEqual(len(whole), 600001)
        for size in (0, 1, 7, 8, 127, 129, 262144, 262145):
            self.assertEqual(stream("--bytes", size), whole[:size])

    def test_seed_and_device_make_streams(self):
        options = ([], ["--seed", 1], ["--device", 1], ["--seed", 2 ** 32], ["--seed", 2 ** 64 - 1],
                   ["--device", 2 ** 32 - 1])
        self.assertEqual(len({stream("--bytes", 64, *more) for more in options}), len(options))
        again = random("--seed", "random", "--bytes", 64)
        seed = again.stderr.decode().split()
        self.assertEqual(seed[0], "seed")
        self.assertEqual(stream("--seed", seed[1], "--bytes", 64), again.stdout, "the seed that was said")

    def test_a_reader_may_leave(self):
        with subprocess.Popen([PROGRAM, "random", "--bytes", str(10 ** 15)], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE,
                              preexec_fn=lambda: signal.signal(signal.SIGPIPE, signal.SIG_DFL)) as process:
            self.assertEqual(len(process.stdout.read(100)), 100)
            process.stdout.close()
            self.assertEqual(process.wait(60), 0)
            self.assertEqual(process.stderr.read(), b"")

    def test_a_full_disk_is_said(self):
        for size in (10, 10 ** 9):
            with open("/dev/full", "wb") as full:
                result = random("--bytes", size, stdout=full)
            self.assertEqual(result.returncode, OUTPUT)
            self.assertIn(b"standard output", result.stderr)

    def test_a_terminal_gets_no_bytes(self):
        ours, theirs = pty.openpty()
        result = random("--bytes", 100, stdout=theirs)
        os.close(theirs)
        os.close(ours)
        self.assertEqual(result.returncode, USAGE)
        self.assertIn(b"> FILE", result.stderr)


class Refused(unittest.TestCase):
    def test_wrong_command_lines(self):
        for fragment, *arguments in (
                ("nothing is asked for",),
                ("nothing is asked for", "--seed", 1),
                ("--key: ", "--key", KEY),
                ("--block: ", "--block", "0,0"),
                ("3 words are given", "--key", "1,2,3", "--block", "0,0"),
                ("1 word is given", "--key", KEY, "--block", "0"),
                ("'g' is no", "--key", "0,0,g,0", "--block", "0,0"),
                ("'' is no", "--key", "", "--block", "0,0"),
                ("'-1' is no", "--key", KEY, "--block", "0,-1"),
                ("'100000000' is no", "--key", KEY, "--block", "0,100000000"),
                ("--bytes: ", "--key", KEY, "--block", "0,0", "--bytes", 8),
                ("--seed: ", "--key", KEY, "--block", "0,0", "--seed", 8),
                ("--device: ", "--key", KEY, "--block", "0,0", "--device", 8),
                ("--rounds: ", "--bytes", 8, "--rounds", 0),
                ("--rounds: ", "--bytes", 8, "--rounds", 33),
                ("--bytes: ", "--bytes", -5),
                ("--bytes: ", "--bytes", "1e6"),
                ("--bytes: ", "--bytes", 10 ** 20),
                ("--seed: ", "--bytes", 8, "--seed", -1),
                ("--seed: ", "--bytes", 8, "--seed", 2 ** 64),
                ("--device: ", "--bytes", 8, "--device", 2 ** 32)):
            with self.subTest(arguments=arguments):
                result = random(*arguments)
                self.assertEqual(result.returncode, USAGE, result.stderr)
                self.assertIn(fragment, result.stderr.decode())
                self.assertEqual(result.stdout, b"")


if __name__ == "__main__":
    unittest.main()
