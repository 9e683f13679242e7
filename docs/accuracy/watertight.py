# SPDX-License-Identifier: MIT
"""What it costs that closed meshes are closed: rays at edges and corners that get through, and the time of pictures."""
from plot import plot
from program import table

SCENES = {"shapes/mesh-ply": [], "shapes/mesh-obj": [], "mesh/torus-and-icosphere": [], "accuracy/needle-mesh": []}
TIERS = ["fast", "stable", "robust"]


def measure(strahl):
    results = {"seams": [], "pictures": []}
    tiers = [word for tier in TIERS for word in ("--tier", tier)]
    for line in strahl.selftest(*tiers, "--kind", "triangle", "--kind", "parallelogram")["lines"]:
        results["seams"].append({"tier": line["precision"], "primitive": line["primitive"], **line["seams"]})
    for name in SCENES:
        options = ["-D", "res=256", "--spp", "16"]
        seconds = strahl.timed(f"scenes/{name}.xml", {tier: options + ["--precision", tier] for tier in TIERS})
        results["pictures"] += [{"scene": name, "tier": tier, "seconds": seconds[tier],
                                 "ratio": seconds[tier] / seconds["fast"]} for tier in TIERS]
    return results


def show(results):
    lost = {tier: {s["primitive"]: (s["leaks"], s["rays"]) for s in results["seams"] if s["tier"] == tier} for tier in TIERS}
    rows = []
    for tier in TIERS:
        ratios = [f"× {r['ratio']:.2f}" for r in results["pictures"] if r["tier"] == tier]
        rows.append([f"`{tier}`", *("{} of {:,}".format(*lost[tier][p]) for p in ("triangle", "parallelogram")), *ratios])
    series = {tier: [(r["ratio"], lost[tier]["triangle"][0] / lost[tier]["triangle"][1],
                      f"{r['scene']}: × {r['ratio']:.2f}") for r in results["pictures"] if r["tier"] == tier]
              for tier in TIERS}
    picture = plot("What tight meshes cost", "kernel time of a picture, fast = 1", "share of rays at seams that get through",
                   series, log_x=False, log_y=False, lines=False)
    return {"watertight.svg": picture}, table(["tier", "lost of triangles", "of rectangles", *SCENES], rows)
