# SPDX-License-Identifier: MIT
"""Four variants of each material a scene. Blends hold no mirrors or glass: Mitsuba 3.9 loses light of theirs."""

from pictures.stage import *

RED = rgb("diffuse_reflectance", "0.8, 0.3, 0.1")
METAL = rgb("eta", "0.2, 0.9, 1.1") + rgb("k", "3.9, 2.4, 2.1")
TUBE_PLATE_BALL_BLOCK = (tube, plate, ball, block)
BALL_SHEET_TUBE_BLOCK = (ball, sheet, tube, block)


def facets(distribution, alpha, across=None, visible=True):
    width = number("alpha", alpha) if across is None else numbers(alpha_u=alpha, alpha_v=across)
    return string("distribution", distribution) + width + ("" if visible else boolean("sample_visible", False))


def of(kind):
    return lambda *inside: bsdf(kind, *inside)


def glass(kind):
    """Without roughness."""
    return four(
        kind(),
        kind(number("int_ior", 1.8), rgb("specular_transmittance", "0.9, 0.5, 0.2")),
        kind(number("int_ior", 0.75), rgb("specular_reflectance", "0.4, 0.9, 0.6")),
        kind(string("int_ior", "diamond"), string("ext_ior", "water")),
        integrator=path(12),
    )


def disney(kind, color="0.8, 0.4, 0.1", inside="", **values):
    return bsdf(kind, rgb("base_color", color), numbers(**values), inside)


def normals(inside, more=""):
    return bsdf("normalmap", bitmap("normalmap", "rivets.png", RAW, more), inside)


def bumps(inside, scale=0.05, more=""):
    return bsdf("bumpmap", bitmap("map", "waves.png", RAW, more), number("scale", scale), inside)


