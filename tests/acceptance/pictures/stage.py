# SPDX-License-Identifier: MIT
"""Words of Mitsuba's XML, and the stage of mitsuba_pictures.py: four things before a wall, under a lamp and a dim sky."""

import itertools
import pathlib

SCENES = pathlib.Path(__file__).parents[3] / "scenes"
RING = pathlib.Path(__file__).parent / "ring.obj"
SIZE = 32
NUMBERS = itertools.count()


def number(name, value):
    return f'<float name="{name}" value="{value}"/>'


def integer(name, value):
    return f'<integer name="{name}" value="{value}"/>'


def string(name, value):
    return f'<string name="{name}" value="{value}"/>'


def boolean(name, value):
    return f'<boolean name="{name}" value="{str(value).lower()}"/>'


def rgb(name, value):
    return f'<rgb name="{name}" value="{value}"/>'


def numbers(**values):
    return "".join(number(name, value) for name, value in values.items())


def transform(steps, name="to_world"):
    return f'<transform name="{name}">{steps}</transform>'


def bsdf(kind, *inside):
    return f'<bsdf type="{kind}">{"".join(inside)}</bsdf>'


def twosided(*inside):
    return bsdf("twosided", *inside)


def texture(kind, name, *inside):
    return f'<texture type="{kind}" name="{name}">{"".join(inside)}</texture>'


def bitmap(name, file="letter.png", *inside):
    return texture("bitmap", name, string("filename", SCENES / "textures" / file), *inside)


RAW = boolean("raw", True)


def to_uv(steps):
    return transform(steps, "to_uv")


def checker(name, first, second, uv='<scale x="2" y="1.5"/><rotate z="1" angle="20"/>'):
    return texture("checkerboard", name, rgb("color0", first), rgb("color1", second), to_uv(uv))


def emitter(kind, *inside):
    return f'<emitter type="{kind}">{"".join(inside)}</emitter>'


def shape(kind, to_world="", *inside, name=""):
    return f'<shape type="{kind}"{name}>{transform(to_world) if to_world else ""}{"".join(inside)}</shape>'


DIFFUSE = bsdf("diffuse", rgb("reflectance", "0.9, 0.3, 0.2"))
BLACK = bsdf("diffuse", rgb("reflectance", 0))
LAMP = shape(
    "rectangle",
    '<scale x="1.2" y="0.9"/><rotate x="1" angle="75"/><translate x="-0.5" y="3" z="2.5"/>',
    emitter("area", rgb("radiance", "9, 8, 6")),
    BLACK,
)
DIM = emitter("constant", rgb("radiance", "0.3, 0.4, 0.6"))
CHECKED_WALL = shape(
    "rectangle",
    '<scale value="6"/><translate z="-1.6"/>',
    bsdf("diffuse", checker("reflectance", "0.7, 0.6, 0.5", "0.2, 0.3, 0.4", '<scale value="9"/>')),
)
WALL = shape(
    "rectangle", '<scale value="6"/><translate z="-1.6"/>', bsdf("diffuse", rgb("reflectance", "0.7, 0.6, 0.5"))
)
VIEW = '<lookat origin="0.4, 0.5, 6" target="0, 0, 0" up="0, 1, 0"/>'
BOX_FILTER = '<rfilter type="box"/>'


def sensor(kind="perspective", inside=number("fov", 36), to=VIEW, film="", width=SIZE, height=SIZE, medium=""):
    size = integer("width", width) + integer("height", height)
    return (
        f'<sensor type="{kind}">{inside}{transform(to)}{medium}<film type="hdrfilm">{size}{film}{BOX_FILTER}</film>'
        '<sampler type="independent"/></sensor>'
    )


def path(depth=6, kind="path"):
    return f'<integrator type="{kind}">{integer("max_depth", depth)}{integer("rr_depth", 100)}</integrator>'


def scene(*things, integrator=path(), camera=None, light=LAMP + DIM, wall=CHECKED_WALL):
    return f'<scene version="3.0.0">{integrator}{camera or sensor()}{light}{wall}{"".join(things)}</scene>'


# Things at a place (x, y), as large as 0.75.


def at(place):
    return f'<translate x="{place[0]}" y="{place[1]}"/>'


def ball(place, *what):
    return shape(
        "sphere", f'<scale value="0.75"/><rotate x="1" angle="-70"/><rotate y="1" angle="25"/>{at(place)}', *what
    )


def sheet(place, *what):
    turns = '<rotate z="1" angle="20"/><rotate y="1" angle="30"/><rotate x="1" angle="-20"/>'
    return shape("rectangle", f'<scale x="0.8" y="0.6"/>{turns}{at(place)}', *what)


def backward(place, *what):
    return shape(
        "rectangle", f'<scale x="0.8" y="0.6"/><rotate z="1" angle="20"/><rotate y="1" angle="210"/>{at(place)}', *what
    )


def ring(place, *what):
    turns = '<scale x="0.75" y="0.7" z="0.8"/><rotate x="1" angle="60"/><rotate y="1" angle="20"/>'
    return shape("obj", turns + at(place), string("filename", RING), *what)


def tube(place, *what):
    turns = '<scale x="0.6" y="0.6" z="1.3"/><translate z="-0.65"/><rotate x="1" angle="70"/><rotate y="1" angle="20"/>'
    return shape("cylinder", turns + at(place), *what)


def plate(place, *what):
    return shape("disk", f'<scale value="0.8"/><rotate z="1" angle="20"/><rotate y="1" angle="-30"/>{at(place)}', *what)


def block(place, *what):
    turns = '<scale x="0.6" y="0.45" z="0.5"/><rotate y="1" angle="35"/><rotate x="1" angle="25"/>'
    return shape("cube", turns + at(place), *what)


def coloured(place, *what):
    return shape(
        "ply",
        f'<scale value="0.8"/><rotate x="1" angle="30"/>{at(place)}',
        string("filename", SCENES / "textures" / "coloured.ply"),
        *what,
    )


def instance_of(kind, place, steps, *what):
    name = f' id="group{next(NUMBERS)}"'
    placed = f'<scale x="0.9" y="0.6" z="0.8"/><rotate z="1" angle="30"/>{at(place)}'
    return shape("shapegroup", "", shape(kind, steps, *what), name=name) + shape("instance", placed, f"<ref{name}/>")


def placed(place, *what):
    """An instance of a mesh without u and v."""
    return instance_of(
        "ply", place, '<scale value="0.9"/>', string("filename", SCENES / "mesh" / "icosphere.ply"), *what
    )


PLACES = ((-0.9, 0.9), (0.9, 0.9), (-0.9, -0.9), (0.9, -0.9))


def four(*materials, carriers=(ball, sheet, ring, placed), **frame):
    return scene(*(carry(place, what) for carry, place, what in zip(carriers, PLACES, materials)), **frame)
