#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Textures and environments of images by Mitsuba 3.

mitsuba_images.py STRAHL [RENDERS [SPP]]: as mitsuba_path.py, over scenes/image-room.xml; and whether mitsuba_images.csv
still holds Mitsuba's values.
mitsuba_images.py --write: writes mitsuba_images.csv anew, which tests/physics/test_mitsuba_images.cpp reads: points (u v)
of textures and directions of environments with the colour there.
"""
import pathlib
import sys

import mitsuba_path
from mitsuba_path import mi, np

HERE = pathlib.Path(__file__).parent
TABLE = HERE / "mitsuba_images.csv"
LETTER = HERE.parents[1] / "scenes" / "textures" / "letter.png"
SKY = HERE.parents[1] / "scenes" / "lights" / "sky.hdr"


def texture_rows():
    rng = np.random.default_rng(1)
    for filter_type in ("bilinear", "nearest"):
        for wrap_mode in ("repeat", "mirror", "clamp"):
            for raw in (False, True):
                texture = mi.load_dict({"type": "bitmap", "filename": str(LETTER), "filter_type": filter_type,
                                        "wrap_mode": wrap_mode, "raw": raw, "format": "variant"})
                for u, v in np.round(rng.uniform(-2, 3, (6, 2)), 4):
                    point = mi.SurfaceInteraction3f()
                    point.uv = mi.Point2f(u, v)
                    yield f"{filter_type},{wrap_mode},{'raw' if raw else 'srgb'}", (u, v, 0), texture.eval(point)


def environment_rows():
    rng = np.random.default_rng(2)
    turns = {"upright": mi.ScalarTransform4f(), "turned": mi.ScalarTransform4f().rotate([0, 1, 0], 100),
             "tilted": mi.ScalarTransform4f().rotate([1, 0, 0], -90)}
    for name, turn in turns.items():
        light = mi.load_dict({"type": "envmap", "filename": str(SKY), "to_world": turn})
        directions = rng.normal(size=(12, 3))
        for d in list(directions) + [np.eye(3)[i] * sign for i in range(3) for sign in (1, -1)]:
            d = np.round(d / np.linalg.norm(d), 4)
            d = d / np.linalg.norm(d)
            point = mi.SurfaceInteraction3f()
            point.wi = mi.Vector3f(-d)
            yield f"envmap,{name},", tuple(d), light.eval(point)


def table():
    lines = ["kind,mode,curve,x,y,z,r,g,b"]
    for what, at, colour in [*texture_rows(), *environment_rows()]:
        lines.append(f"{what}," + ",".join(f"{value:.9g}" for value in (*at, *np.array(colour).ravel()[:3])))
    return lines


def is_table_current():
    ours, theirs = TABLE.read_text().split(), table()
    same = len(ours) == len(theirs)
    for a, b in zip(ours, theirs):
        numbers = [np.array([float(x) for x in line.split(",")[3:]]) for line in (a, b)] if "," in a and a != theirs[0] else None
        same &= a == b if numbers is None else bool(np.allclose(*numbers, rtol=1e-5, atol=1e-6))
    print(f"{TABLE.name}: {'same' if same else 'DIFFERENT'}")
    return same


def main():
    if sys.argv[1:] == ["--write"]:
        TABLE.write_text("\n".join(table()) + "\n")
        return 0
    renders = int(sys.argv[2]) if len(sys.argv) > 2 else 12
    spp = int(sys.argv[3]) if len(sys.argv) > 3 else 64
    mitsuba_path.SCENE = HERE / "scenes" / "image-room.xml"
    good = is_table_current()
    for parameters in ({"compensation": "false"}, {"compensation": "true"}, {"angle": "-30"}):
        reference = mitsuba_path.by_mitsuba(parameters, spp, range(renders))
        for sampler in ("independent", "sobol"):
            ours = mitsuba_path.by_strahl(sys.argv[1], parameters, spp, range(renders), sampler)
            good &= mitsuba_path.compare(f"image-room {parameters}, {sampler}", ours, reference, 0.6)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
