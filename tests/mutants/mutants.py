#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Puts known mistakes into the kernels, one at a time, and requires that a test turns red for every one of them.

mutants.py BUILD [--only ID ...] [--all] [--matrix] [--list]

A mutant is one replacement in a copy of cl/, which the built programs read by way of STRAHL_KERNEL_DIR. It is killed
by a command that fails because a check failed: a program that no longer builds, an exception or a crash proves nothing
and counts as an error. Mutants stand in *.mutants beside this file, whose language round.mutants explains. A mutant's
first killer must kill it; those that say `matrix: only` are asked by --all, and must fit in any case. --matrix runs
every killer of the list and WHOLE_TESTS against every mutant, keeps what it has found in BUILD/mutants/matrix.json, and
goes on from there.
"""
import argparse
import concurrent.futures
import dataclasses
import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
KERNELS = HERE.parents[1] / "cl"
TABLE = HERE.parents[1] / "docs" / "mutants.md"
HEAD = """# Mutants

Known mistakes that the tests must find. `tests/mutants/mutants.py BUILD` puts each of them into a copy of `cl/` and
requires that the named test turns red, of those marked (matrix) with `--all`; `--matrix` asks all these tests and some
more about every mutant. Both are of the label `slow`. Written by `mutants.py BUILD --list`.

| mutant | the mistake | killed by |
|---|---|---|
"""
# What the matrix asks as well: whole tests that render or ask PoCL.
WHOLE_TESTS = ["selftest_test_catalogue_devices", "selftest_test_catalogue_pictures", "render_test_closed_form",
               "render_test_mirrors", "render_test_checkerboard", "render_test_terminator", "render_test_metamorphic",
               'cl_test_watertight "exactly one hit from inside\\, on PoCL"',
               'cl_test_arbitrary_bits "arbitrary bits\\, on PoCL"']
SECONDS = 300  # A killer that takes longer is an error.
DOES_NOT_HOLD = 7  # Exit code of mutants_ask.
PASSED, KILLED, ERROR = "passes", "kills", "error"


class Misfit(Exception):
    """The list of mutants is wrong."""


@dataclasses.dataclass
class Mutant:
    name: str
    place: str
    what: str = ""
    file: str = ""
    # What is taken away and what is put there; most have one pair.
    edits: list = dataclasses.field(default_factory=list)
    killers: list = dataclasses.field(default_factory=list)
    matrix_only: bool = False

    def apply(self, kernels):
        path = kernels / self.file
        text = path.read_text()
        for old, new in self.edits:
            text, found = re.subn(any_layout(old), lambda _: new, text)
            if found != 1:
                raise Misfit(f"{self.place}: {self.name} no longer fits: cl/{self.file} has {found} times\n{old}")
        path.write_text(text)


def any_layout(code):
    """The code however its lines are broken: clang-format moves breaks where a name grows."""
    tokens = re.findall(r"\w+|[^\w\s]", code)
    pattern = "".join(re.escape(a) + (r"\s+" if re.match(r"\w", a[-1]) and re.match(r"\w", b[0]) else r"\s*")
                      for a, b in zip(tokens, tokens[1:]))
    return pattern + re.escape(tokens[-1])


def read_mutants(path):
    mutants, before = [], ""
    for number, line in enumerate(path.read_text().splitlines(), 1):
        place = f"{path.name}:{number}"
        key, _, rest = line.partition(" ")
        if key.startswith("["):
            mutants.append(Mutant(line.strip("[]"), place))
        elif not key or key.startswith("#"):
            pass
        elif not mutants:
            raise Misfit(f"{place}: a mutant begins with [its-name]")
        elif key == "what:":
            mutants[-1].what = rest
        elif key == "file:":
            mutants[-1].file = rest
        elif key == "matrix:" and rest == "only":
            mutants[-1].matrix_only = True
        elif key == "killer:":
            mutants[-1].killers.append(rest)
        elif key in "-+":
            edits = mutants[-1].edits
            if key == "-":
                if before == "-":
                    edits[-1][0] += "\n" + rest
                else:
                    edits.append([rest, ""])
            elif before in ("-", "+") and edits:
                edits[-1][1] += ("\n" if before == "+" else "") + rest
            else:
                raise Misfit(f"{place}: + without -")
        else:
            raise Misfit(f"{place}: unknown word {key}")
        before = key
    for mutant in mutants:
        if not (mutant.what and mutant.file and mutant.edits and mutant.killers):
            raise Misfit(f"{mutant.place}: {mutant.name} lacks what:, file:, a replacement or killer:")
    return mutants


def all_mutants():
    mutants = [mutant for path in sorted(HERE.glob("*.mutants")) for mutant in read_mutants(path)]
    names = [mutant.name for mutant in mutants]
    for name in names:
        if names.count(name) > 1:
            raise Misfit(f"two mutants are called {name}")
    return mutants


def verdict(killer, status, output):
    if status == 0:
        return PASSED
    if killer.startswith("mutants_ask "):
        return KILLED if status == DOES_NOT_HOLD else ERROR
    checks = re.findall(r"^(?:.*: )?FAILED:\n", output, re.M)
    return KILLED if checks and "due to " not in output and 0 < status < 128 else ERROR


def table(mutants):
    rows = [f"| {m.name}{' (matrix)' if m.matrix_only else ''} | {m.what} | "
            f"{', '.join(f'`{killer}`' for killer in m.killers)} |" for m in mutants]
    return HEAD + "\n".join(rows) + "\n"


def command(build, killer):
    """A program of the build, or the tests of a file by ctest's name for them, all or those of the names that follow."""
    program, *arguments = shlex.split(killer)
    test = re.fullmatch("(.+?)_(test_.+)", program)
    if test:
        program, arguments = f"{test[1]}_tests", arguments or ["-#", f"[#{test[2]}]"]
        arguments = ["--warn", "NoTests", "--abort", *arguments]  # One failed check is a kill.
    return [build / "tests" / program, *arguments]


