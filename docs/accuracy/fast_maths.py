# SPDX-License-Identifier: MIT
"""-cl-fast-relaxed-math against IEEE arithmetic: the same programs, built by PoCL, whose POCL_EXTRA_BUILD_FLAGS adds the
option to each. Caches of their own keep such programs from being taken for others."""
from plot import plot
from program import scientific, table

SCENES = ["lecture/lit", "mesh/torus-and-icosphere", "accuracy/planet-horizon", "accuracy/concentric-shells",
          "accuracy/needle-mesh"]
TIERS = ["stable", "robust"]


def measure(strahl):
    findings = strahl.selftest("--tier", "stable", "--inject", "relaxed-maths")["tiers"][0]["canary"]["findings"]
    results = {"findings": [f for f in findings if f["wrong"]], "pictures": []}
    relaxed = strahl.elsewhere({"POCL_EXTRA_BUILD_FLAGS": "-cl-fast-relaxed-math",
                                "XDG_CACHE_HOME": str(strahl.path("cache"))})
    for name in SCENES:
        scene, options = f"scenes/{name}.xml", ["-D", "res=128", "--spp", "16", "--no-canary"]
        strahl.render(scene, "double.exr", *options, "--precision", "double")
        for tier in TIERS:
            files = {"IEEE": strahl, "relaxed": relaxed}
            least = dict.fromkeys(files, float("inf"))
            for _ in range(strahl.rounds):
                for maths, program in files.items():
                    stats = program.render(scene, f"{maths}.exr", *options, "--precision", tier)
                    least[maths] = min(least[maths], stats["seconds"]["kernel"])
            results["pictures"].append({"scene": name, "tier": tier, "ratio": least["relaxed"] / least["IEEE"], **{
                maths: strahl.compare(f"{maths}.exr", "double.exr", "rmse", "flip") for maths in files}})
    return results


def show(results):
    rows, series = [], {}
    for r in results["pictures"]:
        rows.append([r["scene"], f"`{r['tier']}`", f"× {r['ratio']:.2f}", scientific(r["IEEE"]["rmse"]),
                     scientific(r["relaxed"]["rmse"]), f"{r['relaxed']['flip']:.4f}"])
        series.setdefault(r["tier"], []).append((r["ratio"], r["relaxed"]["rmse"] / r["IEEE"]["rmse"], r["scene"]))
    picture = plot("What fast maths saves, and what it loses", "kernel time, IEEE = 1", "RMSE to double, IEEE = 1", series,
                   log_x=False, lines=False)
    words = table(["scene", "tier", "relaxed takes", "RMSE, IEEE", "relaxed", "FLIP, relaxed"], rows,
                  ["---", "---", "--:", "--:", "--:", "--:"])
    found = [[f["property"], f"{f['wrong']} of {f['cases']}"] for f in results["findings"]]
    return {"fast_maths.svg": picture}, words + "\n\n" + table(["what the canary finds of `stable`", "wrong"], found)
