#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Whole pictures: strahl in turns with other renderers, times believed only where the pictures are the same.

main.py --build FOLDER programs [--scenes sphereflake-4,sphereflake-6]
    Whole programs by the wall clock, from start to finished PNG, reading the scene included: POV-Ray 3.7 and Tachyon,
    where they are installed; one ray a pixel and hard shadows, 1024 x 1024, strahl's kernel cache warm.
main.py --build FOLDER paths --mitsuba PYTHON [--scenes all] [--quick]
    Path tracing scenes of many kinds beside Mitsuba 3: paths a second, few samples, --time, efficiency.
main.py --build FOLDER peers --mitsuba PYTHON [--cycles PYTHON] [--luxcore PYTHON] [--spp 256]
    Path tracing the Cornell box: efficiency 1 / (mean squared error x seconds), without compilation, against a long
    picture by Mitsuba 3; each PYTHON is one that can import mitsuba, bpy (Cycles) or pyluxcore.

FOLDER is a build of strahl and strahl-bench (bench/run passes it). --json FILE keeps every round.
"""
import argparse
import json
import pathlib
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE.parent / "peers"))
from path_tracers import Ended  # noqa: E402
from paths import paths  # noqa: E402
from peers import peers  # noqa: E402
from programs import programs  # noqa: E402

QUICK = {"pixels": 128, "rounds": 3}


class Quick(argparse.Action):
    def __call__(self, parser, namespace, values, option_string=None):
        for name, value in QUICK.items():
            setattr(namespace, name, value)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("-d", "--device", default="")
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--json")
    commands = parser.add_subparsers(required=True)

    def add_command(name, run):
        """Takes the common options on its own side too."""
        command = commands.add_parser(name)
        command.add_argument("-d", "--device", default=argparse.SUPPRESS)
        command.add_argument("--rounds", type=int, default=argparse.SUPPRESS)
        command.add_argument("--json", default=argparse.SUPPRESS)
        command.set_defaults(run=run)
        return command

    whole = add_command("programs", programs)
    whole.add_argument("--scenes", default="sphereflake-4,sphereflake-6")
    tracing = add_command("paths", paths)
    tracing.add_argument("--mitsuba")
    tracing.add_argument("--variant", default="llvm_ad_rgb")
    tracing.add_argument("--scenes", default="all", help="NAME or NAME:SIZE, by commas (scenes.py); default: all")
    tracing.add_argument("--spp", type=int, default=64)
    tracing.add_argument("--pixels", type=int, default=256, help="of a side")
    tracing.add_argument("--filter", choices=("box", "gaussian", "tent"), default="box", help="of both")
    tracing.add_argument("--quick", action=Quick, nargs=0, help=f"for development: {QUICK}; later options win")
    cornell = add_command("peers", peers)
    cornell.add_argument("--mitsuba")
    cornell.add_argument("--cycles")
    cornell.add_argument("--luxcore")
    cornell.add_argument("--variant", default="llvm_ad_rgb")
    cornell.add_argument("--spp", type=int, default=256)
    cornell.add_argument("--samplers", default="independent,multijitter")
    cornell.add_argument("--strahl-samplers", default="sobol --no-error,sobol,independent",
                         help="the first is what the others are held against: like them, it tells no error")
    cornell.add_argument("--reference")
    cornell.add_argument("--reference-spp", type=int, default=8192)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        try:
            results = options.run(options, pathlib.Path(folder))
        except Ended as error:
            sys.exit(f"pictures: {error}")
    if options.json:
        pathlib.Path(options.json).write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    faults = [result["fault"] for result in results if result.get("fault")]
    if faults:
        sys.exit("\n".join(f"pictures: {fault}" for fault in faults))


if __name__ == "__main__":
    main()
