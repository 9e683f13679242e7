# SPDX-License-Identifier: MIT
"""Files of 8 and of 16 bits beside floats: how long it pays to sample. Errors of sRGB values from 0 to 1, from psnr."""
from plot import plot
from program import scientific, table

SCENES = {"lecture/lit": ["scenes/lecture/lit.xml", "-D", "res=64"],
          "Cornell box": ["scenes/cornell/cornell-box.xml", "-D", "res=64"]}
COUNTS = [1, 4, 16, 64, 256, 1024]
REFERENCE = 4096
KINDS = {"float": ("picture.exr", []), "16 bits": ("picture16.png", ["--png-bits", "16"]),
         "8 bits": ("picture8.png", ["--png-bits", "8"])}


def rmse(psnr):
    return 0 if psnr is None else 10 ** (-psnr / 20)


def measure(strahl):
    results = []
    for name, (scene, *options) in SCENES.items():
        options += ["--sampler", "sobol"]
        strahl.render(scene, "reference.exr", *options, "--spp", REFERENCE, "--seed", 99)
        for spp in COUNTS:
            result = {"scene": name, "spp": spp}
            for kind, (file, more) in KINDS.items():
                strahl.render(scene, file, *options, *more, "--spp", spp)
                result[kind] = rmse(strahl.compare(file, "reference.exr", "psnr")["psnr"])
                result[f"{kind}: rounding"] = rmse(strahl.compare(file, "picture.exr", "psnr")["psnr"])
            results.append(result)
    return results


def show(results):
    rows = [[r["scene"], r["spp"], *(scientific(r[kind]) for kind in KINDS), scientific(r["8 bits: rounding"]),
             scientific(r["16 bits: rounding"])] for r in results]
    series = {f"{name}, {kind}": [(r["spp"], r[kind]) for r in results if r["scene"] == name]
              for name in SCENES for kind in KINDS}
    picture = plot("What a file's bits hide", "samples per pixel", "RMSE of sRGB values to a long picture", series)
    return {"bits.svg": picture}, table(["scene", "spp", *KINDS, "rounding to 8", "to 16"], rows)
