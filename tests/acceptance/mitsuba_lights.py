#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Lights with textures by Mitsuba 3.

mitsuba_lights.py --check: whether mitsuba_lights.csv still holds Mitsuba's values.
mitsuba_lights.py --write: writes it anew; tests/physics/test_mitsuba_lights.cpp reads it: scenes of scenes/ with points
that a lamp lights and the irradiance there across its direction, or with directions from the origin and the radiance
seen along them.
"""
import pathlib
import sys

try:
    import numpy as np
    import mitsuba as mi
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

HERE = pathlib.Path(__file__).parent
TABLE = HERE / "mitsuba_lights.csv"
LAMPS = ("spot-texture", "projector-x", "projector-y", "projector-diagonal", "projector-plain")


def load(name):
    return mi.load_file(str(HERE / "scenes" / f"{name}.xml"))


def lamp_rows(rng):
    for name in LAMPS:
        lamp = load(name).emitters()[0]
        for p in np.round(rng.uniform(-1, 1, (16, 3)) * [1.6, 1.2, 0.6], 4):
            point = mi.SurfaceInteraction3f()
            point.p = mi.Point3f(p)
            yield name, "lamp", p, lamp.sample_direction(point, [0.5, 0.5])[1]


def shape_rows(rng):
    scene = load("glowing-shapes")
    places = {"rectangle": (0, 0, 3), "sphere": (4, 0, 0), "disk": (0, 3, 0), "cylinder": (-4, 0, 0), "mesh": (0, -3, 0)}
    for place in places.values():
        for d in np.round(np.array(place) + rng.uniform(-0.7, 0.7, (12, 3)), 4):
            seen = scene.ray_intersect(mi.Ray3f([0, 0, 0], mi.Vector3f(d / np.linalg.norm(d))))
            colour = seen.emitter(scene).eval(seen) if seen.is_valid() else [0, 0, 0]
            yield "glowing-shapes", "glow", d, colour


def attribute_rows(rng):
    for name in ("vertex_color", "vertex_heat", "vertex_flow", "face_color"):
        scene = load(f"glowing-{name}")
        for d in np.round(np.array((0, 0, 2)) + rng.uniform(-0.9, 0.9, (8, 3)) * [1, 1, 0.1], 4):
            seen = scene.ray_intersect(mi.Ray3f([0, 0, 0], mi.Vector3f(d / np.linalg.norm(d))))
            colour = np.array(seen.emitter(scene).eval(seen)).ravel() if seen.is_valid() else [0, 0, 0]
            yield f"glowing-{name}", "glow", d, colour


def table():
    mi.set_variant("scalar_rgb")
    rng = np.random.default_rng(5)
    lines = ["scene,what,x,y,z,r,g,b"]
    for scene, what, at, colour in [*lamp_rows(rng), *shape_rows(rng), *attribute_rows(rng)]:
        lines.append(f"{scene},{what}," + ",".join(f"{value:.9g}" for value in (*at, *np.array(colour).ravel()[:3])))
    return lines


def is_table_current():
    ours, theirs = TABLE.read_text().split(), table()
    same = len(ours) == len(theirs) and ours[0] == theirs[0]
    for a, b in zip(ours[1:], theirs[1:]):
        (*names, _, _, _, _, _, _), other = a.split(","), b.split(",")
        numbers = [np.array([float(x) for x in line.split(",")[2:]]) for line in (a, b)]
        same &= names == other[:2] and bool(np.allclose(*numbers, rtol=1e-5, atol=1e-6))
    print(f"{TABLE.name}: {'same' if same else 'DIFFERENT'}")
    return same


def main():
    if sys.argv[1:] == ["--write"]:
        TABLE.write_text("\n".join(table()) + "\n")
        return 0
    return 0 if is_table_current() else 1


if __name__ == "__main__":
    sys.exit(main())
