#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Are renders in time, and do they use it? Every shipped scene takes its turn with a random --time.

    bench/deadlines.py [--runs 30] [--least 0.05] [--most 5] [--seed 1] [--strahl build/release/strahl]

A clock outside the program decides: late is later than 2 % or 20 ms after the time. Each scene is rendered once before,
so that its program is cached. Exits with 1 where more than one run in thirty is late, or one fails.
"""
import argparse
import json
import pathlib
import random
import statistics
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
TARGET_MISSED = 6  # The exit code of a render that was late.


def run(program, scene, folder, options):
    stats = folder / "stats.json"
    stats.unlink(missing_ok=True)
    command = [program, "render", scene, "--width", "320", "-q", "-o", folder / "out.png", "--stats", stats, *options]
    start = time.perf_counter()
    done = subprocess.run([str(part) for part in command], check=False, capture_output=True, text=True, errors="replace")
    wall = time.perf_counter() - start
    if done.returncode not in (0, TARGET_MISSED):
        raise SystemExit(f"{scene}: {program} ended with {done.returncode}, so that its time says nothing: {done.stderr}")
    return wall, done.returncode, json.loads(stats.read_text())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=30)
    parser.add_argument("--least", type=float, default=0.05)
    parser.add_argument("--most", type=float, default=5)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--strahl", default=ROOT / "build/release/strahl")
    arguments = parser.parse_args()
    if arguments.runs < 1:
        parser.error("--runs is 1 or more")
    scenes = sorted(path for path in (ROOT / "scenes").glob("*/*.xml") if path.name != "stage.xml")
    chance = random.Random(arguments.seed)
    late, used, billed = 0, [], []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for index in range(arguments.runs):
            scene = scenes[index % len(scenes)]
            start_up, _, _ = min(run(arguments.strahl, scene, folder, ["--spp", "1", "--time", "10s"]) for _ in range(2))
            seconds = arguments.least * (arguments.most / arguments.least) ** chance.random()
            wall, code, stats = run(arguments.strahl, scene, folder, ["--time", f"{seconds:.4f}"])
            too_short = seconds < start_up
            is_late = not too_short and wall > seconds + max(0.02 * seconds, 0.02)
            late += is_late
            if not too_short:
                used.append(wall / seconds)
            billed.append(wall - stats["seconds"]["total"])
            print(f"{scene.relative_to(ROOT)}: {seconds:.3f} s asked, {wall:.3f} s taken, bill {stats['seconds']['total']:.3f} s,"
                  f" other {stats['seconds']['other']:.3f} s, {stats['least_spp']} to {stats['most_spp']} spp, exit code {code}"
                  f"{' (one sample takes longer)' if too_short else ' LATE' if is_late else ''}", flush=True)
    use = f"median use {100 * statistics.median(used):.0f} %" if used else "no time was long enough for one sample"
    print(f"{late} of {arguments.runs} late; {use}; the bill is short of the"
          f" outside clock by {1e3 * statistics.median(billed):.1f} ms (median), {1e3 * max(billed):.1f} ms (most)")
    return 1 if 30 * late > arguments.runs else 0


if __name__ == "__main__":
    raise SystemExit(main())
