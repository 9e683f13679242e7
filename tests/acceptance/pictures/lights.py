# SPDX-License-Identifier: MIT
"""Lights over four things of different materials.

No mesh (nor cube) shines by a texture: Mitsuba 3.9 evaluates it elsewhere where places are drawn on the mesh, and shows 0.4
of what it does with a sampling_weight of 0.
"""

from pictures.materials import AU, RED, facets
from pictures.stage import *

SKY = string("filename", SCENES / "lights" / "sky.hdr")


def lit(*lights, wall=WALL, **frame):
    return scene(
        *lights,
        ball(PLACES[0], bsdf("roughplastic", RED, facets("ggx", 0.2))),
        sheet(PLACES[1], twosided(bsdf("roughconductor", AU, facets("beckmann", 0.2)))),
        ring(PLACES[2], DIFFUSE),
        placed(PLACES[3], bsdf("plastic", RED)),
        light="",
        wall=wall,
        **frame,
    )


def aimed(origin, target="0, 0, 0"):
    return transform(f'<lookat origin="{origin}" target="{target}" up="0, 1, 0"/>')


def spot(color, cutoff, origin, target="0, 0, 0", *inside):
    return emitter("spot", rgb("intensity", color), number("cutoff_angle", cutoff), aimed(origin, target), *inside)


def glow(kind, to_world, radiance, *inside, surface=BLACK):
    return shape(kind, to_world, *inside, emitter("area", radiance), surface)


def point(color, x, y, z, *inside):
    return emitter("point", rgb("intensity", color), f'<point name="position" x="{x}" y="{y}" z="{z}"/>', *inside)


def many(count):
    for i in range(count):
        to = (
            f'<scale value="{0.05 + 0.02 * (i % 3):.2f}"/><rotate x="1" angle="{40 * i}"/><translate '
            f'x="{(i * 7 % 11) / 2.2 - 2.5:.3f}" y="{(i * 5 % 13) / 2.6 - 2.5:.3f}" z="{1 + (i % 5) * 0.3:.1f}"/>'
        )
        color = rgb("radiance", f"{20 + i % 3 * 30}, {20 + i % 5 * 10}, {10 + i % 7 * 10}")
        yield glow(("sphere", "rectangle", "disk", "cube")[i % 4], to, color)


