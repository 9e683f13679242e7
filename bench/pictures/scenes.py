# SPDX-License-Identifier: MIT
"""Scenes for path tracers: SCENES has a function for each.

make(folder, pixels, size) writes the scene and its meshes and returns the XML file's path. The picture is square, the
filter a box and the sampler independent, so that a program's own sampler can take its place. size scales what the
scene has much of; 0 stands for the default.
"""
import random

import lamp_scenes
import media_scenes
import surface_scenes
from meshes import icosahedron, knot, terrain, write_ply
from scene_xml import (FLOOR_UP, LAMP_DOWN, SHIPPED, diffuse, element, lamp, moved, number, ply, rgb, scaled, scene, shape,
                       sky, sphere, to, turned, walls)


def cornell(folder, pixels, size):
    """As shipped: 18 parallelograms; path, 8 deep."""
    del size
    text = (SHIPPED / "cornell" / "cornell-box.xml").read_text(encoding="utf-8")
    for old, new in (('name="res" value="512"', f'name="res" value="{pixels}"'),
                     ('<film type="hdrfilm">', '<film type="hdrfilm"><rfilter type="box"/>'),
                     ('<sampler type="multijitter">', '<sampler type="independent">')):
        if old not in text:
            raise ValueError(f"the Cornell box no longer has {old}, which stands for {new} here")
        text = text.replace(old, new)
    path = folder / "cornell.xml"
    path.write_text(text, encoding="utf-8")
    return path


def instances_of(path, pixels, camera, ground, places, triangles):
    write_ply(path.with_suffix(".ply"), *knot(triangles))
    group = element("shape", ply(path.with_suffix(".ply").name, diffuse(0.7, 0.45, 0.25)), type="shapegroup", id="knot")
    return scene(path, pixels, ("direct", None), camera, group,
                 shape("rectangle", moved(scaled(ground), FLOOR_UP), diffuse(0.5, 0.5, 0.5)),
                 shape("rectangle", moved(scaled(3), LAMP_DOWN, to(2, 9, 2)), diffuse(0, 0, 0), lamp(14, 13, 12)),
                 *(shape("instance", element("ref", id="knot"), place) for place in places))


