#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The same pictures by strahl and by Mitsuba 3, within noise.

mitsuba_path.py STRAHL [RENDERS [SPP]]: needs Python's mitsuba and numpy (exit code 77 where they are not there). Each
renders scenes/path-box.xml RENDERS times (default 12) with different seeds. Blocks of 8 x 8 pixels are compared by
Welch's test (B. Welch, Biometrika 34, 1947); were the means the same, t squared would be n / (n - 2) on the mean with n
degrees of freedom. Fails where it is not, where one block is far off, or where the whole picture is.
"""
import pathlib
import subprocess
import sys
import tempfile

try:
    import mitsuba as mi
    import numpy as np
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

mi.set_variant("scalar_rgb")

SCENE = pathlib.Path(__file__).parent / "scenes" / "path-box.xml"
BLOCK = 8


def blocks(image):
    """Means over blocks, brightness alone."""
    height, width = image.shape[0] // BLOCK, image.shape[1] // BLOCK
    return image[..., :3].mean(axis=2).reshape(height, BLOCK, width, BLOCK).mean(axis=(1, 3))


def by_mitsuba(parameters, spp, seeds):
    scene = mi.load_file(str(SCENE), **parameters)
    return np.array([blocks(mi.render(scene, spp=spp, seed=1000 + seed).numpy()) for seed in seeds], float)


def by_strahl(strahl, parameters, spp, seeds, sampler):
    results = []
    with tempfile.TemporaryDirectory() as folder:
        picture = pathlib.Path(folder) / "picture.pfm"
        options = [part for name, value in parameters.items() for part in ("-D", f"{name}={value}")]
        for seed in seeds:
            subprocess.run([strahl, "render", str(SCENE), *options, "--spp", str(spp), "--seed", str(seed),
                            "--sampler", sampler, "-q", "-o", str(picture)], check=True, stderr=subprocess.DEVNULL)
            results.append(blocks(np.array(mi.Bitmap(str(picture)))))
    return np.array(results, float)


def compare(name, a, b, least=0.75):
    """least: of t^2 over its expectation; rare bright samples make the noise seem larger than it is."""
    n = len(a)
    rounding = (1e-5 * b.mean(axis=0)) ** 2  # Blocks that show nothing but a lamp.
    va, vb = a.var(axis=0, ddof=1) / n + rounding, b.var(axis=0, ddof=1) / n + rounding
    t = (a.mean(axis=0) - b.mean(axis=0)) / np.sqrt(va + vb)
    freedom = (va + vb) ** 2 / (va ** 2 / (n - 1) + vb ** 2 / (n - 1))
    expected = (freedom / (freedom - 2)).mean()
    whole = (a.mean(axis=(1, 2)), b.mean(axis=(1, 2)))
    z = (whole[0].mean() - whole[1].mean()) / np.sqrt((whole[0].var(ddof=1) + whole[1].var(ddof=1)) / n)
    ratio = (t ** 2).mean() / expected
    good = least < ratio < 1.3 and np.abs(t).max() < 6.5 and abs(z) < 4.5
    print(f"{name:28} blocks {t.size}, t^2 over its expectation {ratio:.3f}, largest |t| {np.abs(t).max():.2f}, "
          f"whole {whole[0].mean():.5f} / {whole[1].mean():.5f}, t {z:+.2f}: {'same' if good else 'DIFFERENT'}")
    return good


def main():
    strahl = sys.argv[1]
    renders = int(sys.argv[2]) if len(sys.argv) > 2 else 12
    spp = int(sys.argv[3]) if len(sys.argv) > 3 else 16
    good = True
    for parameters in ({"integrator": "path", "depth": "6"}, {"integrator": "path", "depth": "-1"}):
        reference = by_mitsuba(parameters, spp, range(renders))
        for sampler in ("independent", "sobol"):
            ours = by_strahl(strahl, parameters, spp, range(renders), sampler)
            good &= compare(f"{parameters['integrator']} {parameters['depth']}, {sampler}", ours, reference)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
