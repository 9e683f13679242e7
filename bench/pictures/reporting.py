# SPDX-License-Identifier: MIT
"""Progress on standard error, and differences of pictures by `strahl compare`."""
import subprocess
import sys


def difference(strahl, picture, reference, metric):
    output = subprocess.run([strahl, "compare", picture, reference, "--metric", metric], check=True,
                            capture_output=True, text=True).stdout
    return float(output.split()[1])


def say(line):
    print(f"pictures: {line}", file=sys.stderr)
