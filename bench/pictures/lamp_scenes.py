# SPDX-License-Identifier: MIT
"""Many lights, or one of many items, over a floor with a knot of 5,000 triangles; path, 6 deep (scenes.py)."""
import random

from meshes import icosahedron, knot, write_ply
from scene_xml import FLOOR_UP, diffuse, element, lamp, moved, number, ply, rgb, scaled, scene, shape, sphere, to

BLACK = diffuse(0, 0, 0)


def lit_by(name, folder, pixels, lights):
    write_ply(folder / f"{name}.ply", *knot(5000))
    return scene(folder / f"{name}.xml", pixels, ("path", 6), ("0, 3, 8", "0, 0.6, 0", 42),
                 shape("rectangle", moved(scaled(20), FLOOR_UP), diffuse(0.5, 0.5, 0.5)),
                 ply(f"{name}.ply", moved(to(0, 1, 0)), diffuse(0.6, 0.4, 0.3)), *lights)


def places(count, seed, low, high):
    chance = random.Random(seed)
    return [(chance.uniform(-3, 3), chance.uniform(low, high), chance.uniform(-4, 2)) for _ in range(count)]


def points(folder, pixels, size):
    """20 point lights. size: their number."""
    lights = [element("emitter", element("point", name="position", x=x, y=y, z=z) + rgb("intensity", 3, 3, 2), type="point")
              for x, y, z in places(size or 20, 6, 2.3, 3.5)]
    return lit_by("points", folder, pixels, lights)


def spots(folder, pixels, size):
    """6 spots in a row. size: their number."""
    count = size or 6
    lights = []
    for i in range(count):
        look = element("lookat", origin=f"{6 * i / count - 3}, 4, 2", target="0, 1, 0", up="0, 1, 0.01")
        beam = rgb("intensity", 30, 25, 20) + number("cutoff_angle", 25.0)
        lights.append(element("emitter", moved(look) + beam, type="spot"))
    return lit_by("spots", folder, pixels, lights)


def bulbs(folder, pixels, size):
    """100 small spheres that shine. size: their number."""
    lights = [sphere(place, 0.05, BLACK, lamp(9, 8, 7)) for place in places(size or 100, 7, 1.3, 2.5)]
    return lit_by("bulbs", folder, pixels, lights)


def glow(folder, pixels, size):
    """A ball of 1,280 triangles that shines. size: triangles."""
    write_ply(folder / "ball.ply", *icosahedron(size or 1280))
    return lit_by("glow", folder, pixels, [ply("ball.ply", moved(scaled(0.4), to(1.5, 2, 1)), BLACK, lamp(9, 8, 7))])


SCENES = {"points": points, "spots": spots, "bulbs": bulbs, "glow": glow}
