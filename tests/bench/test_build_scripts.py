#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""bench/run and tests/run in a copy of the checkout, with programs that only pretend to build and to test."""
import fcntl
import os
import pathlib
import shutil
import subprocess
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Every call leaves a line of its arguments; one more where another build could run beside it.
FAKES = {
    "cmake": """#!/bin/sh
echo "cmake $*" >>"$CALLS"
if flock -n "$RELEASE/../.setup-lock" true; then echo "cmake ran without the lock" >>"$CALLS"; fi
for program in strahl bench/strahl-bench; do
  mkdir -p "$(dirname "$RELEASE/$program")"
  printf '#!/bin/sh\\necho "ran %s $*"\\n' "$program" >"$RELEASE/$program"
  chmod +x "$RELEASE/$program"
done
""",
    "ctest": '#!/bin/sh\necho "ctest $*" >>"$CALLS"\n',
    # Everything is installed.
    "dpkg-query": '#!/bin/sh\nshift 3\nfor package in "$@"; do echo "ii $package"; done\n',
}


class Checkout(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve()
        for script in ("strahl", "bench/run", "tests/run"):
            (self.root / script).parent.mkdir(exist_ok=True)
            shutil.copy(ROOT / script, self.root / script)
        (self.root / "bin").mkdir()
        for name, text in FAKES.items():
            (self.root / "bin" / name).write_text(text)
            (self.root / "bin" / name).chmod(0o755)
        self.calls = self.root / "calls"
        self.environment = os.environ | {
            "PATH": f"{self.root}/bin:{os.environ['PATH']}",
            "CALLS": str(self.calls),
            "RELEASE": str(self.root / "build/release"),
        }

    def start(self, *command):
        return subprocess.Popen([self.root / command[0], *command[1:]], env=self.environment, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def told(self, *command):
        process = self.start(*command)
        out, err = process.communicate(timeout=30)
        self.assertEqual(process.returncode, 0, err)
        return out

    def called(self, program):
        lines = self.calls.read_text().splitlines() if self.calls.exists() else []
        return [line for line in lines if line.startswith(program + " ")]


class Bench(Checkout):
    def configured_for(self, home):
        cache = self.root / "build/release/CMakeCache.txt"
        cache.parent.mkdir(parents=True, exist_ok=True)
        cache.write_text(f"CMAKE_HOME_DIRECTORY:INTERNAL={home}\n")

    def test_builds_and_runs(self):
        self.configured_for(self.root)
        self.assertEqual(self.told("bench/run", "race", "--quick"), "ran bench/strahl-bench race --quick\n")
        configuring, building = self.called("cmake")
        self.assertNotIn("--fresh", configuring)
        self.assertIn("strahl-bench", building)
        self.assertIn("strahl-bin", building)

    def test_a_moved_checkout_is_configured_anew(self):
        self.configured_for("/elsewhere")
        self.told("bench/run", "race")
        self.assertIn("--fresh", self.called("cmake")[0])

    def test_waits_for_who_builds_already(self):
        self.configured_for(self.root)
        with open(self.root / "build/.setup-lock", "w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            process = self.start("bench/run", "race")
            time.sleep(1)
            self.assertEqual(self.called("cmake"), [])
        self.assertEqual(process.communicate(timeout=30)[0], "ran bench/strahl-bench race\n")


class Launcher(Checkout):
    def test_builds_the_program_alone(self):
        self.assertEqual(self.told("strahl", "devices"), "ran strahl devices\n")
        configuring, building = self.called("cmake")
        self.assertIn("--fresh", configuring)
        self.assertTrue(building.endswith("--target strahl-bin"), building)


class Tests(Checkout):
    def left_out(self, *arguments):
        self.told("tests/run", *arguments)
        words = self.called("ctest")[-1].split()
        return [words[i + 1] for i, word in enumerate(words) if word in ("-LE", "--label-exclude")], words

    def test_the_slow_ones_are_left_out_whatever_else_is(self):
        self.assertEqual(self.left_out()[0], ["^slow$"])
        self.assertEqual(self.left_out("-LE", "render")[0], ["^slow$|render"])
        labels, words = self.left_out("-L", "unit", "--label-exclude", "lint|fuzz", "-R", "scene", "-LE", "render")
        self.assertEqual(labels, ["^slow$|lint|fuzz|render"])
        self.assertEqual(words[-4:], ["-L", "unit", "-R", "scene"])

    def test_nothing_to_leave_out(self):
        process = self.start("tests/run", "-L", "unit", "-LE")
        self.assertIn("-LE needs an expression", process.communicate(timeout=30)[1])
        self.assertEqual(process.returncode, 2)

    def test_slow_ones_too(self):
        self.assertEqual(self.left_out("--slow")[0], [])
        self.assertEqual(self.left_out("--slow", "-LE", "render")[0], ["render"])


if __name__ == "__main__":
    unittest.main()
