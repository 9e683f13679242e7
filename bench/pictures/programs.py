# SPDX-License-Identifier: MIT
"""Whole programs by the wall clock, from start to finished PNG."""
import shutil
import statistics
import subprocess
import sys
import time

from path_tracers import THREADS
from reporting import difference, say

# Mean absolute difference of linear values; Tachyon writes them as they are, where sRGB is expected.
SAME_PICTURE = {"strahl": 0, "strahl, XML elements": 0, "POV-Ray": 0.001, "Tachyon": 0.05}


def quiet(command, **more):
    return subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, **more)


def wall_seconds(command):
    start = time.perf_counter()
    quiet(command)
    return time.perf_counter() - start


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
