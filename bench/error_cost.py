#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What telling the error costs sobol: the squared error of as many samples with --no-error and without.

    bench/error_cost.py [SCENE ...] [--spp 64] [--pairs 4] [--width 64] [--strahl build/release/strahl]

Every shipped scene, or those named, is rendered with pairs of seeds. Half of the mean squared difference of a pair is
a picture's squared error, whatever the truth. The efficiency is 1 / (squared error x seconds); docs/effects.md has
what the seconds differ by.
"""
import argparse
import pathlib
import statistics
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent


def squared_error(arguments, scene, folder, options):
    """Mean over the pairs."""
    total = 0
    for pair in range(arguments.pairs):
        pictures = []
        for seed in (2 * pair, 2 * pair + 1):
            pictures.append(folder / f"{seed}.pfm")
            subprocess.run([arguments.strahl, "render", scene, "-q", "--sampler", "sobol", "--spp", str(arguments.spp), "--seed",
                            str(seed), "--width", str(arguments.width), "-o", pictures[-1], *options], check=True)
        told = subprocess.run([arguments.strahl, "compare", *pictures, "--metric", "mse"], check=True,
                              capture_output=True, text=True).stdout
        total += float(told.split()[-1]) / 2
    return total / arguments.pairs


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", type=pathlib.Path)
    parser.add_argument("--spp", type=int, default=64)
    parser.add_argument("--pairs", type=int, default=4)
    parser.add_argument("--width", type=int, default=64)
    parser.add_argument("--strahl", default=ROOT / "build/release/strahl")
    arguments = parser.parse_args()
    lost = []
    with tempfile.TemporaryDirectory() as name:
        shipped = sorted(path for path in (ROOT / "scenes").glob("*/*.xml") if path.name != "stage.xml")
        for scene in arguments.scenes or shipped:
            one, told = (squared_error(arguments, scene, pathlib.Path(name), options) for options in (["--no-error"], []))
            if one == 0:
                continue  # Nothing is drawn.
            lost.append(1 - one / told)
            print(f"{scene.parent.name}/{scene.name}: {told / one:.2f} times the squared error, {100 * lost[-1]:.0f} % lost",
                  flush=True)
    if not lost:
        raise SystemExit("every picture is the same whatever the seed: there is no error to compare")
    print(f"median of {len(lost)} scenes: {100 * statistics.median(lost):.0f} % lost")


if __name__ == "__main__":
    main()
