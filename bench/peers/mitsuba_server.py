# SPDX-License-Identifier: MIT
"""Mitsuba 3 as a peer: mitsuba_server.py SCENE.xml SPP VARIANT SAMPLER, with Mitsuba's Python (pip install mitsuba).

Loads the scene once and renders one picture, which compiles its kernels; then as answers.py has it. SAMPLER:
independent, stratified, multijitter, orthogonal or ldsampler in the scene's sampler's place.
"""
import sys
import time

from answers import serve  # Before mitsuba: Dr.Jit writes its warnings to standard output.

import mitsuba as mi


def main():
    scene_file, spp, variant, sampler = sys.argv[1], int(sys.argv[2]), sys.argv[3], sys.argv[4]
    mi.set_variant(variant)
    import drjit
    with open(scene_file, encoding="utf-8") as file:
        text = file.read().replace('<sampler type="independent">', f'<sampler type="{sampler}">')
    changed = scene_file.replace(".xml", f"-{sampler}.xml")
    with open(changed, "w", encoding="utf-8") as file:
        file.write(text)
    scene = mi.load_file(changed)

    def rendered(seed):
        start = time.perf_counter()
        picture = mi.render(scene, spp=spp, seed=seed)
        drjit.eval(picture)
        drjit.sync_thread()
        return picture, time.perf_counter() - start

    def render(seed, path):
        picture, seconds = rendered(seed)
        mi.Bitmap(picture).write(path)
        return seconds

    rendered(1 << 20)
    serve(f"Mitsuba {mi.__version__} {variant} {sampler}", render)


if __name__ == "__main__":
    main()
