# SPDX-License-Identifier: MIT
"""Programs that trace paths, all asked alike: render(seed, path) writes a picture; the seconds of rendering alone."""
import json
import os
import pathlib
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
THREADS = str(os.cpu_count())


class Ended(Exception):
    """A peer that stopped answering; what it said of it stands on standard error."""


class Server:
    """One of the *_server.py in this folder, which waits for seeds."""

    def __init__(self, python, script, arguments, **environment):
        self.name = script
        self.process = subprocess.Popen([python, "-B", HERE / script, *map(str, arguments)], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, text=True, env=dict(os.environ) | environment)
        self.name = self.answer()

    def answer(self):
        line = self.process.stdout.readline()
        if not line:
            raise Ended(f"{self.name} ended; see above")
        return line.strip()

    def render(self, seed, path):
        self.process.stdin.write(f"{seed} {path}\n")
        self.process.stdin.flush()
        return float(self.answer())

    def close(self):
        self.process.stdin.close()
        self.process.wait()


def mitsuba(python, scene, spp, variant, sampler):
    # Dr.Jit's own search for LLVM stops at names that Debian does not use.
    libraries = sorted(pathlib.Path("/usr/lib").glob("*/libLLVM-1[5-9].so"), reverse=True)
    found = {} if "DRJIT_LIBLLVM_PATH" in os.environ or not libraries else {"DRJIT_LIBLLVM_PATH": str(libraries[0])}
    return Server(python, "mitsuba_server.py", [scene, spp, variant, sampler], **found)


def cycles(python, scene, spp):
    return Server(python, "cycles_server.py", [scene, spp, THREADS])


def luxcore(python, scene, spp):
    # It opens every OpenCL device even where it renders without, and PoCL 3.1 ends it with a double free.
    return Server(python, "luxcore_server.py", [scene, spp, THREADS], OCL_ICD_VENDORS=str(HERE))


class Strahl:
    """sampler: its name, and options of `strahl render` after it."""

    def __init__(self, program, device, scene, spp, sampler):
        self.name = f"strahl {sampler}"
        self.command = [str(program), scene, "-q", "--spp", str(spp)] + (["-d", device] if device else [])
        self.command += ["--sampler"] + sampler.split()

    def render(self, seed, path):
        stats = path + ".json"
        subprocess.run(self.command + ["--seed", str(seed), "-o", path, "--stats", stats], check=True,
                       stdout=subprocess.DEVNULL)
        with open(stats, encoding="utf-8") as file:
            seconds = json.load(file)["seconds"]
        return seconds["kernel"] + seconds["readback"]

    def close(self):
        pass