diffuse, conductor, plastic = of("diffuse"), of("conductor"), of("plastic")
rough_metal, rough_glass, rough_plastic = of("roughconductor"), of("roughdielectric"), of("roughplastic")
AU = string("material", "Au")
PICTURES = {
    "diffuse": four(
        diffuse(rgb("reflectance", "0.9, 0.2, 0.1")),
        twosided(diffuse(bitmap("reflectance"))),
        twosided(diffuse(checker("reflectance", "0.9", "0.1, 0.5, 0.2"))),
        diffuse(),
    ),
    "dielectric": glass(of("dielectric")),
    "thindielectric": glass(of("thindielectric")),
    "roughdielectric": four(
        rough_glass(facets("beckmann", 0.1)),
        rough_glass(
            facets("ggx", 0.3, 0.05),
            number("int_ior", 1.8),
            checker("specular_transmittance", "0.9, 0.5, 0.2", "0.2, 0.8, 0.9"),
        ),
        rough_glass(facets("ggx", 0.4), number("int_ior", 0.75), rgb("specular_reflectance", "0.4, 0.9, 0.6")),
        rough_glass(facets("beckmann", 0.6, visible=False), string("int_ior", "diamond"), string("ext_ior", "water")),
        integrator=path(10),
    ),
    "roughdielectric-textured": four(
        rough_glass(facets("ggx", 0.01)),
        rough_glass(string("distribution", "ggx"), bitmap("alpha", "rivets.png", RAW), number("int_ior", 1.4)),
        rough_glass(facets("beckmann", 0.02), number("int_ior", 1.33)),
        rough_glass(facets("ggx", 1, 0.4), string("int_ior", "bk7")),
        integrator=path(10),
    ),
    "conductor": four(
        conductor(AU),
        twosided(conductor(string("material", "Cu"), bitmap("specular_reflectance"))),
        conductor(METAL),
        conductor(string("material", "none"), rgb("specular_reflectance", "0.9, 0.8, 0.3")),
    ),
    "roughconductor": four(
        rough_metal(AU, facets("beckmann", 0.1)),
        twosided(rough_metal(string("material", "Cu"), facets("ggx", 0.3, 0.08))),
        rough_metal(METAL, facets("beckmann", 0.05, 0.5)),
        rough_metal(facets("ggx", 0.3, 0.05), rgb("specular_reflectance", "0.9, 0.8, 0.3")),
    ),
    "roughconductor-textured": four(
        rough_metal(string("material", "Cr"), facets("beckmann", 0.005)),
        twosided(
            rough_metal(
                string("distribution", "beckmann"),
                checker("alpha_u", "0.1", "0.4"),
                number("alpha_v", 0.2),
                bitmap("specular_reflectance"),
            )
        ),
        rough_metal(METAL, facets("beckmann", 0.5, visible=False)),
        rough_metal(string("distribution", "ggx"), bitmap("alpha", "rivets.png", RAW)),
        carriers=(ball, sheet, ring, ring),
    ),
    "roughconductor-turned": four(
        rough_metal(string("material", "Cr"), facets("ggx", 0.02, 0.3)),
        twosided(rough_metal(facets("ggx", 0.002))),
        rough_metal(facets("beckmann", 1)),
        rough_metal(string("material", "VN"), facets("beckmann", 0.3, 0.05)),
        carriers=TUBE_PLATE_BALL_BLOCK,
    ),
    "plastic": four(
        plastic(RED),
        twosided(plastic(bitmap("diffuse_reflectance"), boolean("nonlinear", True), number("int_ior", 1.9))),
        plastic(RED, number("int_ior", 1.3), rgb("specular_reflectance", "0.5, 0.9, 0.6")),
        plastic(rgb("diffuse_reflectance", 0.95), boolean("nonlinear", True), string("ext_ior", "water")),
    ),
    "roughplastic": four(
        rough_plastic(RED),
        twosided(
            rough_plastic(
                bitmap("diffuse_reflectance"), boolean("nonlinear", True), number("int_ior", 1.9), facets("ggx", 0.3)
            )
        ),
        rough_plastic(
            RED, number("int_ior", 1.3), rgb("specular_reflectance", "0.5, 0.9, 0.6"), facets("beckmann", 0.02)
        ),
        rough_plastic(
            rgb("diffuse_reflectance", 0.95), boolean("nonlinear", True), string("ext_ior", "water"), facets("ggx", 0.8)
        ),
    ),
    "principled": four(
        disney("principled", roughness=0.6, metallic=0.7, specular=0.9, spec_tint=0.8, anisotropic=0.5),
        twosided(
            disney(
                "principled", roughness=0.4, clearcoat=0.8, clearcoat_gloss=0.2, sheen=0.7, sheen_tint=0.6, flatness=0.5
            )
        ),
        disney(
            "principled", roughness=0.7, spec_trans=0.6, eta=1.4, metallic=0.2, spec_tint=0.3, flatness=1, clearcoat=1
        ),
        disney("principled", roughness=0.5, spec_trans=1, eta=0.7, anisotropic=0.9),
        integrator=path(8),
    ),
    "principled-textured": four(
        disney("principled", roughness=0.15, metallic=1, anisotropic=0.9),
        twosided(
            bsdf("principled", bitmap("base_color"), bitmap("roughness", "rivets.png", RAW), checker("metallic", 1, 0))
        ),
        bsdf(
            "principled",
            checker("spec_trans", 0.2, 0.9),
            checker("flatness", 0, 1),
            checker("sheen_tint", 0, 1),
            checker("clearcoat_gloss", 0, 1),
            numbers(sheen=1, clearcoat=1),
        ),
        twosided(
            bsdf(
                "principled",
                checker("base_color", "0.9", "0.1, 0.2, 0.5"),
                checker("sheen", 0, 1),
                checker("clearcoat", 1, 0.2),
                checker("anisotropic", 0, 0.9),
                checker("spec_tint", 0, 0.9),
                number("roughness", 0.35),
            )
        ),
        carriers=(ball, sheet, ring, plate),
        integrator=path(8),
    ),
    "principled-rates": four(
        disney("principled", roughness=0.3, spec_trans=0.5, specular=0, clearcoat=0.5, clearcoat_gloss=1, sheen=1),
        twosided(disney("principled", roughness=0.3, specular=1)),
        disney("principled", roughness=1, metallic=1),
        disney(
            "principled",
            roughness=0.05,
            clearcoat=1,
            clearcoat_gloss=0.9,
            main_specular_sampling_rate=0.3,
            diffuse_reflectance_sampling_rate=2,
        ),
        carriers=TUBE_PLATE_BALL_BLOCK,
        integrator=path(8),
    ),
    "principledthin": four(
        disney(
            "principledthin", roughness=0.6, spec_trans=0.7, diff_trans=0.8, spec_tint=0.4, anisotropic=0.6, eta=1.7
        ),
        disney("principledthin", roughness=0.5, diff_trans=1.6, sheen=0.8, sheen_tint=0.5, flatness=0.7),
        disney("principledthin", roughness=0.2, spec_trans=1, eta=1.3),
        bsdf("principledthin"),
        integrator=path(8),
    ),
    "principledthin-textured": four(
        disney("principledthin", roughness=0.3, spec_trans=0.3, diff_trans=0.3, eta=1.3, anisotropic=0.9),
        bsdf(
            "principledthin",
            bitmap("base_color"),
            checker("spec_trans", 0.1, 0.9),
            checker("diff_trans", 0.1, 0.9),
            checker("anisotropic", 0, 0.9),
            checker("sheen", 1, 0),
            number("eta", 1.6),
        ),
        disney("principledthin", roughness=0.9, diff_trans=1, flatness=1),
        disney("principledthin", roughness=0.1, spec_trans=0.8, eta=2),
        carriers=(tube, plate, sheet, block),
        integrator=path(8),
    ),
    "mask": four(
        bsdf("mask", number("opacity", 0.3), DIFFUSE),
        bsdf("mask", bitmap("opacity"), twosided(DIFFUSE)),
        bsdf("mask", rgb("opacity", "0.9, 0.5, 0.1"), rough_metal(facets("ggx", 0.2))),
        bsdf("mask", checker("opacity", 1, 0), bsdf("dielectric")),
        carriers=(ball, sheet, ring, plate),
        integrator=path(12),
    ),
    "mask-nested": four(
        bsdf("mask", number("opacity", 0.7), bsdf("mask", number("opacity", 0.6), DIFFUSE)),
        bsdf("mask", bitmap("opacity"), bsdf("mask", checker("opacity", 0.9, 0.4), twosided(DIFFUSE))),
        bsdf("mask", number("opacity", 0.9), bsdf("blendbsdf", number("weight", 0.5), DIFFUSE, bsdf("mask", number("opacity", 0.5), DIFFUSE))),
        bsdf("mask", checker("opacity", 1, 0), bsdf("mask", number("opacity", 0.6), rough_plastic(RED))),
        carriers=(ball, sheet, ring, plate),
        integrator=path(12),
    ),
    "blendbsdf": four(
        bsdf("blendbsdf", number("weight", 0.3), DIFFUSE, rough_metal(facets("ggx", 0.2))),
        twosided(bsdf("blendbsdf", bitmap("weight"), DIFFUSE, rough_metal(AU))),
        bsdf(
            "blendbsdf",
            checker("weight", 0.8, 0.1),
            bsdf("blendbsdf", number("weight", 0.6), rough_glass(facets("ggx", 0.3)), DIFFUSE),
            rough_plastic(RED),
        ),
        bsdf("blendbsdf", rgb("weight", "0.9, 0.5, 0.1"), rough_glass(), twosided(rough_metal(facets("ggx", 0.3)))),
        integrator=path(10),
    ),
    "normalmap": four(
        normals(DIFFUSE),
        twosided(normals(rough_metal(facets("ggx", 0.2)))),
        normals(plastic(RED), to_uv('<scale value="3"/>')),
        normals(disney("principled", roughness=0.4, clearcoat=1)),
        carriers=BALL_SHEET_TUBE_BLOCK,
    ),
    "bumpmap": four(
        bumps(DIFFUSE),
        twosided(bumps(rough_metal(facets("beckmann", 0.2)), 0.2)),
        bumps(plastic(RED), 0.1, to_uv('<scale value="3"/>')),
        bumps(disney("principled", roughness=0.4, clearcoat=1), 0.3),
        carriers=BALL_SHEET_TUBE_BLOCK,
    ),
    "nested": four(
        bsdf(
            "mask",
            number("opacity", 0.8),
            bumps(bsdf("blendbsdf", number("weight", 0.5), DIFFUSE, rough_plastic(RED)), 0.1),
        ),
        twosided(bsdf("blendbsdf", checker("weight", 1, 0), bumps(DIFFUSE, 0.2), normals(rough_metal(AU)))),
        twosided(rough_metal(facets("ggx", 0.3)), normals(DIFFUSE)),
        bumps(rough_plastic(RED, facets("ggx", 0.3)), 0.1),
        carriers=BALL_SHEET_TUBE_BLOCK,
    ),
    "twosided": four(
        twosided(DIFFUSE, plastic(RED)),
        twosided(DIFFUSE, rough_metal(AU, facets("ggx", 0.2))),
        twosided(disney("principled", roughness=0.3, anisotropic=0.9, metallic=1), DIFFUSE),
        twosided(rough_plastic(facets("ggx", 0.3)), conductor()),
        carriers=(tube, backward, plate, ring),
    ),
    "flipped": four(
        twosided(rough_metal(facets("ggx", 0.3, 0.05))) + boolean("flip_normals", True),
        rough_glass(facets("ggx", 0.2)) + boolean("flip_normals", True),
        twosided(DIFFUSE, plastic(RED)) + boolean("flip_normals", True),
        bsdf("dielectric") + boolean("flip_normals", True),
        carriers=(ball, sheet, plate, ring),
        integrator=path(8),
    ),
}
