#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Whole pictures: strahl in turns with other renderers, times believed only where the pictures are the same.

pictures.py --build FOLDER programs [--scenes sphereflake-4,sphereflake-6]
    Whole programs by the wall clock, from start to finished PNG, reading the scene included: POV-Ray 3.7 and Tachyon,
    where they are installed; one ray a pixel and hard shadows, 1024 x 1024, strahl's kernel cache warm.
pictures.py --build FOLDER paths --mitsuba PYTHON [--cycles PYTHON] [--luxcore PYTHON] [--spp 256]
    Path tracing the Cornell box: efficiency 1 / (mean squared error x seconds), without compilation, against a long
    picture by Mitsuba 3; each PYTHON is one that can import mitsuba, bpy (Cycles) or pyluxcore.

FOLDER is a build of strahl and strahl-bench (bench/run passes it). --json FILE keeps every round.
"""
import argparse
import contextlib
import json
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE / "peers"))
from path_tracers import THREADS, Ended, Strahl, cycles, luxcore, mitsuba  # noqa: E402

# Mean absolute difference of linear values; Tachyon writes them as they are, where sRGB is expected.
SAME_PICTURE = {"strahl": 0, "strahl, XML elements": 0, "POV-Ray": 0.001, "Tachyon": 0.05}
# Times strahl's largest mean squared error: more is another picture, not noise.
SAME_NOISE = 4


def quiet(command, **more):
    return subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, **more)


def wall_seconds(command):
    start = time.perf_counter()
    quiet(command)
    return time.perf_counter() - start


def difference(strahl, picture, reference, metric):
    output = subprocess.run([strahl, "compare", picture, reference, "--metric", metric], check=True,
                            capture_output=True, text=True).stdout
    return float(output.split()[1])


def say(line):
    print(f"pictures: {line}", file=sys.stderr)


def programs(options, folder):
    """A command a program; each writes its own picture of the same scene."""
    strahl, bench = options.build / "strahl", options.build / "bench" / "strahl-bench"
    results = []
    for scene in options.scenes.split(","):
        base = str(folder / scene)
        more = ["-q", "--sampler", "centre"] + (["-d", options.device] if options.device else [])
        commands = {"strahl": [str(strahl), base + "-cloud.xml", "-o", base + ".png"] + more,
                    "strahl, XML elements": [str(strahl), base + ".xml", "-o", base + "-xml.png"] + more}
        if shutil.which("povray"):
            commands["POV-Ray"] = ["povray", f"+I{base}.pov", f"+O{base}-pov.png", "+W1024", "+H1024", "-D", "-A",
                                   "+WT" + THREADS, "-V"]
        if shutil.which("tachyon"):
            commands["Tachyon"] = ["tachyon", base + ".dat", "-numthreads", THREADS, "-format", "PNG", "-o", base + "-tachyon.png"]
        quiet([bench, "scene", "--cloud", scene, base + "-cloud.xml"])
        quiet([bench, "scene", scene] + [base + suffix for suffix in (".xml", ".pov", ".dat")])
        seconds = {program: [] for program in commands}
        off = {}
        for program, command in commands.items():
            quiet(command)
            off[program] = difference(strahl, command[command.index("-o") + 1] if "-o" in command else base + "-pov.png",
                                      base + ".png", "mae")
            if off[program] > SAME_PICTURE[program]:
                sys.exit(f"pictures: {program} renders another {scene} (mean difference {off[program]:.3f})")
        for number in range(options.rounds):
            say(f"{scene}, round {number + 1} of {options.rounds}")
            for program, command in commands.items():
                seconds[program].append(wall_seconds(command))
        for program in commands:
            results.append({"scene": scene, "program": program, "seconds": seconds[program], "difference": off[program],
                            "ratio": statistics.median(theirs / ours for theirs, ours in
                                                       zip(seconds[program], seconds["strahl"]))})
    rows = [f"| {r['scene']} | {r['program']} | {statistics.median(r['seconds']):.2f} s | × {r['ratio']:.2f} |"
            f" {r['difference']:.4f} |" for r in results]
    print("\n".join(["| scene | program | wall clock | strahl is faster by | difference |", "|---|---|--:|--:|--:|"] + rows))
    return results


def paths(options, folder):
    if not options.mitsuba:
        sys.exit("pictures: --mitsuba PYTHON says which Python has mitsuba")
    strahl = options.build / "strahl"
    scene = str(folder / "cornell.xml")
    text = (HERE.parent / "scenes" / "cornell" / "cornell-box.xml").read_text(encoding="utf-8")
    text = text.replace('name="res" value="512"', 'name="res" value="256"').replace(
        '<film type="hdrfilm">', '<film type="hdrfilm"><rfilter type="box"/>').replace(
            '<sampler type="multijitter">', '<sampler type="independent">')
    pathlib.Path(scene).write_text(text, encoding="utf-8")
    if not all(change in text for change in ('value="256"', "rfilter", '<sampler type="independent">')):
        sys.exit("pictures: the Cornell box is no longer what this script changes")

    reference = options.reference or str(folder / "reference.exr")
    if not pathlib.Path(reference).exists():
        say(f"reference, {options.reference_spp} samples")
        peer = mitsuba(options.mitsuba, scene, options.reference_spp, options.variant, "multijitter")
        peer.render(999983, reference)
        peer.close()

    with contextlib.ExitStack() as stack:
        contenders = []

        def enter(contender):
            stack.callback(contender.close)
            contender.render(7919, str(folder / "warm.exr"))
            contenders.append(contender)

        for sampler in options.strahl_samplers.split(","):
            enter(Strahl(strahl, options.device, scene, options.spp, sampler))
        for sampler in options.samplers.split(","):
            enter(mitsuba(options.mitsuba, scene, options.spp, options.variant, sampler))
        if options.cycles:
            enter(cycles(options.cycles, scene, options.spp))
        if options.luxcore:
            enter(luxcore(options.luxcore, scene, options.spp))
        results = [{"program": contender.name, "seconds": [], "mse": []} for contender in contenders]
        for number in range(options.rounds):
            say(f"round {number + 1} of {options.rounds}")
            for contender, result in zip(contenders, results):
                picture = str(folder / "picture.exr")
                result["seconds"].append(contender.render(number, picture))
                result["mse"].append(difference(strahl, picture, reference, "mse"))
    # The reference's own error is in everybody's: of the least that there is, at most as much as it is longer.
    own = {r["program"]: statistics.fmean(r["mse"]) for r in results}
    for program, mse in own.items():
        if mse > SAME_NOISE * max(mse for name, mse in own.items() if name.startswith("strahl")):
            sys.exit(f"pictures: {program} renders another Cornell box (mean squared error {mse:.2e})")
    least = min(own.values())
    rows = []
    for result in results:
        mse = own[result["program"]] - least * options.spp / options.reference_spp
        seconds = statistics.median(result["seconds"])
        result.update({"efficiency": 1 / (mse * seconds), "paths_per_second": 256 * 256 * options.spp / seconds})
    first = results[0]
    for result in results:
        time_ratio = statistics.median(theirs / ours for theirs, ours in zip(result["seconds"], first["seconds"]))
        rows.append(f"| {result['program']} | {statistics.median(result['seconds']):.2f} s |"
                    f" {result['paths_per_second'] / 1e6:.2f} | × {time_ratio:.2f} | {own[result['program']]:.3e} |"
                    f" × {first['efficiency'] / result['efficiency']:.2f} |")
    print("\n".join([f"Cornell box, 256 x 256, {options.spp} samples, at most 8 segments:", "",
                     "| program | time | million paths/s | strahl is faster by | MSE | and more efficient by |",
                     "|---|--:|--:|--:|--:|--:|"] + rows))
    return results


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("-d", "--device", default="")
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--json")
    commands = parser.add_subparsers(required=True)
    whole = commands.add_parser("programs")
    whole.add_argument("--scenes", default="sphereflake-4,sphereflake-6")
    whole.set_defaults(run=programs)
    tracing = commands.add_parser("paths")
    tracing.add_argument("--mitsuba")
    tracing.add_argument("--cycles")
    tracing.add_argument("--luxcore")
    tracing.add_argument("--variant", default="llvm_ad_rgb")
    tracing.add_argument("--spp", type=int, default=256)
    tracing.add_argument("--samplers", default="independent,multijitter")
    tracing.add_argument("--strahl-samplers", default="sobol --no-error,sobol,independent",
                         help="the first is what the others are held against: like them, it tells no error")
    tracing.add_argument("--reference")
    tracing.add_argument("--reference-spp", type=int, default=8192)
    tracing.set_defaults(run=paths)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        try:
            results = options.run(options, pathlib.Path(folder))
        except Ended as error:
            sys.exit(f"pictures: {error}")
    if options.json:
        pathlib.Path(options.json).write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
