# SPDX-License-Identifier: MIT
"""The Cornell box by several path tracers: efficiency 1 / (mean squared error x seconds), without compilation, against a
long picture by Mitsuba 3."""
import contextlib
import pathlib
import statistics
import sys

from path_tracers import Strahl, cycles, luxcore, mitsuba
from scenes import cornell
from reporting import difference, say

# Times strahl's largest mean squared error: more is another picture, not noise.
SAME_NOISE = 4


def peers(options, folder):
    if not options.mitsuba:
        sys.exit("pictures: --mitsuba PYTHON says which Python has mitsuba")
    strahl = options.build / "strahl"
    scene = str(cornell(folder, 256, 0))
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
            arguments = ["--spp", options.spp, "--sampler", *sampler.split()]
            enter(Strahl(strahl, options.device, scene, arguments, f"strahl {sampler}"))
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
