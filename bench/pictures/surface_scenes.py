# SPDX-License-Identifier: MIT
"""Light on surfaces: rough glass and metal, images, skies, plastics, principled, on meshes and spheres (scenes.py)."""
import random

from meshes import knot, write_ply
from scene_xml import (FLOOR_UP, LAMP_DOWN, SHIPPED, bsdf, diffuse, element, lamp, moved, number, ply, rgb, scaled, scene,
                       shape, sphere, text, to, turned, walls)

HALL_LAMP = shape("rectangle", moved(scaled(0.8), LAMP_DOWN, to(0, 3.98, 0)), diffuse(0, 0, 0), lamp(14, 13, 12))


def envmap(turn=0):
    picture = text("filename", SHIPPED / "lights" / "sky.hdr") + number("scale", 0.1)
    return element("emitter", picture + moved(turned("y", turn)), type="envmap")


RAW = element("boolean", name="raw", value="true")


def image(parameter, scale=1, name="letter.png", *inside):
    """parameter: None where the texture is what the material has without a name."""
    told = {"name": parameter} if parameter else {}
    picture = text("filename", SHIPPED / "textures" / name) + "".join(inside)
    return element("texture", picture + element("transform", scaled(scale), name="to_uv"), type="bitmap", **told)


def rows_of(folder, triangles, materials, seed):
    """Knots and spheres in turns, two rows of four, each of one of the materials."""
    write_ply(folder / "knot.ply", *knot(triangles, has_uvs=True))
    chance = random.Random(seed)
    things = []
    for i in range(8):
        place = (1.5 * (i % 4) - 2.25, 0.75, 1.6 - 2 * (i // 4))
        material = materials[i % len(materials)]
        if i % 2:
            things.append(sphere(place, 0.6, material))
        else:
            things.append(ply("knot.ply", moved(scaled(0.7), turned("x", chance.uniform(0, 360)),
                                                turned("y", chance.uniform(0, 360)), to(*place)), material))
    return things


def in_a_room(name, folder, pixels, materials, seed, triangles, depth=8):
    return scene(folder / f"{name}.xml", pixels, ("path", depth), ("0, 2, 8", "0, 1, 0", 42), *walls(3.2, 4, 3.2),
                 HALL_LAMP, *rows_of(folder, triangles, materials, seed))


def under_a_sky(name, folder, pixels, materials, seed, triangles, floor=None, depth=8):
    return scene(folder / f"{name}.xml", pixels, ("path", depth), ("0, 2.5, 8", "0, 0.6, 0", 42), envmap(40),
                 shape("rectangle", moved(scaled(12), FLOOR_UP), floor or diffuse(0.5, 0.5, 0.5)),
                 *rows_of(folder, triangles, materials, seed))


def microfacets(distribution, alpha):
    return text("distribution", distribution) + number("alpha", alpha)


def roughglass(folder, pixels, size):
    """Rough and smooth glass in a room; path, 12 deep. size: triangles of a knot."""
    glasses = [bsdf("roughdielectric", microfacets("ggx", 0.1)), bsdf("roughdielectric", microfacets("beckmann", 0.3)),
               bsdf("dielectric", number("int_ior", 1.5))]
    return in_a_room("roughglass", folder, pixels, glasses, 21, size or 5000, depth=12)


def roughmetal(folder, pixels, size):
    """Rough metals under a sky of a picture; path, 8 deep. size: triangles of a knot."""
    metals = [bsdf("roughconductor", text("material", metal), microfacets(kind, alpha))
              for metal, kind, alpha in (("Au", "ggx", 0.1), ("Cu", "beckmann", 0.2), ("Al", "ggx", 0.4))]
    return under_a_sky("roughmetal", folder, pixels, metals, 22, size or 5000)


def textured(folder, pixels, size):
    """Images on a floor and on what stands there, under a lamp in a room; path, 8 deep. size: triangles of a knot."""
    images = [bsdf("diffuse", image("reflectance", scale)) for scale in (1, 3, 8)]
    return scene(folder / "textured.xml", pixels, ("path", 8), ("0, 2, 8", "0, 1, 0", 42), *walls(3.2, 4, 3.2),
                 HALL_LAMP, shape("rectangle", moved(scaled(3, 3, 1), FLOOR_UP, to(0, 0.01, 0)), images[1]),
                 *rows_of(folder, size or 5000, images, 23))


def skylit(folder, pixels, size):
    """Grey knots and spheres under a sky of a picture with a sun in it; path, 6 deep. size: triangles of a knot."""
    return under_a_sky("skylit", folder, pixels, [diffuse(0.7, 0.7, 0.7), diffuse(0.6, 0.3, 0.2)], 24, size or 5000,
                       depth=6)


def plastics(folder, pixels, size):
    """Smooth and rough plastic with images in a room; path, 8 deep. size: triangles of a knot."""
    kinds = [bsdf("plastic", rgb("diffuse_reflectance", 0.2, 0.4, 0.7)),
             bsdf("roughplastic", image("diffuse_reflectance", 3) + microfacets("ggx", 0.15)),
             bsdf("roughplastic", rgb("diffuse_reflectance", 0.7, 0.2, 0.1) + microfacets("beckmann", 0.3))]
    return in_a_room("plastics", folder, pixels, kinds, 25, size or 5000)


def principled(folder, pixels, size):
    """Principled of several looks under a sky, on an image; path, 8 deep. size: triangles of a knot."""
    def look(*colour, **values):
        told = "".join(number(name, float(value)) for name, value in values.items())
        return bsdf("principled", rgb("base_color", *colour) + told)

    looks = [look(0.8, 0.5, 0.2, metallic=1, roughness=0.25, anisotropic=0.5), look(0.2, 0.5, 0.8, roughness=0.4, clearcoat=1),
             look(0.7, 0.2, 0.3, roughness=0.7, sheen=1, specular=0.3)]
    return under_a_sky("principled", folder, pixels, looks, 26, size or 5000, floor=bsdf("diffuse", image("reflectance", 6)))


def normals(folder, pixels, size):
    """Normal maps on rough metal and on diffuse materials in a room; path, 8 deep. size: triangles of a knot."""
    kinds = [bsdf("normalmap", image("normalmap", 3, "rivets.png", RAW), bsdf("roughconductor", microfacets("ggx", 0.2))),
             bsdf("normalmap", image("normalmap", 3, "rivets.png", RAW), diffuse(0.7, 0.3, 0.2))]
    return in_a_room("normals", folder, pixels, kinds, 5, size or 5000)


def bumps(folder, pixels, size):
    """Bump maps on rough plastic and on diffuse materials in a room; path, 8 deep. size: triangles of a knot."""
    kinds = [bsdf("bumpmap", image(None, 4, "waves.png", RAW), number("scale", 0.3),
                  bsdf("roughplastic", rgb("diffuse_reflectance", 0.2, 0.4, 0.7))),
             bsdf("bumpmap", image(None, 3, "waves.png", RAW), number("scale", 0.3), diffuse(0.7, 0.3, 0.2))]
    return in_a_room("bumps", folder, pixels, kinds, 5, size or 5000)


SCENES = {"roughglass": roughglass, "roughmetal": roughmetal, "textured": textured, "skylit": skylit, "plastics": plastics,
          "principled": principled, "normals": normals, "bumps": bumps}
