#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What Mitsuba 3's normal and bump maps scatter between directions: the values that tests/physics/test_reliefs.cpp
holds.

mitsuba_reliefs.py            writes tests/physics/mitsuba_reliefs.txt anew
mitsuba_reliefs.py --check    exit status 1 where the installed Mitsuba has other values, 77 where there is none
"""
import pathlib
import sys

from mitsuba_bsdfs import directions, main

FILE = pathlib.Path(__file__).parents[1] / "physics" / "mitsuba_reliefs.txt"
ROOT = pathlib.Path(__file__).parents[2]

WHITE = '<bsdf type="diffuse"><rgb name="reflectance" value="1"/></bsdf>'
METAL = '<bsdf type="roughconductor"><float name="alpha_u" value="0.5"/><float name="alpha_v" value="0.2"/></bsdf>'
GLASS = '<bsdf type="roughdielectric"><float name="alpha" value="0.4"/></bsdf>'
LETTER = '<string name="filename" value="ROOT/scenes/textures/letter.png"/><boolean name="raw" value="true"/>'


def option(name, value="false"):
    return f'<boolean name="{name}" value="{value}"/>'


def bsdfs():
    for normal in "0.8, 0.6, 0.9", "0.1, 0.3, 0.75", "0.5, 0.5, 1", "0.95, 0.5, 0.53":
        for inside in WHITE, METAL:
            yield "normalmap", f'<rgb name="normalmap" value="{normal}"/>{inside}'
    tilted = '<rgb name="normalmap" value="0.75, 0.3, 0.85"/>'
    yield "normalmap", tilted + GLASS
    yield "normalmap", tilted + WHITE + option("flip_invalid_normals")
    yield "normalmap", tilted + METAL + option("use_shadowing_function")
    yield "normalmap", tilted + f'<bsdf type="twosided">{METAL}</bsdf>'
    yield "twosided", f'<bsdf type="normalmap">{tilted}{METAL}</bsdf>'
    yield "normalmap", f'<texture type="bitmap" name="normalmap">{LETTER}</texture>{WHITE}'
    heights = f'<texture type="bitmap" name="heights">{LETTER}</texture>'
    yield "bumpmap", heights + WHITE + '<float name="scale" value="0.1"/>'
    yield "bumpmap", heights + f'<bsdf type="twosided">{METAL}</bsdf>'
    turned = '<transform name="to_uv"><rotate z="1" angle="30"/><scale x="3" y="0.5"/></transform>'
    wrapped = f'<texture type="bitmap" name="heights">{LETTER}{turned}<string name="wrap_mode" value="mirror"/></texture>'
    yield "twosided", f'<bsdf type="bumpmap">{wrapped}{METAL}<float name="scale" value="-0.2"/></bsdf>'


def lines():
    import mitsuba as mi
    mi.set_variant("scalar_rgb")
    yield f"# Written by tests/acceptance/mitsuba_reliefs.py, Mitsuba {mi.__version__}: a bsdf; u, v, wo, wi, f |cos| r g b."
    outs = list(directions([0.97, 0.6, 0.2, -0.5], 0.23))
    ins = list(directions([0.95, 0.7, 0.4, 0.1, -0.2, -0.8], 0.61))
    for kind, inside in bsdfs():
        text = f'<bsdf type="{kind}">{inside}</bsdf>'
        bsdf = mi.load_string(text.replace("<bsdf ", '<bsdf version="3.0.0" ', 1).replace("ROOT", str(ROOT)))
        yield text
        for number, wo in enumerate(outs):
            # Without turned normals Mitsuba reflects views from below to above the surface.
            if "flip_invalid" in text and wo[2] < 0:
                continue
            for wi in ins:
                si = mi.SurfaceInteraction3f()
                si.sh_frame = mi.Frame3f(mi.Vector3f(1, 0, 0), mi.Vector3f(0, 1, 0), mi.Vector3f(0, 0, 1))
                si.n, si.dp_du, si.dp_dv = [0, 0, 1], [1, 0, 0], [0, 1, 0]
                si.uv = [0.21 + 0.17 * number, 0.43 - 0.13 * number]
                si.wi = mi.Vector3f(*wo)
                value = bsdf.eval(mi.BSDFContext(), si, mi.Vector3f(*wi))
                yield " ".join(f"{x:.9g}" for x in [*si.uv, *wo, *wi, *value])


if __name__ == "__main__":
    sys.exit(main(lines, FILE))
