# SPDX-License-Identifier: MIT
"""strahl as the exhibits run it: pictures, how far they are from each other, and times."""
import copy
import json
import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Strahl:
    def __init__(self, program, device, rounds, folder):
        self.program, self.device, self.rounds, self.folder = program, ["-d", device] if device else [], rounds, folder
        self.device_name = None
        self.environment = dict(os.environ)

    def elsewhere(self, environment):
        """The same with further variables of the environment."""
        other = copy.copy(self)
        other.environment = self.environment | environment
        return other

    def run(self, *words, codes=(0,)):
        done = subprocess.run([self.program, *map(str, words)], capture_output=True, text=True, cwd=ROOT, check=False,
                              env=self.environment)
        if done.returncode not in codes:
            raise SystemExit(f"measure: strahl {' '.join(map(str, words))}: {done.stderr}")
        return done.stdout

    def path(self, name):
        return self.folder / name

    def render(self, scene, name, *options):
        """Renders into the file `name`; its --stats."""
        stats = json.loads(self.run("render", scene, "-q", "--no-progress", *self.device, "-o", self.path(name),
                                    "--stats", "-", *options))
        self.device_name = stats["device"]
        return stats

    def timed(self, scene, settings):
        """settings: {name: options}, each rendered into name.exr. The least kernel seconds of the rounds, in turns: what
        else a machine does can only add to them."""
        least = {}
        for _ in range(self.rounds):
            for name, options in settings.items():
                seconds = self.render(scene, f"{name}.exr", *options)["seconds"]["kernel"]
                least[name] = min(seconds, least.get(name, seconds))
        return least

    def compare(self, a, b, *metrics):
        return json.loads(self.run("compare", self.path(a), self.path(b), "--json", "--metric", ",".join(metrics)))

    def selftest(self, *options):
        """Its --json; broken promises are what is looked for."""
        report = json.loads(self.run("selftest", *self.device, "--no-progress", "--json", "-", *options, codes=(0, 7)))
        self.device_name = report["device"]
        return report


def scientific(value):
    """3.2 · 10⁻⁴ as documents write it."""
    if value == 0:
        return "0"
    mantissa, power = f"{value:.1e}".split("e")
    return f"{mantissa} · 10{str(int(power)).translate(str.maketrans('-0123456789', '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'))}"


def table(head, rows, align=None):
    align = align or ["---"] + ["--:"] * (len(head) - 1)
    return "\n".join("| " + " | ".join(map(str, row)) + " |" for row in [head, align, *rows])
