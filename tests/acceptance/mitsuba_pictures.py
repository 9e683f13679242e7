#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Pictures of every material, light, mode of textures, camera and medium against Mitsuba 3.9.1.

mitsuba_pictures.py STRAHL [NAME ...]     renders the scenes of pictures/ (or those named) and compares them with
                                          mitsuba_pictures.csv; needs nothing but Python
mitsuba_pictures.py --write [NAME ...]    writes the table anew (or the lines of those named), by Mitsuba
mitsuba_pictures.py --check [NAME ...]    whether Mitsuba still has the table's values; exit status 77 where it is absent

The table has the mean radiance of blocks of 8 x 8 pixels by 16 renders of 256 samples, and its standard error. Strahl
makes 8 of 128. Each block and channel is compared by Welch's test (B. Welch, Biometrika 34, 1947), all together at 0.01
after Sidak.
"""
import math
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.path.insert(1, str(pathlib.Path(__file__).parents[2] / "bench" / "pictures"))
from pictures import frames, lights, materials
from seeds import read_pfm

SCENES = {**materials.PICTURES, **lights.PICTURES, **frames.PICTURES}
TABLE = pathlib.Path(__file__).with_suffix(".csv")
BLOCK = 8
RENDERS, SAMPLES = 8, 128
MITSUBA_RENDERS, MITSUBA_SAMPLES = 16, 256
LEVEL = 0.01
# Of the value, as a deviation: digits of the table; what Mitsuba tabulates and strahl fits.
ROUNDING = 2e-4
TABULATED = {"roughplastic": 3e-3, "spot": 1e-3}


def beta_fraction(x, a, b):
    """Continued fraction of the incomplete beta function by Lentz (W. Press et al., "Numerical Recipes", 6.4)."""
    c, d = 1.0, 1 - (a + b) * x / (a + 1)
    d = 1 / (d if abs(d) > 1e-300 else 1e-300)
    whole = d
    for m in range(1, 300):
        for step in (
            m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m)),
            -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1)),
        ):
            d = 1 + step * d
            d = 1 / (d if abs(d) > 1e-300 else 1e-300)
            c = 1 + step / (c if abs(c) > 1e-300 else 1e-300)
            whole *= c * d
        if abs(c * d - 1) < 1e-14:
            break
    return whole


def two_sided(t, freedom):
    """Chance of |T| > |t| of Student's distribution."""
    a, b, x = freedom / 2, 0.5, freedom / (freedom + t * t)
    if x <= 0 or x >= 1:
        return float(x >= 1)
    front = math.exp(math.lgamma(a + b) - math.lgamma(a) - math.lgamma(b) + a * math.log(x) + b * math.log1p(-x))
    return front * beta_fraction(x, a, b) / a if x < (a + 1) / (a + b + 2) else 1 - front * beta_fraction(1 - x, b, a) / b


def welch(ours, theirs, freedom_of_theirs, slack):
    """Chance of such a difference or a larger one; ours and theirs: mean and standard error."""
    squares = ours[1] ** 2, theirs[1] ** 2
    whole = sum(squares)
    fixed = (slack * theirs[0]) ** 2 + 1e-14
    if whole == 0:
        return 1.0 if abs(ours[0] - theirs[0]) < 4 * math.sqrt(fixed) else 0.0
    freedom = whole**2 / (squares[0] ** 2 / (RENDERS - 1) + squares[1] ** 2 / freedom_of_theirs)
    return two_sided((ours[0] - theirs[0]) / math.sqrt(whole + fixed), freedom)


def picture_rows(path):
    """Rows from the top, of r g b in turn."""
    width, height, values = read_pfm(path)
    return [values[3 * width * y : 3 * width * (y + 1)] for y in reversed(range(height))]


def blocks(rows):
    """Means, block by block, of r g b."""
    columns = len(rows[0]) // 3
    for top in range(0, len(rows), BLOCK):
        for left in range(0, columns, BLOCK):
            for channel in range(3):
                part = [row[3 * x + channel] for row in rows[top : top + BLOCK] for x in range(left, left + BLOCK)]
                yield math.fsum(part) / len(part)