class Laboratory:
    def __init__(self, build):
        self.build = build
        self.folder = build / "mutants"
        self.folder.mkdir(exist_ok=True)

    def kernels(self, mutant):
        copy = self.folder / "cl" / (mutant.name if mutant else "unchanged")
        shutil.rmtree(copy, ignore_errors=True)
        shutil.copytree(KERNELS, copy)
        if mutant:
            mutant.apply(copy)
        return copy

    def run(self, killer, kernels):
        """What became of it, in how many seconds, and the output."""
        # Verdicts and programs of wrong kernels stay out of the user's caches.
        caches = {"STRAHL_CACHE_DIR": str(kernels) + ".cache", "POCL_CACHE_DIR": str(self.folder / "pocl")}
        pathlib.Path(caches["POCL_CACHE_DIR"]).mkdir(exist_ok=True)
        started = time.monotonic()
        try:
            done = subprocess.run(command(self.build, killer), env=os.environ | caches |
                                  {"STRAHL_KERNEL_DIR": str(kernels)}, timeout=SECONDS, text=True,
                                  errors="replace", stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT)
        except subprocess.TimeoutExpired:
            return ERROR, float(SECONDS), f"took longer than {SECONDS} s"
        return verdict(killer, done.returncode, done.stdout), time.monotonic() - started, done.stdout


def first_that_kills(laboratory, mutant):
    kernels = laboratory.kernels(mutant)
    killer = mutant.killers[0]
    result, seconds, output = laboratory.run(killer, kernels)
    return mutant, killer, result, seconds, output


def run_named(laboratory, mutants, workers):
    survivors = 0
    with concurrent.futures.ThreadPoolExecutor(workers) as pool:
        for mutant, killer, result, seconds, output in pool.map(lambda m: first_that_kills(laboratory, m), mutants):
            print(f"{mutant.name:28} {result if result != PASSED else 'SURVIVES':8} {seconds:5.1f} s  {killer}",
                  flush=True)
            if result != KILLED:
                survivors += 1
                print(f"  {mutant.place}: {mutant.what}\n" + "\n".join("  | " + x for x in output.splitlines()[-25:]))
    print(f"{len(mutants) - survivors} of {len(mutants)} mutants are killed")
    return survivors


def fingerprint(mutant, killer, laboratory):
    path = command(laboratory.build, killer)[0]
    kernels = b"".join(file.read_bytes() for file in sorted(KERNELS.rglob("*")) if file.is_file())
    parts = [str(mutant and mutant.edits), killer, str(path.stat().st_mtime_ns)]
    return hashlib.sha256("\n".join(parts).encode() + kernels).hexdigest()[:16]


def run_matrix(laboratory, mutants, workers):
    killers = sorted({killer for mutant in all_mutants() for killer in mutant.killers}) + WHOLE_TESTS
    store = laboratory.folder / "matrix.json"
    known = json.loads(store.read_text()) if store.exists() else {}

    def ask(pair):
        mutant, killer = pair
        key = fingerprint(mutant, killer, laboratory)
        if key not in known:
            known[key] = laboratory.run(killer, copies[mutant and mutant.name])[:2]
            temporary = store.with_suffix(f".{key}")
            temporary.write_text(json.dumps(dict(known)))
            temporary.replace(store)
        return known[key][0]

    copies = {mutant and mutant.name: laboratory.kernels(mutant) for mutant in [None, *mutants]}
    for number, killer in enumerate(killers):
        print(f"{number:3} {killer}")
    failures = 0
    with concurrent.futures.ThreadPoolExecutor(workers) as pool:
        for mutant in [None, *mutants]:
            results = list(pool.map(ask, [(mutant, killer) for killer in killers]))
            killed_by = [number for number, result in enumerate(results) if result == KILLED]
            failed = killed_by or ERROR in results if mutant is None else not killed_by
            failures += bool(failed)
            print(f"{mutant.name if mutant else '(none)':28} {'FAILURE ' if failed else ''}"
                  f"killed by {', '.join(map(str, killed_by)) or 'nothing'}", flush=True)
    return failures


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--only", action="append", metavar="ID")
    parser.add_argument("--all", action="store_true", help="those too that are of the matrix alone")
    parser.add_argument("--matrix", action="store_true", help="every killer against every mutant")
    parser.add_argument("--list", action="store_true", help="the mutants and their killers, as a table")
    options = parser.parse_args()
    try:
        mutants = all_mutants()
        if options.list:
            print(table(mutants), end="")
            return 0
        if TABLE.read_text() != table(mutants):
            raise Misfit(f"docs/{TABLE.name} is not what mutants.py --list prints")
        if options.only:
            mutants = [mutant for mutant in mutants if mutant.name in options.only]
        laboratory = Laboratory(options.build.resolve())
        if not (options.only or options.all or options.matrix):
            for mutant in mutants:
                if mutant.matrix_only:
                    laboratory.kernels(mutant)
            mutants = [mutant for mutant in mutants if not mutant.matrix_only]
        run = run_matrix if options.matrix else run_named
        return 1 if run(laboratory, mutants, os.cpu_count()) or not mutants else 0
    except Misfit as misfit:
        print(misfit)
        return 1


if __name__ == "__main__":
    sys.exit(main())
