# SPDX-License-Identifier: MIT
"""What is missing where paths end early, and what they cost: --max-depth against no limit, with the same samples."""
from plot import plot
from program import scientific, table

SCENES = {"Cornell box": ["scenes/cornell/cornell-box.xml", "-D", "res=128"],
          "mirrors": ["scenes/materials/conductor.xml", "--integrator", "path", "-D", "res=128"],
          "light of a sphere": ["scenes/lights/sphere.xml", "-D", "res=128"]}
DEPTHS = [1, 2, 3, 4, 6, 8, 12, 16]
SPP = 64


def measure(strahl):
    results = []
    for name, (scene, *options) in SCENES.items():
        options += ["--spp", str(SPP), "--sampler", "sobol"]
        seconds = strahl.timed(scene, {str(depth): options + ["--max-depth", str(depth)] for depth in [-1] + DEPTHS})
        for depth in DEPTHS:
            error = strahl.compare(f"{depth}.exr", "-1.exr", "rmse", "ssim", "flip")
            results.append({"scene": name, "depth": depth, "ratio": seconds[str(depth)] / seconds["-1"], **error})
    return results


def show(results):
    rows = [[r["scene"], r["depth"], scientific(r["rmse"]), f"{r['ssim']:.4f}", f"{r['flip']:.4f}", f"× {r['ratio']:.2f}"]
            for r in results]
    series = {name: [(r["depth"], r["rmse"], f"{name}, depth {r['depth']}: {r['rmse']:.1e} in × {r['ratio']:.2f}")
                     for r in results if r["scene"] == name] for name in SCENES}
    picture = plot("What a limit of depth leaves out", "max_depth", "RMSE to no limit, same samples", series, log_x=False)
    return {"depth.svg": picture}, table(["scene", "max_depth", "RMSE", "SSIM", "FLIP", "time of no limit"], rows)