def instances(folder, pixels, size):
    """12 instances, listed, of a knot of 5,000 triangles; direct. size: triangles."""
    chance = random.Random(12)
    places = [moved(scaled(0.9), turned("x", chance.uniform(0, 360)), turned("y", chance.uniform(0, 360)),
                    to(2 * (i % 4) - 3, 1, 2 * (i // 4) - 2)) for i in range(12)]
    return instances_of(folder / "instances.xml", pixels, ("0, 6, 10", "0, 0.6, 0", 40), 20, places, size or 5000)


def field(folder, pixels, size):
    """A field of 1,000 instances of a knot of 5,000 triangles; direct. size: instances."""
    chance, count = random.Random(1000), size or 1000
    places = []
    for _ in range(count):
        x, z, scale = chance.uniform(-12, 12), chance.uniform(-20, 6), chance.uniform(0.3, 0.6)
        places.append(moved(scaled(scale), turned("x", chance.uniform(0, 360)), turned("y", chance.uniform(0, 360)),
                            to(x, scale, z)))
    return instances_of(folder / "field.xml", pixels, ("0, 4, 11", "0, 0.5, 0", 45), 40, places, 5000)


def box(folder, pixels, size):
    """A room with a knot of 5,000 triangles and a sphere; path, 7 deep. size: triangles."""
    write_ply(folder / "box.ply", *knot(size or 5000))
    return scene(folder / "box.xml", pixels, ("path", 7), ("0, 1, 3.9", "0, 1, 0", 38), *walls(1, 2, 1),
                 shape("rectangle", moved(scaled(0.3), LAMP_DOWN, to(0, 1.99, 0)), diffuse(0, 0, 0), lamp(16, 13, 9)),
                 ply("box.ply", moved(scaled(0.5), turned("y", 40), to(-0.4, 0.6, -0.3)), diffuse(0.3, 0.5, 0.7)),
                 sphere((0.45, 0.35, 0.3), 0.35, diffuse(0.8, 0.75, 0.5)))


def hall(folder, pixels, size):
    """A hall with 14 knots of 5,000 triangles, a mesh each; path, 6 deep. size: triangles of a knot."""
    write_ply(folder / "hall.ply", *knot(size or 5000))
    chance = random.Random(14)
    knots = [ply("hall.ply", moved(scaled(0.75), turned("x", chance.uniform(0, 360)), turned("y", chance.uniform(0, 360)),
                                   to(-1.5 if i % 2 else 1.5, 0.8, 4.5 - 1.6 * (i // 2))),
                 diffuse(*(chance.uniform(0.2, 0.8) for _ in range(3)))) for i in range(14)]
    lamps = [shape("rectangle", moved(scaled(0.8), LAMP_DOWN, to(0, 3.98, z)), diffuse(0, 0, 0), lamp(12, 11, 10))
             for z in (-4, 0, 4)]
    return scene(folder / "hall.xml", pixels, ("path", 6), ("0, 2, 8", "0, 1, 0", 50), *walls(3, 4, 7), *lamps, *knots)


def lamps(folder, pixels, size):
    """Disk, cylinder, sphere, rectangle and a mesh of 20 triangles that shine; path, 6 deep. size: the mesh's triangles."""
    write_ply(folder / "lamps.ply", *icosahedron(size or 20))
    black, flat = diffuse(0, 0, 0), element("boolean", name="face_normals", value="true")
    cylinder = (element("point", name="p0", x=-1, y=1.8, z=-1.2), element("point", name="p1", x=0.2, y=2.2, z=-1.4))
    return scene(folder / "lamps.xml", pixels, ("path", 6), ("0, 2, 7", "0, 1.2, 0", 42), *walls(3, 4, 3),
                 shape("disk", moved(scaled(0.5), LAMP_DOWN, to(1.8, 3.5, 0)), black, lamp(6, 5, 4)),
                 shape("cylinder", *cylinder, number("radius", 0.1), black, lamp(4, 6, 9)),
                 sphere((1.5, 1, 0.6), 0.3, black, lamp(7, 4, 2)),
                 shape("rectangle", moved(scaled(0.4, 0.7, 1), turned("y", 90), to(-2.9, 1.2, 0)), black, lamp(5, 5, 5)),
                 ply("lamps.ply", moved(scaled(0.4), to(-1.2, 0.8, 1)), flat, black, lamp(2, 5, 3)),
                 sphere((0.2, 0.6, 0), 0.6, diffuse(0.7, 0.7, 0.7)))


def landscape(folder, pixels, size):
    """A terrain of 500,000 triangles under a rectangle and a constant sky; path, 6 deep. size: triangles."""
    write_ply(folder / "terrain.ply", *terrain(size or 500000))
    return scene(folder / "terrain.xml", pixels, ("path", 6), ("0, 0.8, 1.5", "0, -0.1, 0", 45), sky(0.5, 0.7, 1),
                 ply("terrain.ply", element("boolean", name="face_normals", value="true"), diffuse(0.6, 0.5, 0.4)),
                 shape("rectangle", moved(scaled(0.4), LAMP_DOWN, to(0.8, 1.6, -0.4)), diffuse(0, 0, 0), lamp(12, 11, 9)))


def checkerboard(bright, dark, squares):
    texture = element("texture", rgb("color0", *bright) + rgb("color1", *dark) + element(
        "transform", scaled(squares), name="to_uv"), type="checkerboard", name="reflectance")
    return element("bsdf", texture, type="diffuse")


# Ten rows of the kinds of material that strahl has.
MATERIALS = [diffuse(0.8, 0.8, 0.8), diffuse(0.7, 0.2, 0.1), diffuse(0.2, 0.6, 0.25), diffuse(0.15, 0.3, 0.7),
             diffuse(0.3, 0.3, 0.3), checkerboard((0.9, 0.9, 0.9), (0.1, 0.1, 0.1), 8),
             checkerboard((0.8, 0.6, 0.1), (0.3, 0.1, 0.4), 4),
             element("bsdf", rgb("specular_reflectance", 0.9, 0.9, 0.9) + element("string", name="material", value="none"),
                     type="conductor"),
             element("bsdf", rgb("specular_reflectance", 0.95, 0.75, 0.4) + element("string", name="material", value="none"),
                     type="conductor"),
             element("bsdf", number("int_ior", 1.5) + number("ext_ior", 1.0), type="dielectric")]


def materials(folder, pixels, size):
    """200 spheres and small meshes of ten materials in random order; path, 8 deep. size: their number."""
    write_ply(folder / "materials-knot.ply", *knot(400))
    write_ply(folder / "materials-ball.ply", *icosahedron(80))
    chance, count = random.Random(10), size or 200
    things = []
    for index in range(count):
        radius = chance.uniform(0.15, 0.35)
        place = (chance.uniform(-3.5, 3.5), radius + chance.choice((0, 0, 0.5, 1)), chance.uniform(-5, 2))
        material = chance.choice(MATERIALS)
        if index % 4 < 2:
            things.append(sphere(place, radius, material))
        else:
            name = "materials-knot.ply" if index % 4 == 2 else "materials-ball.ply"
            flat = element("boolean", name="face_normals", value="true") if index % 4 == 3 else ""
            things.append(ply(name, moved(scaled(radius), turned("x", chance.uniform(0, 360)),
                                          turned("y", chance.uniform(0, 360)), to(*place)), flat, material))
    return scene(folder / "materials.xml", pixels, ("path", 8), ("0, 3, 7", "0, 0.5, -0.5", 40), sky(0.6, 0.8, 1),
                 shape("rectangle", moved(scaled(20), FLOOR_UP), diffuse(0.5, 0.5, 0.5)),
                 shape("rectangle", moved(scaled(2), LAMP_DOWN, to(-3, 6, 2)), diffuse(0, 0, 0), lamp(9, 8, 7)), *things)


def crowd(folder, pixels, size):
    """100 knots of 1,000 triangles, a mesh each, under a lamp; path, 6 deep. size: their number."""
    write_ply(folder / "crowd.ply", *knot(1000))
    chance = random.Random(4)
    knots = [ply("crowd.ply", moved(scaled(0.3), turned("x", chance.uniform(0, 360)), turned("y", chance.uniform(0, 360)),
                                    to(chance.uniform(-3, 3), chance.uniform(0.3, 1.5), chance.uniform(-4, 2))),
                 diffuse(*(chance.uniform(0.2, 0.8) for _ in range(3)))) for _ in range(size or 100)]
    return scene(folder / "crowd.xml", pixels, ("path", 6), ("0, 3, 8", "0, 0.6, 0", 42),
                 shape("rectangle", moved(scaled(20), FLOOR_UP), diffuse(0.5, 0.5, 0.5)),
                 shape("rectangle", moved(scaled(1), LAMP_DOWN, to(-1, 6, 2)), diffuse(0, 0, 0), lamp(20, 18, 16)), *knots)


SCENES = {"cornell": cornell, "instances": instances, "field": field, "box": box, "hall": hall, "crowd": crowd,
          "lamps": lamps, "terrain": landscape, "materials": materials, **surface_scenes.SCENES, **lamp_scenes.SCENES,
          **media_scenes.SCENES}
