# SPDX-License-Identifier: MIT
"""Path tracers on many kinds of scenes: strahl in turns with Mitsuba 3, equal samples, depth and threads.

Each scene (scenes.py) answers four questions, all without compilation and the start of the process (strahl's seconds
are those of the kernels, of the way back and of the told error):
  paths         paths a second beside Mitsuba's, equal samples, neither telling its error
  4 samples     paths a second of pictures of 4 samples beside those of --spp
  --time        the same of pictures that end by --time, given the time that --spp samples took
  efficiency    1 / (mean squared error x seconds), strahl telling its error, beside Mitsuba's `independent` sampler
The errors are the spread of the seeds, and the means of both programs' pictures have to agree.
"""
import contextlib
import dataclasses
import pathlib
import statistics
import sys

from path_tracers import Strahl, mitsuba
from reporting import say
from scenes import SCENES
from seeds import Seeds, agreement

LEAST_TIME = 0.5  # Seconds for --time: the start of the process is part of them.


@dataclasses.dataclass
class Contender:
    program: object
    samples: int  # Of a pixel; 0: the program says.
    pictures: Seeds = dataclasses.field(default_factory=Seeds)
    seconds: list = dataclasses.field(default_factory=list)
    rates: list = dataclasses.field(default_factory=list)  # Paths a second.

    def take_turn(self, seed, picture, pixels):
        seconds = self.program.render(seed, picture)
        self.seconds.append(seconds)
        paths = pixels * pixels * self.samples if self.samples else self.program.paths
        self.rates.append(paths / seconds)
        self.pictures.add(picture)


def contenders_of(options, scene, folder, stack):
    """By name; each has rendered once, so that its program is compiled."""
    strahl = options.build / "strahl"
    warm = str(folder / "warm.pfm")

    def of_strahl(name, *arguments):
        # The scene's own sampler would be obeyed.
        program = Strahl(strahl, options.device, scene, ["--sampler", "sobol", *arguments], f"strahl {name}")
        program.render(7919, warm)
        return program

    told = of_strahl("told", "--spp", options.spp)
    told.render(7919, warm)  # The first had the program to build.
    seconds = max(told.total, LEAST_TIME)
    peer = mitsuba(options.mitsuba, scene, options.spp, options.variant, "independent")
    stack.callback(peer.close)
    peer.render(7919, warm)
    return {"plain": Contender(of_strahl("plain", "--spp", options.spp, "--no-error"), options.spp),
            "mitsuba": Contender(peer, options.spp), "told": Contender(told, options.spp),
            "few": Contender(of_strahl("few", "--spp", 4), 4),
            "timed": Contender(of_strahl("timed", "--time", f"{seconds:.3f}s"), 0)}


def ratios(above, below):
    return [a / b for a, b in zip(above, below)]


def race(options, folder, name, size):
    path = SCENES[name](folder, options.pixels, size)
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace('<rfilter type="box"/>', f'<rfilter type="{options.filter}"/>'), encoding="utf-8")
    scene = str(path)
    with contextlib.ExitStack() as stack:
        say(f"{name}: warming up")
        entries = contenders_of(options, scene, folder, stack)
        for number in range(options.rounds):
            say(f"{name}: round {number + 1} of {options.rounds}")
            for entry in entries.values():
                entry.take_turn(number, str(folder / "picture.pfm"), options.pixels)
    plain, peer, told, few, timed = (entries[key] for key in ("plain", "mitsuba", "told", "few", "timed"))
    off, fault = agreement(told.pictures, peer.pictures)
    if fault:
        fault = f"{peer.program.name} renders another {name}: {fault}, on the whole {100 * off:.2f} %"
    cost = {key: entries[key].pictures.squared_error() * statistics.median(entries[key].seconds)
            for key in ("told", "mitsuba")}
    answers = {"paths": ratios(plain.rates, peer.rates), "4 samples": ratios(few.rates, told.rates),
               "--time": ratios(timed.rates, told.rates)}
    return {"scene": name, "size": size, "pixels": options.pixels, "samples": options.spp, "mean_difference": off,
            "ratios": answers, "efficiency": cost["mitsuba"] / cost["told"], "fault": fault,
            "programs": {entry.program.name: {"seconds": entry.seconds, "paths_per_second": entry.rates,
                                              "mean_squared_error": entry.pictures.squared_error()}
                         for entry in entries.values()}}


def row(result):
    rates = [statistics.median(program["paths_per_second"]) / 1e6 for program in result["programs"].values()]
    spread = result["ratios"]["paths"]
    few, timed = (statistics.median(result["ratios"][key]) for key in ("4 samples", "--time"))
    name = result["scene"] + (f":{result['size']}" if result["size"] else "")
    return (f"| {name} | {rates[0]:.2f} | {rates[1]:.2f}"
            f" | **{statistics.median(spread):.2f}** ({min(spread):.2f} to {max(spread):.2f}) | {few:.2f} | {timed:.2f}"
            f" | {result['efficiency']:.2f} | {100 * result['mean_difference']:+.2f} %{' !' if result['fault'] else ''} |")


def chosen(text):
    """name or name:size, by commas; `all`."""
    wanted = []
    for part in (",".join(SCENES) if text == "all" else text).split(","):
        name, _, size = part.partition(":")
        if name not in SCENES or (size and not size.isdigit()):
            sys.exit(f"pictures: no scene {part}; there are {', '.join(SCENES)}, each also as NAME:SIZE")
        wanted.append((name, int(size or 0)))
    return wanted


def paths(options, folder):
    if not options.mitsuba:
        sys.exit("pictures: --mitsuba PYTHON says which Python has mitsuba")
    if options.rounds < 2:
        sys.exit("pictures: errors are told from two rounds or more")
    print(f"{options.pixels} x {options.pixels}, {options.spp} samples, {options.rounds} rounds; million paths a second:"
          "\n\n"
          "| scene | strahl | Mitsuba | × Mitsuba | 4 samples | --time | × efficiency | means differ |\n"
          "|---|--:|--:|--:|--:|--:|--:|--:|", flush=True)
    results = []
    for name, size in chosen(options.scenes):
        own = pathlib.Path(folder) / f"{name}-{size}"
        own.mkdir()
        results.append(race(options, own, name, size))
        print(row(results[-1]), flush=True)
    return results
