# SPDX-License-Identifier: MIT
"""Pictures of one program by several seeds: how noisy one is, and whether two programs' means agree.

The pixels' variance over the seeds is the squared error of one picture, whatever the truth, if no picture is wrong in
the mean; agreement() holds the means against each other for that.
"""
import array
import math
import sys

# A block's mean may be off by so many standard errors, and by this share of the picture's mean beside: the standard
# errors are themselves estimates, and renderers leave surfaces by different distances.
STANDARD_ERRORS = 6
SHARE = 0.01
BLOCKS = 8


def read_pfm(path):
    """Width, height and the values, three a pixel, from the bottom row up."""
    with open(path, "rb") as file:
        kind, size, scale = file.readline().strip(), file.readline().split(), float(file.readline())
        if kind != b"PF":
            raise ValueError(f"{path} is not a PFM file of three channels")
        values = array.array("f", file.read())
    if (scale < 0) != (sys.byteorder == "little"):
        values.byteswap()
    width, height = map(int, size)
    if len(values) != 3 * width * height:
        raise ValueError(f"{path} has {len(values)} values, not {3 * width * height}")
    return width, height, values


class Seeds:
    def __init__(self):
        self.size = None
        self.count = 0

    def add(self, path):
        width, height, values = read_pfm(path)
        if self.size is None:
            self.size = width, height
            self.sums = self.squares = array.array("d", bytes(8 * len(values)))
        if self.size != (width, height):
            raise ValueError(f"{path} measures {width} x {height}, not {self.size[0]} x {self.size[1]}")
        self.count += 1
        self.sums = array.array("d", (a + v for a, v in zip(self.sums, values)))
        self.squares = array.array("d", (a + v * v for a, v in zip(self.squares, values)))

    def variances(self):
        """Of one picture's values."""
        n = self.count
        return [max(q - s * s / n, 0) / (n - 1) for s, q in zip(self.sums, self.squares)]

    def squared_error(self):
        variances = self.variances()
        return sum(variances) / len(variances)

    def blocks(self, across):
        """For each channel of across x across blocks: their mean and its standard error."""
        width, height = self.size
        cells = 3 * across * across
        sums, variances, counts = [0.0] * cells, [0.0] * cells, [0] * cells
        of_pixel = [(y * across // height * across + x * across // width) * 3 for y in range(height) for x in range(width)]
        for index, (value, variance) in enumerate(zip(self.sums, self.variances())):
            cell = of_pixel[index // 3] + index % 3
            sums[cell] += value / self.count
            variances[cell] += variance / self.count
            counts[cell] += 1
        return [(s / n, math.sqrt(v) / n) for s, v, n in zip(sums, variances, counts)]


def agreement(ours, theirs):
    """The relative difference of two programs' mean pictures, and what is wrong with it: a line, or nothing."""
    if ours.size != theirs.size:
        return math.inf, f"pictures of {ours.size} and {theirs.size}"
    whole = [sum(mean for mean, _ in seeds.blocks(1)) / 3 for seeds in (ours, theirs)]
    worst = 0
    for across in (1, BLOCKS):
        for (a, error_a), (b, error_b) in zip(ours.blocks(across), theirs.blocks(across)):
            allowed = STANDARD_ERRORS * math.hypot(error_a, error_b) + SHARE * whole[1]
            worst = max(worst, abs(a - b) / allowed) if math.isfinite(a - b) else math.inf
    off = whole[0] / whole[1] - 1
    return off, f"means {worst:.1f} times as far apart as noise allows" if worst > 1 else ""
