# SPDX-License-Identifier: MIT
"""The four tiers on easy and on hard scenes: what a digit costs, and what it saves."""
import math

from plot import plot
from program import scientific, table

EASY = {"lecture/lit": ["-D", "res=160"], "materials/conductor": ["-D", "res=160"],
        "mesh/torus-and-icosphere": ["-D", "res=160"], "cornell/cornell-box": ["-D", "res=96"]}
HARD = {f"accuracy/{name}": ["-D", "res=128"] for name in
        ("planet-horizon", "far-pebble", "concentric-shells", "million-unit-offset-room", "needle-mesh")}
TIERS = ["fast", "stable", "robust", "double"]
SPP = 16


def measure(strahl):
    results = []
    for kind, scenes in (("easy", EASY), ("hard", HARD)):
        for name, options in scenes.items():
            scene = f"scenes/{name}.xml"
            options = options + ["--spp", str(SPP), "--sampler", "independent"]
            seconds = strahl.timed(scene, {tier: options + ["--precision", tier] for tier in TIERS})
            strahl.render(scene, "other.exr", *options, "--precision", "double", "--seed", "1")
            noise = strahl.compare("other.exr", "double.exr", "rmse")["rmse"] / math.sqrt(2)
            for tier in TIERS:
                error = strahl.compare(f"{tier}.exr", "double.exr", "rmse", "flip")
                results.append({"scene": name, "kind": kind, "tier": tier, "seconds": seconds[tier],
                                "ratio": seconds[tier] / seconds["fast"], "noise": noise, **error})
    return results


def samples(result):
    """Of the samples per pixel whose noise is as large as the tier's error."""
    if result["rmse"] == 0 or result["noise"] == 0:
        return "–"
    count = SPP * (result["noise"] / result["rmse"]) ** 2
    return scientific(count) if count >= 1 else "1"


def show(results):
    rows = [[r["scene"], f"`{r['tier']}`", f"{1e3 * r['seconds']:.1f} ms", f"× {r['ratio']:.2f}", scientific(r["rmse"]),
             f"{r['flip']:.4f}", samples(r)] for r in results if r["tier"] != "double"]
    doubles = [r["ratio"] for r in results if r["tier"] == "double"]
    series = {f"{tier}, {kind}": [(r["ratio"], r["rmse"], f"{r['scene']}, {tier}: × {r['ratio']:.2f}, {r['rmse']:.1e}")
                                  for r in results if r["tier"] == tier and r["kind"] == kind]
              for kind in ("easy", "hard") for tier in TIERS[:3]}
    styles = {f"{tier}, {kind}": (k, t) for k, kind in enumerate(("easy", "hard")) for t, tier in enumerate(TIERS[:3])}
    picture = plot("What a digit costs: each tier against double", "kernel time, fast = 1", "RMSE to double, same samples",
                   series, log_x=False, lines=False, styles=styles)
    words = table(["scene", "tier", "time", "of `fast`", "RMSE to `double`", "FLIP", "samples to see it"], rows,
                  ["---", "---", "--:", "--:", "--:", "--:", "--:"])
    return {"tiers.svg": picture}, words + f"\n\n`double` itself: × {min(doubles):.2f} to × {max(doubles):.2f}."
