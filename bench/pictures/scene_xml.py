# SPDX-License-Identifier: MIT
"""Pieces of scenes in the part of Mitsuba's XML that strahl reads too."""
import pathlib

SHIPPED = pathlib.Path(__file__).resolve().parents[2] / "scenes"
LAMP_DOWN = '<rotate x="1" angle="90"/>'
FLOOR_UP = '<rotate x="1" angle="-90"/>'


def element(kind, inside="", **attributes):
    told = "".join(f' {name}="{value}"' for name, value in attributes.items())
    return f"<{kind}{told}>{inside}</{kind}>" if inside else f"<{kind}{told}/>"


def rgb(name, *values):
    return element("rgb", name=name, value=", ".join(f"{value:.4g}" for value in values))


def number(name, value):
    return element("integer" if isinstance(value, int) else "float", name=name, value=value)


def moved(*steps):
    return element("transform", "".join(steps), name="to_world")


def scaled(x, y=None, z=None):
    return element("scale", x=x, y=x if y is None else y, z=x if z is None else z)


def turned(axis, degrees):
    return element("rotate", **{axis: 1, "angle": degrees})


def to(x, y, z):
    return element("translate", x=x, y=y, z=z)


def diffuse(*reflectance):
    return bsdf("diffuse", rgb("reflectance", *reflectance))


def bsdf(kind, *inside):
    return element("bsdf", "".join(inside), type=kind)


def text(name, value):
    return element("string", name=name, value=value)


def lamp(*radiance):
    return element("emitter", rgb("radiance", *radiance), type="area")


def sky(*radiance):
    return element("emitter", rgb("radiance", *radiance), type="constant")


def shape(kind, *inside):
    return element("shape", "".join(inside), type=kind)


def sphere(centre, radius, *inside):
    x, y, z = centre
    return shape("sphere", element("point", name="center", x=x, y=y, z=z), number("radius", float(radius)), *inside)


def ply(name, *inside):
    return shape("ply", text("filename", name), *inside)


def scene(path, pixels, integrator, camera, *parts):
    """integrator: its type and max_depth; camera: where it stands, what it looks at, degrees."""
    kind, depth = integrator
    origin, target, fov = camera
    look = element("lookat", origin=origin, target=target, up="0, 1, 0")
    size = number("width", pixels) + number("height", pixels)
    film = element("film", size + element("rfilter", type="box"), type="hdrfilm")
    sensor = element("sensor", number("fov", float(fov)) + moved(look) + element("sampler", type="independent") + film,
                     type="perspective")
    lines = [element("integrator", number("max_depth", depth) if depth else "", type=kind), sensor, *parts]
    path.write_text('<scene version="3.0.0">\n' + "\n".join(lines) + "\n</scene>\n", encoding="utf-8")
    return path


def walls(half, height, back):
    """A room open to the camera (+z): floor, ceiling, back and two sides; back: its depth behind z = 0."""
    grey, red, green = diffuse(0.7, 0.7, 0.7), diffuse(0.6, 0.1, 0.1), diffuse(0.15, 0.5, 0.2)
    up = height / 2
    return [shape("rectangle", moved(scaled(half, back, 1), FLOOR_UP), grey),
            shape("rectangle", moved(scaled(half, back, 1), LAMP_DOWN, to(0, height, 0)), grey),
            shape("rectangle", moved(scaled(half, up, 1), to(0, up, -back)), grey),
            shape("rectangle", moved(scaled(back, up, 1), turned("y", 90), to(-half, up, 0)), red),
            shape("rectangle", moved(scaled(back, up, 1), turned("y", -90), to(half, up, 0)), green)]
