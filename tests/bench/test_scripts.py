#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Scripts in bench/ with a program that only pretends to render."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

BENCH = pathlib.Path(__file__).resolve().parents[2] / "bench"
# Writes what the scripts read (a checkpoint with FAKE_KEEPS alone), and fails with FAKE_CODE where that is set and the
# time is not the warm-up's.
FAKE = """#!/bin/sh
if [ "$1" = compare ]; then echo "mse $FAKE_MSE"; exit 0; fi
while [ $# -gt 1 ]; do
  if [ "$1" = --stats ]; then
    echo '{"seconds": {"total": 0.001, "other": 0}, "least_spp": 1, "most_spp": 1}' >"$2"
  fi
  if [ "$1" = --checkpoint ] && [ -n "$FAKE_KEEPS" ]; then echo film >"$2"; fi
  if [ "$1" = --time ]; then asked=$2; fi
  shift
done
if [ -n "$FAKE_CODE" ] && [ "$asked" != 10s ]; then echo "no such device" >&2; exit "$FAKE_CODE"; fi
"""


def script(name, *arguments, **environment):
    with tempfile.TemporaryDirectory() as folder:
        fake = pathlib.Path(folder) / "strahl"
        fake.write_text(FAKE)
        fake.chmod(0o755)
        return subprocess.run([sys.executable, "-B", BENCH / name, "--strahl", fake, *arguments], check=False,
                              capture_output=True, text=True, env=os.environ | environment)


class Deadlines(unittest.TestCase):
    def test_renders_in_time(self):
        told = script("deadlines.py", "--runs", "2", "--least", "5")
        self.assertEqual((told.returncode, told.stderr), (0, ""))
        self.assertIn("0 of 2 late", told.stdout)

    def test_a_late_one_is_counted(self):
        told = script("deadlines.py", "--runs", "2", "--least", "5", FAKE_CODE="6")
        self.assertEqual((told.returncode, told.stderr), (0, ""))  # The clock decides, and the fake is quick.
        self.assertIn("exit code 6", told.stdout)

    def test_a_failed_one_ends_it(self):
        told = script("deadlines.py", "--runs", "2", "--least", "5", FAKE_CODE="4")
        self.assertEqual(told.returncode, 1)
        self.assertIn("ended with 4", told.stderr)
        self.assertIn("no such device", told.stderr)
        self.assertNotIn("late;", told.stdout)

    def test_times_too_short_for_a_sample(self):
        told = script("deadlines.py", "--runs", "1", "--least", "1e-6", "--most", "1e-6")
        self.assertEqual((told.returncode, told.stderr), (0, ""))
        self.assertIn("no time was long enough", told.stdout)


class ErrorCost(unittest.TestCase):
    def test_the_median_of_the_scenes(self):
        told = script("error_cost.py", "a/b.xml", "--pairs", "1", FAKE_MSE="0.25")
        self.assertEqual((told.returncode, told.stderr), (0, ""))
        self.assertIn("median of 1 scenes: 0 % lost", told.stdout)

    def test_pictures_without_an_error(self):
        told = script("error_cost.py", "a/b.xml", "--pairs", "1", FAKE_MSE="0")
        self.assertEqual(told.returncode, 1)
        self.assertIn("no error to compare", told.stderr)
        self.assertNotIn("Traceback", told.stderr)


class CheckpointCost(unittest.TestCase):
    def test_one_that_is_written_last_counts(self):
        told = script("checkpoint_cost.py", "--pairs", "2", FAKE_KEEPS="1")
        self.assertEqual(told.stderr, "")
        self.assertEqual(told.stdout.count("with 1 checkpoints"), 2)

    def test_none_is_told(self):
        told = script("checkpoint_cost.py", "--pairs", "2")
        self.assertEqual(told.returncode, 1)
        self.assertIn("no checkpoint was written", told.stderr)
        self.assertNotIn("Traceback", told.stderr)


if __name__ == "__main__":
    unittest.main()
