# SPDX-License-Identifier: MIT
"""What of Mitsuba's scene format the Cornell box needs, as plain numbers for peers that do not read it: rectangles,
cubes, their colours, one camera. Anything else raises an error: a peer must not render another scene unnoticed."""
import dataclasses
import math
import xml.etree.ElementTree as tree

RECTANGLE = [[(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]]
# Counter-clockwise from outside, a face an axis and side.
CUBE = [[(1, -1, -1), (1, 1, -1), (1, 1, 1), (1, -1, 1)], [(-1, -1, -1), (-1, -1, 1), (-1, 1, 1), (-1, 1, -1)],
        [(-1, 1, -1), (-1, 1, 1), (1, 1, 1), (1, 1, -1)], [(-1, -1, -1), (1, -1, -1), (1, -1, 1), (-1, -1, 1)],
        [(-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)], [(-1, -1, -1), (-1, 1, -1), (1, 1, -1), (1, -1, -1)]]


@dataclasses.dataclass
class Surface:
    """Quadrilaterals that face where their corners are counter-clockwise; world coordinates, y up."""
    name: str
    faces: list
    reflectance: tuple  # Linear sRGB.
    radiance: tuple  # None: no lamp.


@dataclasses.dataclass
class Box:
    width: int
    height: int
    max_depth: int  # Segments of a path, the camera's included.
    fov: float  # Degrees, of the picture's width.
    origin: tuple
    target: tuple
    up: tuple
    surfaces: list


def triple(text):
    return tuple(float(number) for number in text.replace(",", " ").split())


def axes(element, otherwise):
    return tuple(float(element.get(axis, otherwise)) for axis in "xyz")


def rotated(point, axis, degrees):
    """About one of the axes, counter-clockwise seen from its end."""
    if sorted(axis) != [0, 0, 1]:
        raise ValueError(f"a rotation about {axis}: only about an axis")
    first, second = {0: (1, 2), 1: (2, 0), 2: (0, 1)}[axis.index(1)]
    cosine, sine = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    turned = list(point)
    turned[first] = cosine * point[first] - sine * point[second]
    turned[second] = sine * point[first] + cosine * point[second]
    return tuple(turned)


def transformed(point, transform):
    for step in transform:
        if step.tag == "scale":
            point = tuple(p * s for p, s in zip(point, axes(step, 1)))
        elif step.tag == "translate":
            point = tuple(p + s for p, s in zip(point, axes(step, 0)))
        elif step.tag == "rotate":
            point = rotated(point, axes(step, 0), float(step.get("angle")))
        else:
            raise ValueError(f"a transform's <{step.tag}> is not read")
    return point


def read_box(path):
    root = tree.parse(path).getroot()
    defaults = {"$" + entry.get("name"): entry.get("value") for entry in root.findall("default")}

    def value(element):
        return defaults.get(element.get("value"), element.get("value"))

    def of(parent, kind, name):
        return value(parent.find(f"{kind}[@name='{name}']"))

    materials = {}
    for material in root.findall("bsdf"):
        if material.get("type") != "diffuse":
            raise ValueError(f"a material {material.get('type')} is not read")
        materials[material.get("id")] = triple(of(material, "rgb", "reflectance"))
    surfaces = []
    for shape in root.findall("shape"):
        faces = {"rectangle": RECTANGLE, "cube": CUBE}[shape.get("type")]
        moved = [[transformed(corner, shape.find("transform")) for corner in face] for face in faces]
        lamp = shape.find("emitter")
        radiance = None if lamp is None else triple(of(lamp, "rgb", "radiance"))
        surfaces.append(Surface(shape.get("id"), moved, materials[shape.find("ref").get("id")], radiance))
    sensor = root.find("sensor")
    look = sensor.find("transform/lookat")
    return Box(int(of(sensor.find("film"), "integer", "width")), int(of(sensor.find("film"), "integer", "height")),
               int(of(root.find("integrator"), "integer", "max_depth")), float(of(sensor, "float", "fov")),
               triple(look.get("origin")), triple(look.get("target")), triple(look.get("up")), surfaces)
