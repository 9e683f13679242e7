#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What counts as a mutant's death, and that a mutant which no longer fits is not passed over."""
import pathlib
import tempfile
import unittest

import mutants

CHECK = "test.cpp:7: FAILED:\n  CHECK( leaks == 0 )\nwith expansion:\n  3 == 0\n"
THROWN = "test.cpp:7: FAILED:\ndue to unexpected exception with message:\n  clBuildProgram failed\n"


class Verdict(unittest.TestCase):
    def test_catch(self):
        self.assertEqual(mutants.verdict("cl_test_x", 0, "All tests passed"), mutants.PASSED)
        self.assertEqual(mutants.verdict("cl_test_x", 0, "No tests ran"), mutants.PASSED)
        self.assertEqual(mutants.verdict("cl_test_x", 1, CHECK), mutants.KILLED)
        self.assertEqual(mutants.verdict("cl_test_x", 1, THROWN), mutants.ERROR)
        self.assertEqual(mutants.verdict("cl_test_x", 2, CHECK + THROWN), mutants.ERROR)
        self.assertEqual(mutants.verdict("cl_test_x", -11, CHECK), mutants.ERROR)
        self.assertEqual(mutants.verdict("cl_test_x", 1, "no such file"), mutants.ERROR)

    def test_ask(self):
        self.assertEqual(mutants.verdict("mutants_ask robust box", 0, ""), mutants.PASSED)
        self.assertEqual(mutants.verdict("mutants_ask robust box", 7, ""), mutants.KILLED)
        self.assertEqual(mutants.verdict("mutants_ask robust box", 5, "does not build"), mutants.ERROR)


class List(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)
        (self.path / "x.h").write_text("a = 1;\n  b = 2;\nc = 1;\n")

    def read(self, *lines):
        (self.path / "x.mutants").write_text("\n".join(lines) + "\n")
        return mutants.read_mutants(self.path / "x.mutants")

    def mutant(self, *edits):
        return self.read("[m]", "what: w", "file: x.h", *edits, "killer: k")[0]

    def test_replaces_lines_whatever_their_indentation(self):
        self.mutant("- a = 1;", "- b = 2;", "+ b = 3;", "- c = 1;", "+").apply(self.path)
        self.assertEqual((self.path / "x.h").read_text(), "b = 3;\n\n")

    def test_fits_exactly_once(self):
        for text in ("= 1;", "= 7;"):
            with self.assertRaises(mutants.Misfit):
                self.mutant("- " + text, "+ = 2;").apply(self.path)

    def test_is_complete(self):
        for lines in (["what: w"], ["[m]", "what: w"], ["[m]", "+ x"], ["[m]", "color: red"]):
            with self.assertRaises(mutants.Misfit):
                self.read(*lines)


if __name__ == "__main__":
    unittest.main()
