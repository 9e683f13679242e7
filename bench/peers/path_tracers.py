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
    """arguments: options of `strahl render`. After a picture: paths, how many were followed; total, the seconds of all."""

    # A --time that was missed (docs/cli.md) has its picture all the same.
    PICTURE_WRITTEN = (0, 6)

    def __init__(self, program, device, scene, arguments, name):
        self.name = name
        self.command = [str(program), scene, "-q", *map(str, arguments)] + (["-d", device] if device else [])
        self.paths = self.total = None

    def render(self, seed, path):
        stats = path + ".json"
        command = self.command + ["--seed", str(seed), "-o", path, "--stats", stats]
        code = subprocess.run(command, check=False, stdout=subprocess.DEVNULL).returncode
        if code not in self.PICTURE_WRITTEN:
            raise Ended(f"{self.name} ended with exit code {code}; see above")
        with open(stats, encoding="utf-8") as file:
            told = json.load(file)
        self.paths, self.total = told["rays"]["camera"], told["seconds"]["total"]
        return sum(told["seconds"][part] for part in ("kernel", "readback", "error"))

    def close(self):
        pass