SIDE = '<scale x="0.5" y="0.2"/><rotate y="1" angle="60"/><translate x="-2.3" z="1"/>'
BULB = '<scale value="0.3"/><translate x="2" y="1" z="1.5"/>'
CEILING = '<scale value="0.5"/><rotate x="1" angle="70"/><translate y="2.5" x="-1" z="1"/>'
PICTURES = {
    "spot": lit(
        spot("90, 70, 50", 25, "3, 3, 5", "0, 0, 0", number("beam_width", 10)),
        spot("10, 30, 60", 40, "-3, 1, 4", "-0.5, 0, 0"),
        spot("50, 30, 60", 20, "0, -3, 4", "0.5, -1, 0", number("beam_width", 20)),
    ),
    "spot-textured": lit(
        spot("90, 70, 50", 30, "2, 3, 6", "0, 0, 0", number("beam_width", 25), bitmap("texture")),
        spot(
            "50, 70, 150",
            35,
            "-2, -1, 6",
            "0, 0, 0",
            bitmap("texture", "rivets.png", to_uv('<scale value="2"/><rotate z="1" angle="30"/>')),
        ),
    ),
    "projector": lit(
        emitter("projector", numbers(fov=35, scale=40), bitmap("irradiance"), aimed("1, 2, 6")),
        emitter(
            "projector",
            numbers(fov=50, scale=10),
            string("fov_axis", "y"),
            bitmap("irradiance", "rivets.png"),
            aimed("-3, 1, 5"),
        ),
    ),
    "point": lit(
        point("30, 40, 50", 2, 2, 3),
        point("5, 1, 1", 0, 0, -0.5, number("sampling_weight", 4)),
        emitter(
            "point", number("intensity", 20), transform('<rotate y="1" angle="40"/><translate x="-2" y="-1" z="4"/>')
        ),
    ),
    "directional": lit(
        emitter("directional", rgb("irradiance", "3, 2, 1"), '<vector name="direction" x="-1" y="-2" z="-3"/>'),
        emitter(
            "directional",
            rgb("irradiance", "1, 2, 3"),
            transform('<rotate x="1" angle="130"/><rotate y="1" angle="40"/>'),
        ),
    ),
    "envmap": lit(
        emitter(
            "envmap", SKY, number("scale", 0.02), transform('<rotate x="1" angle="30"/><rotate y="1" angle="130"/>')
        )
    ),
    "envmap-compensated": lit(
        emitter(
            "envmap",
            SKY,
            number("scale", 0.02),
            boolean("mis_compensation", True),
            transform('<rotate z="1" angle="70"/><rotate y="1" angle="-50"/>'),
        )
    ),
    "envmap-mirrored": lit(
        emitter(
            "envmap",
            string("filename", SCENES / "textures" / "letter.png"),
            number("scale", 1.5),
            transform('<scale x="-1"/><rotate y="1" angle="20"/>'),
        ),
        point("30, 40, 50", 2, 2, 3),
    ),
    "area": lit(
        glow("sphere", BULB, rgb("radiance", "9, 6, 3")),
        glow("disk", CEILING, rgb("radiance", "9, 19, 3")),
        glow(
            "cylinder",
            '<scale x="0.1" y="0.1" z="1.2"/><rotate y="1" angle="70"/><translate y="-2.2" x="-1" z="1"/>',
            rgb("radiance", "9, 9, 20"),
        ),
        glow("rectangle", SIDE, rgb("radiance", "20, 9, 20")),
    ),
    "area-flipped": lit(
        glow("obj", CEILING, rgb("radiance", "9, 19, 3"), string("filename", RING)),
        glow(
            "cube",
            '<scale x="0.3" y="0.2" z="0.1"/><rotate y="1" angle="20"/><translate x="2" y="-1" z="1.5"/>',
            rgb("radiance", "20, 9, 5"),
        ),
        glow("sphere", '<scale value="8"/>', rgb("radiance", "0.5, 0.6, 0.7"), boolean("flip_normals", True)),
        glow("rectangle", SIDE, rgb("radiance", "20, 9, 20"), boolean("flip_normals", True)),
    ),
    "area-textured": lit(
        glow("sphere", BULB, bitmap("radiance"), surface=DIFFUSE),
        glow("disk", CEILING, checker("radiance", "0.9, 0.2, 0.1", "0.1, 0.2, 0.9")),
        glow(
            "rectangle",
            '<scale x="1.5" y="1"/><rotate y="1" angle="-60"/><translate x="2.6" y="-1" z="1"/>',
            bitmap("radiance", "letter.png", RAW, to_uv('<scale value="2"/><rotate z="1" angle="30"/>')),
            surface=bsdf("plastic"),
        ),
        glow(
            "cylinder",
            '<scale x="0.2" y="0.2" z="0.9"/><rotate y="1" angle="20"/><translate x="-2" y="-1.5" z="1.5"/>',
            bitmap("radiance"),
        ),
    ),
    "sampling-weights": lit(
        glow("sphere", BULB, rgb("radiance", "9, 6, 3") + number("sampling_weight", 0.2)),
        glow("rectangle", SIDE, rgb("radiance", "20, 9, 20") + number("sampling_weight", 3)),
        emitter("constant", rgb("radiance", "0.2, 0.3, 0.2"), number("sampling_weight", 0.5)),
        point("5, 1, 1", 0, 0, -0.5, number("sampling_weight", 0)),
    ),
    "many-lights": lit(*many(40)),
    "mixed-lights": lit(
        emitter("envmap", SKY, number("scale", 0.01)),
        emitter("directional", rgb("irradiance", "3, 2, 1"), '<vector name="direction" x="-1" y="-2" z="-3"/>'),
        spot("90, 70, 50", 25, "3, 3, 5", "0, 0, 0", number("beam_width", 10)),
        glow("sphere", '<scale value="0.3"/><translate x="-2" y="1" z="1.5"/>', rgb("radiance", "9, 6, 30")),
    ),
    "glowing-materials": lit(
        LAMP,
        glow(
            "sphere",
            '<scale value="0.5"/><translate z="1"/>',
            rgb("radiance", "0.3, 0.6, 0.3"),
            surface=bsdf("dielectric"),
        ),
        glow(
            "rectangle",
            '<scale x="0.9" y="0.6"/><rotate y="1" angle="-60"/><translate x="2.3" y="-1" z="1"/>',
            rgb("radiance", "2, 1, 1"),
            surface=twosided(bsdf("roughconductor", facets("ggx", 0.3))),
        ),
        glow(
            "rectangle",
            '<scale x="0.9" y="0.6"/><rotate y="1" angle="60"/><translate x="-2.3" y="-1" z="1"/>',
            rgb("radiance", "1, 1, 2"),
            surface=bsdf("mask", number("opacity", 0.5), DIFFUSE),
        ),
        integrator=path(8),
    ),
}
