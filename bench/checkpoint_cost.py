#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What checkpoints cost: renders with and without take turns, and the medians of their times are compared.

    bench/checkpoint_cost.py [--every 10s] [--pairs 7] [--width 512] [--spp 512] [--strahl build/release/strahl] [SCENE]

A run counts by its wall clock and by the processor seconds of its process, which a busy machine disturbs less. Exits with
1 where the processor seconds are 2 % more with checkpoints than without.
"""
import argparse
import os
import pathlib
import statistics
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent


def seconds_of(command):
    """Wall and processor seconds."""
    start = time.perf_counter()
    process = subprocess.Popen([str(part) for part in command])
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        raise SystemExit(f"{command[0]} ended with {os.waitstatus_to_exitcode(status)}")
    return time.perf_counter() - start, usage.ru_utime + usage.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", nargs="?", default=ROOT / "scenes/cornell/cornell-box.xml")
    parser.add_argument("--every", default="10s")
    parser.add_argument("--pairs", type=int, default=7)
    parser.add_argument("--width", type=int, default=512)
    parser.add_argument("--spp", type=int, default=512)
    parser.add_argument("--strahl", default=ROOT / "build/release/strahl")
    arguments = parser.parse_args()
    ratios = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        render = [arguments.strahl, "render", arguments.scene, "-q", "--width", arguments.width, "--height",
                  arguments.width, "-o", folder / "out.pfm", "--spp"]
        keep = ["--checkpoint", folder / "part.ckpt", "--every", arguments.every]
        seconds_of([*render, 1])  # Its program is cached from here on.
        for pair in range(arguments.pairs):
            order = [[], keep] if pair % 2 == 0 else [keep, []]
            taken = {bool(extra): seconds_of([*render, arguments.spp, *extra]) for extra in order}
            ratios.append([kept / plain for kept, plain in zip(taken[True], taken[False])])
            print(f"without {taken[False][0]:.1f} s ({taken[False][1]:.1f} of a processor), with checkpoints"
                  f" {taken[True][0]:.1f} s ({taken[True][1]:.1f})", flush=True)
    wall, processor = (statistics.median(column) for column in zip(*ratios))
    print(f"checkpoints every {arguments.every}: {100 * (processor - 1):+.2f} % of the processor seconds,"
          f" {100 * (wall - 1):+.2f} % of the time (medians of {arguments.pairs} pairs)")
    return 1 if processor > 1.02 else 0


if __name__ == "__main__":
    raise SystemExit(main())
