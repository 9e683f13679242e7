# SPDX-License-Identifier: MIT
"""Mitsuba 3 as a peer: mitsuba_server.py SCENE.xml SPP VARIANT SAMPLER, with Mitsuba's Python (pip install mitsuba).

Loads the scene once and renders one picture, which compiles its kernels. Then, for each line "SEED FILE.exr" on standard
input, renders with that seed, prints the seconds of rendering alone, and writes the picture. SAMPLER: independent,
stratified, multijitter, orthogonal or ldsampler in the scene's sampler's place.
"""
import os
import sys
import time

# Dr.Jit writes its warnings to standard output, where the answers go: they keep that for themselves.
answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
os.dup2(2, 1)

import mitsuba as mi  # noqa: E402


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

    def render(seed):
        start = time.perf_counter()
        picture = mi.render(scene, spp=spp, seed=seed)
        drjit.eval(picture)
        drjit.sync_thread()
        return picture, time.perf_counter() - start

    render(1 << 20)
    print(f"Mitsuba {mi.__version__} {variant} {sampler}", file=answers, flush=True)
    for line in sys.stdin:
        seed, path = line.split()
        picture, seconds = render(int(seed))
        mi.Bitmap(picture).write(path)
        print(seconds, file=answers, flush=True)


if __name__ == "__main__":
    main()
