#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the grids of these scenes beside itself: smoke.vol and flame.vol, bytes that are 255 at their densest.

With a size it writes cloud.vol of so many texels a side into the working folder instead, as floats:

    scenes/media/make_grids.py 512
"""
import array
import math
import pathlib
import random
import struct
import sys


def noise(seed, cells):
    """Smooth random values over space, `cells` of them a unit."""
    source = random.Random(seed)
    table = [source.random() for _ in range(4096)]

    def at(i, j, k):
        return table[(i * 73856093 ^ j * 19349663 ^ k * 83492791) & 4095]

    def value(x, y, z):
        x, y, z = x * cells, y * cells, z * cells
        i, j, k = math.floor(x), math.floor(y), math.floor(z)
        u, v, w = (f * f * (3 - 2 * f) for f in (x - i, y - j, z - k))
        total = 0
        for corner in range(8):
            a, b, c = corner & 1, corner >> 1 & 1, corner >> 2
            total += (u if a else 1 - u) * (v if b else 1 - v) * (w if c else 1 - w) * at(i + a, j + b, k + c)
        return total

    return value


def turbulence(seed):
    layers = [(2.0 ** -n, noise(seed + n, 4 * 2**n)) for n in range(4)]
    return lambda x, y, z: sum(a * (f(x, y, z) - 0.5) for a, f in layers)


def write(path, size, density):
    width, height, depth = size
    values = [
        max(0.0, density((i + 0.5) / width, (j + 0.5) / height, (k + 0.5) / depth))
        for k in range(depth)
        for j in range(height)
        for i in range(width)
    ]
    most = max(values)
    header = b"VOL\x03" + struct.pack("<5i6f", 3, width, height, depth, 1, 0, 0, 0, 1, 1, 1)
    path.write_bytes(header + bytes(round(255 * v / most) for v in values))


def smoke():
    """A plume that widens as it rises along y and leans towards +x."""
    billow = turbulence(3)

    def density(x, y, z):
        x += 0.12 * billow(x, y + 5, z) - 0.25 * y * y
        z += 0.12 * billow(x + 9, y, z)
        radius = 0.05 + 0.2 * y
        away = math.hypot(x - 0.35, z - 0.5) / radius
        return (1 - away + 0.9 * billow(x, y, z)) * (1 - y) ** 0.5 * min(1, 30 * y) / (0.25 + y)

    return density


def flame():
    """A drop along y, hollow at the wick."""

    def density(x, y, z):
        radius = 0.42 * math.sqrt(max(0.0, y)) * (1 - y) ** 0.9 * 1.7
        away = math.hypot(x - 0.5, z - 0.5)
        core = max(0.0, 1 - y / 0.25) * max(0.0, 1 - away / 0.15)
        return (1 - (away / max(radius, 1e-3)) ** 2) * (1 - 0.8 * core)

    return density


def write_cloud(path, side):
    """A ball of waves, row by row: 512 texels a side take half a minute."""
    wave = [0.25 * math.cos(14 * (i + 0.5) / side) - 3 * ((i + 0.5) / side - 0.5) ** 2 for i in range(side)]
    with open(path, "wb") as file:
        file.write(b"VOL\x03" + struct.pack("<5i6f", 1, side, side, side, 1, 0, 0, 0, 1, 1, 1))
        for z in wave:
            for y in wave:
                rest = 0.4 + y + z
                row = [rest + x for x in wave]
                file.write(array.array("f", [v if v > 0 else 0 for v in row]).tobytes())


here = pathlib.Path(__file__).parent
if len(sys.argv) == 1:
    write(here / "smoke.vol", (40, 64, 32), smoke())
    write(here / "flame.vol", (24, 48, 24), flame())
elif len(sys.argv) == 2 and sys.argv[1].isdigit() and int(sys.argv[1]) > 0:
    write_cloud("cloud.vol", int(sys.argv[1]))
else:
    sys.exit(__doc__)
