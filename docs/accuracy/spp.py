# SPDX-License-Identifier: MIT
"""Error against samples per pixel, by sampler: direct light, ambient occlusion and all light."""
import math

from plot import plot
from program import scientific, table

SCENES = {"direct": ["scenes/lights/rectangle.xml", "--integrator", "direct"],
          "ao": ["scenes/lights/stage.xml"],
          "path": ["scenes/cornell/cornell-box.xml"]}
SAMPLERS = ["independent", "sobol"]
COUNTS = [1, 4, 16, 64, 256]
SEEDS = 3
REFERENCE = 4096


def measure(strahl):
    results = []
    for name, (scene, *options) in SCENES.items():
        options += ["-D", "res=64"]
        strahl.render(scene, "reference.exr", *options, "--spp", REFERENCE, "--sampler", "sobol", "--seed", 99)
        for sampler in SAMPLERS:
            for spp in COUNTS:
                errors = []
                for seed in range(SEEDS):
                    strahl.render(scene, "picture.exr", *options, "--spp", spp, "--sampler", sampler, "--seed", seed)
                    errors.append(strahl.compare("picture.exr", "reference.exr", "mse")["mse"])
                results.append({"scene": name, "sampler": sampler, "spp": spp, "rmse": math.sqrt(sum(errors) / SEEDS)})
    return results


def slope(points):
    """Of the straight line through log error over log samples."""
    x, y = ([math.log(p[i]) for p in points] for i in (0, 1))
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)


def show(results):
    series, rows = {}, []
    for name in SCENES:
        for sampler in SAMPLERS:
            points = [(r["spp"], r["rmse"]) for r in results if (r["scene"], r["sampler"]) == (name, sampler)]
            series[f"{name}, {sampler}"] = points
            rows.append([name, f"`{sampler}`", *(scientific(error) for _, error in points), f"{slope(points):.2f}".replace("-", "−")])
    picture = plot("Error and samples", "samples per pixel", "RMSE to a long picture", series)
    return {"spp.svg": picture}, table(["light", "sampler", *(f"{spp} spp" for spp in COUNTS), "slope"], rows,
                                       ["---", "---"] + ["--:"] * (len(COUNTS) + 1))
