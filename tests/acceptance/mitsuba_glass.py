#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Glass by strahl and by Mitsuba 3, within noise; and Mitsuba's indices of refraction by name.

mitsuba_glass.py STRAHL [RENDERS [SPP]]: as mitsuba_path.py, over three scenes.
"""
import pathlib
import re
import sys

import mitsuba_path
from mitsuba_path import mi

INDICES = pathlib.Path(__file__).parents[2] / "src" / "scene" / "readers" / "refractive_indices.cpp"


def indices_are_alike():
    table = re.findall(r'\{"([^"]+)", ([0-9.]+)\}', INDICES.read_text())
    good = len(table) >= 23
    for name, index in table:
        ours = float(index)
        glass = mi.load_dict({"type": "dielectric", "int_ior": name, "ext_ior": "vacuum"})
        theirs = float(mi.traverse(glass)["eta"])
        if abs(ours - theirs) > 1e-6:
            print(f"{name}: {ours}, Mitsuba has {theirs}")
            good = False
    print(f"{len(table)} indices: {'same' if good else 'DIFFERENT'}")
    return good


def main():
    renders = int(sys.argv[2]) if len(sys.argv) > 2 else 12
    spp = int(sys.argv[3]) if len(sys.argv) > 3 else 64
    good = indices_are_alike()
    for scene in ("glass-ball", "glass-nested", "glass-block"):
        mitsuba_path.SCENE = pathlib.Path(__file__).parent / "scenes" / f"{scene}.xml"
        for depth in ("6", "-1"):
            parameters = {"depth": depth}
            reference = mitsuba_path.by_mitsuba(parameters, spp, range(renders))
            ours = mitsuba_path.by_strahl(sys.argv[1], parameters, spp, range(renders), "independent")
            good &= mitsuba_path.compare(f"{scene}, depth {depth}", ours, reference, 0.45)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
