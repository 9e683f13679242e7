# SPDX-License-Identifier: MIT
"""What all servers in this folder do: they say who they are, and then, for each line "SEED FILE.exr" on standard input,
render with that seed, print the seconds of rendering alone, and write the picture."""
import os
import sys

# Renderers write what they like to standard output, where the answers go: those keep it for themselves.
_answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
os.dup2(2, 1)


def serve(name, render):
    """render(seed, path): renders and writes; its seconds."""
    print(name, file=_answers, flush=True)
    for line in sys.stdin:
        seed, path = line.split()
        print(render(int(seed), path), file=_answers, flush=True)
