#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What checkpoints cost: renders with and without take turns, and the medians of their times are compared.

    bench/checkpoint_cost.py [--every 10s] [--pairs 7] [--width 512] [--spp 512] [--strahl build/release/strahl] [SCENE]

A run counts by its wall clock and by the processor seconds of its process, which a busy machine disturbs less. Both are
also told for one checkpoint: with `--every 1s` many of them stand out from what else differs between two runs. Exits with
1 where the processor seconds are 2 % more with checkpoints than without.
"""
import argparse
import os
import pathlib
import statistics
import subprocess
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent


def count_versions(path, is_over, seen):
    """Of a file that is replaced now and then."""
    ends = False
    while not ends:
        ends = is_over.wait(0.02)  # And once more behind the end: the last version may be younger than the last look.
        try:
            status = os.stat(path)
            seen.add((status.st_ino, status.st_mtime_ns))
        except FileNotFoundError:
            pass


def seconds_of(command, kept=None):
    """Wall and processor seconds, and how many checkpoints were kept."""
    is_over, seen = threading.Event(), set()
    watcher = threading.Thread(target=count_versions, args=(kept, is_over, seen))
    start = time.perf_counter()
    process = subprocess.Popen([str(part) for part in command])
    if kept:
        watcher.start()
    _, status, usage = os.wait4(process.pid, 0)
    wall = time.perf_counter() - start
    is_over.set()
    if kept:
        watcher.join()
    if status != 0:
        raise SystemExit(f"{command[0]} ended with {os.waitstatus_to_exitcode(status)}")
    return wall, usage.ru_utime + usage.ru_stime, len(seen)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", nargs="?", default=ROOT / "scenes/cornell/cornell-box.xml")
    parser.add_argument("--every", default="10s")
    parser.add_argument("--pairs", type=int, default=7)
    parser.add_argument("--width", type=int, default=512)
    parser.add_argument("--spp", type=int, default=512)
    parser.add_argument("--strahl", default=ROOT / "build/release/strahl")
    arguments = parser.parse_args()
    ratios, each = [], []
    with tempfile.TemporaryDirectory() as name:
        kept = pathlib.Path(name) / "part.ckpt"
        render = [arguments.strahl, "render", arguments.scene, "-q", "--width", arguments.width, "--height",
                  arguments.width, "-o", pathlib.Path(name) / "out.pfm", "--spp"]
        seconds_of([*render, 1])  # Its program is cached from here on.
        for pair in range(arguments.pairs):
            taken = {}
            for keeps in [False, True] if pair % 2 == 0 else [True, False]:
                kept.unlink(missing_ok=True)
                keep = ["--checkpoint", kept, "--every", arguments.every] if keeps else []
                taken[keeps] = seconds_of([*render, arguments.spp, *keep], kept if keeps else None)
            (plain_wall, plain, _), (wall, processor, count) = taken[False], taken[True]
            if count == 0:
                raise SystemExit(f"no checkpoint was written in {wall:.1f} s: nothing can be told of its cost")
            ratios.append((wall / plain_wall, processor / plain))
            each.append(((wall - plain_wall) / count, (processor - plain) / count))
            print(f"without {plain_wall:.1f} s ({plain:.2f} of a processor), with {count} checkpoints {wall:.1f} s"
                  f" ({processor:.2f})", flush=True)
    wall, processor = (statistics.median(column) for column in zip(*ratios))
    wall_each, processor_each = (1000 * statistics.median(column) for column in zip(*each))
    print(f"checkpoints every {arguments.every}: {100 * (processor - 1):+.2f} % of the processor seconds,"
          f" {100 * (wall - 1):+.2f} % of the time (medians of {arguments.pairs} pairs)")
    print(f"one checkpoint: {processor_each:.0f} ms of a processor, {wall_each:.0f} ms of the time")
    return 1 if processor > 1.02 else 0


if __name__ == "__main__":
    raise SystemExit(main())