def mean_and_error(renders):
    """Of each block, over renders with different seeds."""
    return [(statistics.fmean(of), statistics.stdev(of) / math.sqrt(len(of))) for of in zip(*renders)]


def by_strahl(strahl, text, seed, folder):
    scene, picture = folder / "scene.xml", folder / "picture.pfm"
    scene.write_text(text)
    command = [strahl, "render", scene, "--spp", SAMPLES, "--frames", RENDERS, "--time", "1h", "--seed", seed]
    done = subprocess.run([str(part) for part in [*command, "-q", "-o", picture]], capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(done.args)}\n{done.stderr}")
    return mean_and_error([list(blocks(picture_rows(folder / f"picture.{k:04}.pfm"))) for k in range(1, RENDERS + 1)])


def by_mitsuba(text):
    import mitsuba as mi

    scene = mi.load_string(text)
    renders = []
    for seed in range(MITSUBA_RENDERS):
        image = mi.render(scene, spp=MITSUBA_SAMPLES, seed=1000 + seed).numpy()[..., :3]
        renders.append(list(blocks([list(row.ravel()) for row in image.astype(float)])))
    return mean_and_error(renders)


def read_table():
    """Scene -> mean and standard error of each block and channel."""
    table = {}
    for line in TABLE.read_text().splitlines()[1:]:
        name, *values = line.split(",")
        numbers = [float(value) for value in values]
        table.setdefault(name, []).extend(zip(numbers[:3], numbers[3:]))
    return table


def write_table(table):
    lines = ["scene (a block a line),r,g,b,standard error of r,g,b"]
    for name in SCENES:
        values = table.get(name, [])
        for i in range(0, len(values), 3):
            block = values[i : i + 3]
            lines.append(",".join([name, *(f"{v:.5g}" for v, _ in block), *(f"{e:.2g}" for _, e in block)]))
    TABLE.write_text("\n".join(lines) + "\n")


def compare(found, table, names):
    """Whether no block of any scene is further off than chance has it. found: name and values of each, as they come."""
    freedom = MITSUBA_RENDERS - 1
    count = sum(len(table.get(name, [])) for name in names)
    least = -math.expm1(math.log1p(-LEVEL) / max(count, 1))
    good = True
    for name, values in found:
        slack = max([ROUNDING, *(value for key, value in TABULATED.items() if name.startswith(key))])
        expected = table.get(name, [])
        if not expected or len(values) != len(expected):
            raise SystemExit(f"{name}: {len(values)} values, {len(expected)} in {TABLE.name}")
        chances = [welch(a, b, freedom, slack) for a, b in zip(values, expected)]
        worst = min(range(len(chances)), key=chances.__getitem__)
        whole = math.fsum(v for v, _ in values) / max(math.fsum(v for v, _ in expected), 1e-30)
        good &= chances[worst] >= least
        at = f"block {worst // 3}: {values[worst][0]:.5g}, Mitsuba {expected[worst][0]:.5g}"
        word = "same" if chances[worst] >= least else "DIFFERENT"
        print(f"{name:24} least p {chances[worst]:.2g} ({at}), whole {whole:.4f}: {word}", flush=True)
    word = "all agree" if good else "DIFFERENT"
    print(f"{count} values of {len(names)} pictures, p >= {least:.2g}: {word}")
    return good


def main():
    words = sys.argv[1:]
    chosen = words[1:] or list(SCENES)
    if words[0] in ("--write", "--check"):
        try:
            import mitsuba as mi

            mi.set_variant("llvm_ad_rgb" if os.environ.get("DRJIT_LIBLLVM_PATH") else "scalar_rgb")
        except ImportError as missing:
            print(f"skipped: {missing}")
            return 77
        table = read_table() if TABLE.exists() else {}
        found = ((name, by_mitsuba(SCENES[name])) for name in chosen)
        if words[0] == "--check":
            return 0 if compare(found, table, chosen) else 1
        for name, values in found:
            table[name] = values
            write_table(table)
        return 0
    with tempfile.TemporaryDirectory() as folder:
        found = ((name, by_strahl(words[0], SCENES[name], 1, pathlib.Path(folder))) for name in chosen)
        return 0 if compare(found, read_table(), chosen) else 1


if __name__ == "__main__":
    sys.exit(main())
