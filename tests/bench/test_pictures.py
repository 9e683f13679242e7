#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""test_pictures.py STRAHL: bench/pictures makes scenes that strahl reads with --strict, and tells the pictures of one
truth from those of another."""
import array
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

BENCH = pathlib.Path(__file__).resolve().parents[2] / "bench"
sys.path[:0] = [str(BENCH / "pictures"), str(BENCH / "peers")]
from scenes import SCENES  # noqa: E402
from seeds import Seeds, agreement  # noqa: E402

STRAHL = sys.argv.pop(1)
SIDE, NOISE = 32, 0.2
# Where the defaults would take seconds to write.
SIZES = {"terrain": 5000, "hall": 500, "field": 50}


class Scenes(unittest.TestCase):
    def test_strahl_reads_each(self):
        for name, make in SCENES.items():
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                path = make(pathlib.Path(folder), 16, SIZES.get(name, 0))
                told = subprocess.run([STRAHL, "explain", path, "--strict"], check=False, capture_output=True, text=True)
                self.assertEqual((told.returncode, told.stderr), (0, ""))


class Agreement(unittest.TestCase):
    """Pictures of truth and white noise."""

    def seeds(self, truth, first_seed):
        seeds = Seeds()
        with tempfile.TemporaryDirectory() as folder:
            for seed in range(first_seed, first_seed + 4):
                chance = random.Random(seed)
                path = pathlib.Path(folder) / "picture.pfm"
                values = array.array("f", (value + chance.gauss(0, NOISE) for value in truth))
                if sys.byteorder == "big":
                    values.byteswap()
                path.write_bytes(f"PF\n{SIDE} {SIDE}\n-1.0\n".encode("ascii") + values.tobytes())
                seeds.add(path)
        return seeds

    def setUp(self):
        self.truth = [1 + index % 5 / 5 for index in range(3 * SIDE * SIDE)]
        self.ours = self.seeds(self.truth, 0)

    def test_squared_error_is_the_variance(self):
        self.assertAlmostEqual(self.ours.squared_error() / NOISE ** 2, 1, delta=0.05)

    def test_one_truth_agrees(self):
        off, fault = agreement(self.ours, self.seeds(self.truth, 100))
        self.assertEqual(fault, "")
        self.assertLess(abs(off), 0.01)

    def test_a_brighter_picture_does_not(self):
        off, fault = agreement(self.ours, self.seeds([1.05 * value for value in self.truth], 100))
        self.assertNotEqual(fault, "")
        self.assertAlmostEqual(off, -0.05, delta=0.01)

    def test_a_block_of_another_colour_does_not(self):
        other = list(self.truth)
        for y in range(4):
            for x in range(4):
                other[3 * (y * SIDE + x)] += 0.8
        self.assertNotEqual(agreement(self.ours, self.seeds(other, 100))[1], "")

    def test_a_value_that_is_no_number_does_not(self):
        other = list(self.truth)
        other[7] = float("nan")
        self.assertNotEqual(agreement(self.ours, self.seeds(other, 100))[1], "")


if __name__ == "__main__":
    unittest.main()
