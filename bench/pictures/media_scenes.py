# SPDX-License-Identifier: MIT
"""What lies between surfaces: a homogeneous ball, grids of a thin and of a thick cloud, a grid with nothing in it around
a mesh (scenes.py)."""
import array
import math
import struct

from meshes import knot, write_ply
from scene_xml import (FLOOR_UP, LAMP_DOWN, bsdf, diffuse, element, lamp, moved, number, ply, rgb, scaled, scene, shape, sky,
                       sphere, text, to)

CAMERA = ("2.2, 1.9, 3.4", "0, 0.9, 0", 40)
GROUND = shape("rectangle", moved(scaled(6), FLOOR_UP), diffuse(0.5, 0.4, 0.3))
LAMP = shape("rectangle", moved(scaled(0.6), LAMP_DOWN, to(1.5, 4, 1)), diffuse(0, 0, 0), lamp(24, 22, 18))


def cloud(side):
    """A ball of billows, 1 at the most: z, y, x."""
    values = array.array("f")
    for k in range(side):
        for j in range(side):
            for i in range(side):
                x, y, z = ((2 * n + 1) / side - 1 for n in (i, j, k))
                waves = math.sin(7 * x + 3 * y) * math.sin(6 * y + 4 * z) * math.sin(8 * z + 2 * x)
                values.append(min(1.0, max(0.0, 1.3 - 1.5 * math.hypot(x, y, z) + 0.5 * waves)))
    return values


def write_vol(path, side, values):
    header = b"VOL\x03" + struct.pack("<5i6f", 1, side, side, side, 1, 0, 0, 0, 1, 1, 1)
    path.write_bytes(header + values.tobytes())


def medium(kind, *inside):
    return element("medium", "".join(inside), type=kind, name="interior")


def body(inside):
    """A cube from (-0.8, 0.1, -0.8) to (0.8, 1.7, 0.8), of what it has inside."""
    return shape("cube", moved(scaled(0.8), to(0, 0.9, 0)), bsdf("null"), inside)


def grid(path, scale, albedo):
    place = moved(to(-0.5, -0.5, -0.5), scaled(1.6), to(0, 0.9, 0))
    volume = element("volume", text("filename", path.name) + place, type="gridvolume", name="sigma_t")
    return medium("heterogeneous", volume, rgb("albedo", *albedo), number("scale", float(scale)))


def seen(path, pixels, integrator, *things):
    return scene(path, pixels, integrator, CAMERA, sky(0.3, 0.4, 0.6), LAMP, GROUND, *things)


def ball(folder, pixels, size):
    """A ball of fog; volpath, 64 deep. size: its optical depth, 4."""
    fog = medium("homogeneous", rgb("albedo", 0.9, 0.8, 0.7), number("sigma_t", (size or 4) / 1.6))
    return seen(folder / "ball.xml", pixels, ("volpath", 64), sphere((0, 0.9, 0), 0.8, bsdf("null"), fog))


def cloud_of(name, folder, pixels, size, scale, albedo):
    path = folder / f"{name}.vol"
    write_vol(path, size or 64, cloud(size or 64))
    return seen(folder / f"{name}.xml", pixels, ("volpath", 64), body(grid(path, scale, albedo)))


def thin(folder, pixels, size):
    """A thin cloud in a grid; volpath, 64 deep. size: texels an axis."""
    return cloud_of("thin", folder, pixels, size, 2, (0.9, 0.9, 0.9))


def thick(folder, pixels, size):
    """A thick cloud in a grid; volpath, 64 deep. size: texels an axis."""
    return cloud_of("thick", folder, pixels, size, 40, (0.99, 0.99, 0.99))


def empty(folder, pixels, size):
    """A grid of zeros around a knot of 10,000 triangles; volpath, 8 deep. size: triangles."""
    write_ply(folder / "knot.ply", *knot(size or 10000))
    write_vol(folder / "empty.vol", 64, array.array("f", bytes(4 * 64 ** 3)))
    return seen(folder / "empty.xml", pixels, ("volpath", 8), body(grid(folder / "empty.vol", 1, (0.9, 0.9, 0.9))),
                ply("knot.ply", moved(scaled(0.7), to(0, 0.9, 0)), diffuse(0.7, 0.5, 0.3)))


SCENES = {"ball": ball, "thin": thin, "thick": thick, "empty": empty}
