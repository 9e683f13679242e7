# SPDX-License-Identifier: MIT
"""Cameras, integrators, modes of textures, media.

Media are Mitsuba's volpathmis: its volpath weights distances by the one channel that drew them, so what is thin in red and
thick in blue comes out too dark in red where no rare path of great weight is among the samples.
"""

from pictures.lights import SKY, aimed, glow, point, spot
from pictures.materials import RED, facets
from pictures.stage import *


def seen(kind="perspective", inside=number("fov", 36), **frame):
    return four(
        DIFFUSE,
        twosided(bsdf("diffuse", bitmap("reflectance"))),
        bsdf("plastic", RED),
        bsdf("roughconductor", facets("ggx", 0.3)),
        camera=sensor(kind, inside, **frame),
    )


def lens(radius, distance):
    return numbers(fov=36, aperture_radius=radius, focus_distance=distance)


def by(kind, inside="", **frame):
    return four(
        DIFFUSE,
        twosided(bsdf("diffuse", bitmap("reflectance"))),
        bsdf("plastic", RED),
        bsdf("dielectric"),
        integrator=f'<integrator type="{kind}">{inside}</integrator>',
        **frame,
    )


def textured(*textures, carriers):
    return four(*(twosided(bsdf("diffuse", pattern)) for pattern in textures), carriers=carriers)


def attribute(name, scale=1):
    return texture("mesh_attribute", "reflectance", string("name", name), number("scale", scale))


def instanced(kind, *inside):
    return lambda place, what: instance_of(kind, place, '<scale value="0.7"/><rotate x="1" angle="70"/>', *inside, what)


def mode(*inside, file="letter.png"):
    return bitmap("reflectance", file, *inside)


WINDOW = (
    integer("crop_offset_x", 20) + integer("crop_offset_y", 12) + integer("crop_width", 32) + integer("crop_height", 32)
)
CLOUD = pathlib.Path(__file__).parent / "cloud.vol"
UPRIGHT = '<scale x="3" y="2"/>'
CAMERAS = {
    "fov-x": seen(
        inside=number("fov", 30)
        + string("fov_axis", "x")
        + numbers(principal_point_offset_x=0.1, principal_point_offset_y=-0.15),
        width=40,
        height=24,
    ),
    "fov-y": seen(inside=string("fov_axis", "y") + numbers(fov=30, near_clip=5.5, far_clip=7.2), width=40, height=24),
    "fov-diagonal": seen(inside=number("fov", 40) + string("fov_axis", "diagonal"), width=40, height=24),
    "fov-smaller": seen(inside=number("fov", 30) + string("fov_axis", "smaller"), width=40, height=24),
    "fov-larger": seen(inside=number("fov", 30) + string("fov_axis", "larger"), width=24, height=40),
    "focal-length": seen(inside=string("focal_length", "70mm"), width=40, height=32),
    "orthographic": seen(
        "orthographic",
        number("near_clip", 1),
        to=f'<scale x="2.5" y="1.5"/><rotate z="1" angle="10"/>{VIEW}',
        width=40,
        height=24,
    ),
    "thinlens": seen("thinlens", lens(0.3, 5.5), to=f'<rotate z="1" angle="15"/>{VIEW}', width=40, height=24),
    "crop": seen("thinlens", lens(0.1, 6), width=72, height=56, film=WINDOW),
}
INTEGRATORS = {
    "direct": by("direct", integer("emitter_samples", 3) + integer("bsdf_samples", 2)),
    "depth-2": by("path", integer("max_depth", 2)),
    "depth-3": by("path", integer("max_depth", 3)),
    "endless": by("path", integer("rr_depth", 2)),
    "hidden-lights": by("path", boolean("hide_emitters", True), wall=""),
}
TEXTURES = {
    "wrap-modes": textured(
        mode(string("wrap_mode", "mirror"), to_uv(f'{UPRIGHT}<rotate z="1" angle="20"/><translate x="0.3" y="-0.2"/>')),
        mode(string("wrap_mode", "clamp"), to_uv(f'{UPRIGHT}<translate x="-0.7" y="-0.5"/>')),
        mode(string("filter_type", "nearest"), to_uv(UPRIGHT)),
        mode(RAW, to_uv('<rotate z="1" angle="70"/>')),
        carriers=(ball, sheet, tube, plate),
    ),
    "carriers": textured(
        mode(),
        mode(to_uv('<scale x="-1" y="2"/>')),
        mode(file="waves.png"),
        mode(string("filter_type", "nearest"), file="rivets.png"),
        carriers=(ring, block, plate, tube),
    ),
    "attributes": textured(
        attribute("vertex_color"),
        attribute("vertex_heat"),
        attribute("vertex_color", 0.5),
        attribute("vertex_heat", 0.7),
        carriers=(coloured,) * 4,
    ),
    "instances": textured(
        mode(),
        checker("reflectance", "0.9, 0.5, 0.1", "0.1"),
        mode(file="rivets.png"),
        checker("reflectance", "0.9", "0.1"),
        carriers=(placed, instanced("obj", string("filename", RING)), instanced("sphere"), instanced("cylinder")),
    ),
}


