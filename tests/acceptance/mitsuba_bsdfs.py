#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What Mitsuba 3's materials scatter between directions: the values that tests/physics/test_mitsuba_bsdfs.cpp holds.

mitsuba_bsdfs.py            writes tests/physics/mitsuba_bsdfs.txt anew
mitsuba_bsdfs.py --check    exit status 1 where the installed Mitsuba has other values, 77 where there is none
"""
import math
import pathlib
import sys

FILE = pathlib.Path(__file__).parents[1] / "physics" / "mitsuba_bsdfs.txt"


def microfacets(distribution, alpha, visible=True):
    words = f'<string name="distribution" value="{distribution}"/>'
    if isinstance(alpha, tuple):
        words += f'<float name="alpha_u" value="{alpha[0]}"/><float name="alpha_v" value="{alpha[1]}"/>'
    else:
        words += f'<float name="alpha" value="{alpha}"/>'
    return words + ("" if visible else '<boolean name="sample_visible" value="false"/>')


def bsdfs():
    gold = '<string name="material" value="Au"/>'
    index = '<rgb name="eta" value="1.5, 0.2, 3"/><rgb name="k" value="0.1, 4, 2"/>'
    red = '<rgb name="diffuse_reflectance" value="0.8, 0.3, 0.1"/><rgb name="specular_reflectance" value="0.9, 0.8, 0.7"/>'
    yield "roughconductor", gold + microfacets("beckmann", 0.1)
    yield "roughconductor", '<string name="material" value="Cu"/>' + microfacets("ggx", 0.3)
    yield "roughconductor", index + microfacets("beckmann", (0.05, 0.4))
    yield "roughconductor", gold + microfacets("ggx", (0.4, 0.1)) + '<rgb name="specular_reflectance" value="0.9, 0.5, 0.1"/>'
    yield "roughconductor", index + microfacets("beckmann", 0.8, False)
    yield "roughdielectric", ""
    yield "roughdielectric", microfacets("ggx", 0.4) + '<float name="int_ior" value="1.9"/>'
    yield "roughdielectric", microfacets("beckmann", (0.3, 0.15)) + '<string name="int_ior" value="water"/>'
    yield "plastic", red
    yield "plastic", red + '<boolean name="nonlinear" value="true"/><float name="int_ior" value="1.8"/>'
    yield "roughplastic", red
    yield "roughplastic", red + microfacets("ggx", 0.4) + '<boolean name="nonlinear" value="true"/>'
    yield "roughplastic", red + microfacets("beckmann", 0.02) + '<float name="int_ior" value="1.33"/>'
    thinner = '<float name="int_ior" value="1"/><float name="ext_ior" value="1.49"/>'
    yield "roughplastic", red + microfacets("beckmann", 0.2) + thinner
    yield "roughplastic", red + microfacets("ggx", 0.4) + thinner


    def principled(**values):
        color = '<rgb name="base_color" value="0.8, 0.4, 0.1"/>'
        return color + "".join(f'<float name="{name}" value="{value}"/>' for name, value in values.items())
    yield "principled", ""
    yield "principled", principled(roughness=0.6, metallic=0.7, specular=0.9, spec_tint=0.8, anisotropic=0.5)
    yield "principled", principled(roughness=0.4, clearcoat=0.8, clearcoat_gloss=0.2, sheen=0.7, sheen_tint=0.6, flatness=0.5)
    yield "principled", principled(roughness=0.7, spec_trans=0.6, eta=1.4, metallic=0.2, spec_tint=0.3, flatness=1, clearcoat=1)
    yield "principled", principled(roughness=0.5, spec_trans=1, eta=0.7, anisotropic=0.9)
    yield "principled", principled(roughness=0.3, spec_trans=0.5, specular=0, clearcoat=0.5, clearcoat_gloss=1, sheen=1)
    yield "principledthin", ""
    yield "principledthin", principled(roughness=0.6, spec_trans=0.7, diff_trans=0.8, spec_tint=0.4, anisotropic=0.6, eta=1.7)
    yield "principledthin", principled(roughness=0.5, diff_trans=1.6, sheen=0.8, sheen_tint=0.5, flatness=0.7)
    yield "principled", principled(roughness=0.5, metallic=1, specular=0, clearcoat=1)
    yield "principled", principled(roughness=0.5, metallic=0.6, eta=1, spec_tint=0.5, clearcoat=1)
    yield "principledthin", principled(roughness=1, spec_trans=0.5, eta=1, spec_tint=0.5)
    shiny = '<bsdf type="roughconductor"><float name="alpha" value="0.3"/></bsdf>'
    dull = f'<bsdf type="plastic">{red}</bsdf>'
    yield "blendbsdf", shiny + dull + '<float name="weight" value="0.3"/>'
    inner = f'<bsdf type="blendbsdf"><float name="weight" value="0.8"/>{dull}<bsdf type="diffuse"/></bsdf>'
    yield "blendbsdf", f'<float name="weight" value="0.25"/>{inner}{shiny}'
    yield "blendbsdf", f'<float name="weight" value="0.6"/><bsdf type="roughdielectric"/><bsdf type="twosided">{shiny}</bsdf>'


def directions(cosines, first_turn):
    for number, cosine in enumerate(cosines):
        sine, turn = math.sqrt(max(1 - cosine * cosine, 0)), first_turn + 0.61803 * number
        yield sine * math.cos(2 * math.pi * turn), sine * math.sin(2 * math.pi * turn), cosine


def lines():
    import mitsuba as mi
    mi.set_variant("scalar_rgb")
    yield f"# Written by tests/acceptance/mitsuba_bsdfs.py, Mitsuba {mi.__version__}: a bsdf; wo, wi and f |cos| r g b."
    outs = list(directions([0.99, 0.7, 0.3, 0.05, -0.4, -0.9], 0.1))
    ins = list(directions([0.98, 0.75, 0.5, 0.25, 0.04, -0.1, -0.6, -0.97], 0.37))
    for kind, inside in bsdfs():
        text = f'<bsdf type="{kind}">{inside}</bsdf>'
        bsdf = mi.load_string(text.replace("<bsdf ", '<bsdf version="3.0.0" ', 1))
        yield text
        for wo in outs:
            near = [(-wo[0] + 0.02, -wo[1] - 0.01, wo[2]), (-0.6 * wo[0], -0.6 * wo[1] + 0.03, -wo[2])]
            for wi in ins + near:
                si = mi.SurfaceInteraction3f()
                si.wi = mi.Vector3f(*wo)
                length = math.sqrt(sum(x * x for x in wi))
                wi = [x / length for x in wi]
                value = bsdf.eval(mi.BSDFContext(), si, mi.Vector3f(*wi))
                if max(value) > 0:
                    yield " ".join(f"{x:.9g}" for x in [*wo, *wi, *value])


def differ(written, found):
    """Exit status: whether the values of two texts differ by more than 1e-4."""
    def numbers(whole):
        return [[float(x) for x in line.split()] for line in whole.splitlines() if line[0] not in "#<"]
    ours, theirs = numbers(written), numbers(found)
    far = [(a, b) for a, b in zip(ours, theirs) if any(abs(x - y) > 1e-4 * max(abs(y), 1e-6) for x, y in zip(a, b))]
    print(f"{len(theirs)} values, {len(far)} differ, {abs(len(ours) - len(theirs))} missing")
    return 1 if far or len(ours) != len(theirs) else 0


def main(lines, file):
    """Writes these lines to the file or, with --check, compares them with it."""
    try:
        text = "\n".join(lines()) + "\n"
    except ImportError as missing:
        print(f"skipped: {missing}")
        return 77
    if "--check" not in sys.argv:
        file.write_text(text)
        return 0
    return differ(file.read_text(), text)


if __name__ == "__main__":
    sys.exit(main(lines, FILE))
