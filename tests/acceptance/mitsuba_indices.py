#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Indices of refraction that Mitsuba 3 knows by name: the values that tests/scene/test_named_indices.cpp holds.

mitsuba_indices.py            writes tests/scene/mitsuba_indices.csv anew
mitsuba_indices.py --check    exit status 1 where the installed Mitsuba has other values, 77 where there is none
"""
import pathlib
import sys

try:
    import mitsuba as mi
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

TABLE = pathlib.Path(__file__).parents[1] / "scene" / "mitsuba_indices.csv"
# Of include/mitsuba/render/ior.h, which Python does not show.
MEDIA = ("vacuum", "helium", "hydrogen", "air", "carbon dioxide", "water", "acetone", "ethanol", "carbon tetrachloride",
         "glycerol", "benzene", "silicone oil", "bromine", "water ice", "fused quartz", "pyrex", "acrylic glass",
         "polypropylene", "bk7", "sodium chloride", "amber", "pet", "diamond")


def rows():
    """Names with the values in linear sRGB, of media grey."""
    spectra = pathlib.Path(mi.__file__).parent / "data" / "ior"
    for metal in sorted(file.name.removesuffix(".eta.spd") for file in spectra.glob("*.eta.spd")):
        found = mi.traverse(mi.load_dict({"type": "conductor", "material": metal}))
        for what in ("eta", "k"):
            yield "metal", metal, what, list(found[f"{what}.value"])
    for medium in MEDIA:
        found = mi.traverse(mi.load_dict({"type": "dielectric", "int_ior": medium, "ext_ior": 1.0}))
        yield "medium", medium, "eta", [found["eta"]] * 3


def table():
    mi.set_variant("scalar_rgb")
    mi.set_log_level(mi.LogLevel.Error)  # Some spectra lie outside sRGB.
    return ["what,name,value,r,g,b"] + [f"{what},{name},{value}," + ",".join(f"{x:.9g}" for x in rgb)
                                        for what, name, value, rgb in rows()]


def is_table_current():
    ours, theirs = TABLE.read_text().splitlines(), table()
    far = []
    for a, b in zip(ours[1:], theirs[1:]):
        (*names, r, g, b_), (*others, x, y, z) = a.split(","), b.split(",")
        pairs = [(float(p), float(q)) for p, q in ((r, x), (g, y), (b_, z))]
        if names != others or any(abs(p - q) > 1e-5 * max(abs(q), 1e-2) for p, q in pairs):
            far.append(a)
    print(f"{len(theirs) - 1} rows, {len(ours) - len(theirs)} more in {TABLE.name}, {len(far)} differ", *far[:5], sep="\n")
    return not far and len(ours) == len(theirs)


def main():
    if "--check" not in sys.argv:
        TABLE.write_text("\n".join(table()) + "\n")
        return 0
    return 0 if is_table_current() else 1


if __name__ == "__main__":
    sys.exit(main())