def medium(*inside, kind="homogeneous", name="interior"):
    return f'<medium type="{kind}" name="{name}">{"".join(inside)}</medium>'


def phase(kind, *inside):
    return f'<phase type="{kind}">{"".join(inside)}</phase>'


def thick(scale, *inside):
    return medium(rgb("sigma_t", "0.25, 0.5, 1"), number("scale", scale), rgb("albedo", "0.9, 0.8, 0.5"), *inside)


def smoke(place, *inside):
    """The unit cube of a grid, and the grid in it."""
    to = f'<translate x="-0.5" y="-0.5" z="-0.5"/><scale x="1.2" y="0.9" z="1"/><rotate y="1" angle="35"/>{at(place)}'
    grid = f'<volume name="sigma_t" type="gridvolume">{string("filename", CLOUD)}{transform(to)}</volume>'
    cube = f'<translate x="1" y="1" z="1"/><scale value="0.5"/>{to}'
    return shape("cube", cube, NULL, medium(grid, *inside, kind="heterogeneous"))


def aired(*things, **frame):
    return scene(*things, **{"integrator": path(32, "volpathmis"), "wall": WALL, **frame})


NULL = bsdf("null")
HALF = bsdf("mask", number("opacity", 0.5), DIFFUSE)
WATER = bsdf("dielectric", number("int_ior", 1.3))
FROSTED = bsdf("roughdielectric", number("int_ior", 1.3), facets("ggx", 0.2))
FORWARD, BACK = phase("hg", number("g", 0.7)), phase("hg", number("g", -0.6))
BOTH = phase("blendphase", number("weight", 0.3), FORWARD, phase("isotropic"))
FOG = f'<medium type="homogeneous" id="fog" name="interior">{numbers(sigma_t=0.1, albedo=0.8)}{FORWARD}</medium>'
OUTSIDE = '<ref id="fog" name="exterior"/>'
IN_FOG = (
    shape("sphere", '<scale value="9"/>', NULL, FOG),
    ball(PLACES[0], DIFFUSE, OUTSIDE),
    block(PLACES[1], bsdf("plastic", RED)),
    ring(PLACES[2], bsdf("dielectric"), OUTSIDE),
    shape("rectangle", '<scale value="6"/><translate z="-1.6"/>', twosided(bsdf("diffuse"))),
)
MEDIA = {
    "media": aired(
        ball(PLACES[0], NULL, thick(4)),
        block(PLACES[1], NULL, medium(numbers(sigma_t=3, albedo=0.95), FORWARD)),
        ring(PLACES[2], WATER, thick(8)),
        block(PLACES[3], HALF, medium(numbers(sigma_t=3, albedo=0.7), phase("rayleigh"))),
    ),
    "phases": aired(
        ball(PLACES[0], NULL, medium(numbers(sigma_t=5, albedo=0.9), BACK)),
        block(PLACES[1], NULL, thick(6, BOTH)),
        ball(PLACES[2], FROSTED, thick(8)),
        ball(PLACES[3], WATER, medium(numbers(sigma_t=3, albedo=0.7), phase("rayleigh"))),
    ),
    "media-depth-3": aired(
        ball(PLACES[0], NULL, thick(4)),
        ring(PLACES[2], WATER, thick(8)),
        ball(PLACES[3], HALF),
        integrator=path(3, "volpathmis"),
    ),
    "fog": aired(*IN_FOG, wall="", camera=sensor(medium='<ref id="fog"/>')),
    "fog-beams": aired(
        *IN_FOG,
        wall="",
        camera=sensor(medium='<ref id="fog"/>'),
        light=spot("90, 70, 50", 25, "3, 3, 5", "0, 0, 0", number("beam_width", 10)) + point("5, 1, 1", 0, 0, 0.5),
    ),
    "lamps-in-media": aired(
        ball(PLACES[0], NULL, thick(4)),
        block(PLACES[1], NULL, thick(4)),
        glow("sphere", f'<scale value="0.3"/>{at(PLACES[1])}', rgb("radiance", "9, 6, 3")),
        light=emitter("envmap", SKY, number("scale", 0.01))
        + emitter("directional", rgb("irradiance", "3, 2, 1"), aimed("1, 2, 3")),
    ),
    "smoke": aired(
        smoke(PLACES[0], numbers(scale=20, albedo=0.95)),
        smoke(PLACES[3], number("scale", 40), rgb("albedo", "0.9, 0.5, 0.2"), FORWARD),
    ),
}
PICTURES = {**CAMERAS, **INTEGRATORS, **TEXTURES, **MEDIA}
