#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""`strahl compare` beside others' metrics, on 20 pairs of pictures.

metrics_peers.py STRAHL [--print]: needs Python's scikit-image and flip-evaluator (exit code 77 where they are not
there). MSE (relative), PSNR and SSIM must agree with scikit-image to 1e-6, FLIP and HDR-FLIP with the authors' program
to 1e-3.
--print: no STRAHL; the peers' values of the fixed pairs, which tests/image/test_metric_references.cpp expects.
"""
import importlib.metadata
import json
import math
import pathlib
import subprocess
import sys
import tempfile

try:
    import flip_evaluator
    import numpy as np
    from PIL import Image
    from skimage import metrics
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"
TOLERANCES = {"mse": 1e-6, "psnr": 1e-6, "ssim": 1e-6, "flip": 1e-3, "hdrflip": 1e-3}


def write_pfm(path, picture):
    kind = "PF" if picture.ndim == 3 else "Pf"
    header = f"{kind}\n{picture.shape[1]} {picture.shape[0]}\n-1.0\n".encode()
    path.write_bytes(header + np.flipud(picture).astype("<f4").tobytes())


def read_pfm(path):
    kind, size, scale, data = path.read_bytes().split(b"\n", 3)
    assert kind == b"PF" and scale == b"-1.0"
    width, height = map(int, size.split())
    return np.flipud(np.frombuffer(data, "<f4").reshape(height, width, 3)).copy()


def encoded(linear):
    clamped = np.clip(linear.astype(np.float64), 0, 1)
    return np.where(clamped <= 0.0031308, 12.92 * clamped, 1.055 * clamped ** (1 / 2.4) - 0.055)


def decoded(code):
    return np.where(code <= 0.04045, code / 12.92, ((code + 0.055) / 1.055) ** 2.4)


def colour(picture):
    return np.ascontiguousarray(np.repeat(picture[..., None], 3, axis=2) if picture.ndim == 2 else picture, np.float32)


def peers(a, reference, ppd=None):
    """a, reference: float32 linear, height x width (x 3)."""
    codes = encoded(a), encoded(reference)
    parameters = {} if ppd is None else {"ppd": ppd}
    equal = np.array_equal(*codes)
    values = {
        "mse": metrics.mean_squared_error(a.astype(np.float64), reference.astype(np.float64)),
        "psnr": math.inf if equal else metrics.peak_signal_noise_ratio(codes[1], codes[0], data_range=1),
        "flip": flip_evaluator.evaluate(colour(codes[1]), colour(codes[0]), "LDR", applyMagma=False,
                                        parameters=dict(parameters))[1],
        "hdrflip": flip_evaluator.evaluate(colour(np.maximum(reference, 0)), colour(np.maximum(a, 0)), "HDR",
                                           applyMagma=False, parameters=dict(parameters))[1],
    }
    if min(a.shape[:2]) >= 11:
        values["ssim"] = metrics.structural_similarity(
            codes[0], codes[1], gaussian_weights=True, sigma=1.5, use_sample_covariance=False, data_range=1,
            channel_axis=2 if a.ndim == 3 else None)
    return {name: float(value) for name, value in values.items()}


def fixed_pairs():
    """Multiples of 2^-13, so that the same pictures are easily made elsewhere: 48 x 32 pixels."""
    def ramp(x, y, c):
        return (3 * x + 5 * y + 11 * c) % 48 / 64

    y, x, c = np.mgrid[:32, :48, :3]
    speckle = (7 * x * x + 13 * y * y + 5 * x * y + 17 * c) % 31 / 128
    scale = 2.0 ** (x % 7)
    return {
        "noise": (ramp(x, y, c) + speckle, ramp(x, y, c)),
        "shift": (ramp(x + 1, y, c), ramp(x, y, c)),
        "range": ((ramp(x, y, c) + speckle) * scale, ramp(x, y, c) * scale),
        "dark": ((ramp(x, y, c) + speckle) / 64, ramp(x, y, c) / 64),
        "flat": (np.full(x.shape, 0.5), np.full(x.shape, 0.25)),
    }


def drawn_pairs():
    random = np.random.default_rng(20040413)
    y, x = np.mgrid[:96, :128]
    soft = np.stack([0.5 + 0.4 * np.sin(x / 9 + c) * np.cos(y / 13 - c) for c in range(3)], axis=2)
    wide = np.exp(2 * soft * random.normal(1, 0.6, soft.shape))
    blurred = (soft + np.roll(soft, 1, 0) + np.roll(soft, 1, 1) + np.roll(soft, 2, 1)) / 4
    board = np.repeat(((x // 8 + y // 8) % 2)[..., None], 3, axis=2).astype(float)
    firefly = soft.copy()
    firefly[40, 60] = 5000
    lamp = np.zeros(soft.shape)
    lamp[10:20, 30:60] = (12, 9, 4)
    return {
        "gaussian noise": (soft + random.normal(0, 0.05, soft.shape), soft),
        "blur": (blurred, soft),
        "ramp, a little brighter": (1.05 * soft ** 0.95, soft),
        "equal": (soft, soft),
        "black and white": (np.zeros((16, 21, 3)), np.ones((16, 21, 3))),
        "checkerboard, inverted": (1 - board, board),
        "saturated colours, turned": (np.roll(board * (1, 0.5, 0), 1, axis=2), board * (1, 0.5, 0)),
        "high dynamic range": (wide * random.uniform(0.5, 1.5, wide.shape), wide),
        "firefly": (firefly, soft),
        "mostly black": (lamp * random.uniform(0.8, 1.2, lamp.shape) + 0.001, lamp),
        "11 x 11": (wide[:11, :11] * 0.9, wide[:11, :11]),
        "131 x 13, below zero": (random.normal(0.2, 0.3, (13, 131, 3)), random.uniform(0, 0.4, (13, 131, 3))),
        "one channel": (wide[:, :77, 0] * 1.3, wide[:, :77, 0]),
    }


def rendered_pair(strahl, folder, scene, settings, few, many):
    pictures = []
    for spp in (few, many):
        path = folder / f"{spp}.pfm"
        subprocess.run([strahl, "render", SCENES / scene, "-q", *settings, "--spp", str(spp), "-o", path], check=True)
        pictures.append(read_pfm(path))
    return tuple(pictures)


def main():
    if sys.argv[1:] == ["--print"]:
        print(", ".join(f"{name} {importlib.metadata.version(name)}" for name in ("scikit-image", "flip-evaluator")))
        for name, (a, reference) in fixed_pairs().items():
            print(name, json.dumps(peers(a.astype(np.float32), reference.astype(np.float32))))
        return 0

    strahl = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        pairs = fixed_pairs() | drawn_pairs()
        pairs["Cornell box, 2 and 64 samples"] = rendered_pair(strahl, folder, "cornell/cornell-box.xml",
                                                               ["-D", "res=128"], 2, 64)
        codes = [np.round(255 * encoded(picture)).astype(np.uint8) for picture in pairs["gaussian noise"]]
        pairs["8 bits"] = tuple(decoded(code / 255) for code in codes)
        assert len(pairs) == 20

        worst = dict.fromkeys(TOLERANCES, 0.0)
        wrong = 0
        for title, pair in pairs.items():
            a, reference = (picture.astype(np.float32) for picture in pair)
            files = [folder / "a.pfm", folder / "reference.pfm"]
            if title == "8 bits":
                files = [folder / "a.png", folder / "reference.png"]
                for file, code in zip(files, codes):
                    Image.fromarray(code).save(file)
            else:
                for file, picture in zip(files, (a, reference)):
                    write_pfm(file, picture)
            ppd = 30 if title == "blur" else None
            more = [] if ppd is None else ["--ppd", str(ppd)]
            ours = json.loads(subprocess.run([strahl, "compare", *files, "--json", *more], check=True,
                                             capture_output=True, text=True).stdout)
            for metric, theirs in peers(a, reference, ppd).items():
                value = math.inf if ours[metric] is None else ours[metric]
                off = 0 if value == theirs else abs(value - theirs) / (theirs if metric == "mse" else 1)
                worst[metric] = max(worst[metric], off)
                if not off <= TOLERANCES[metric]:
                    wrong += 1
                    print(f"{title}: {metric} is {value}, the peer's {theirs}")
        print(f"{len(pairs)} pairs; largest deviations: " + ", ".join(f"{m} {off:.1e}" for m, off in worst.items()))
        return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
