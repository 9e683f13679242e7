# SPDX-License-Identifier: MIT
"""LuxCore on the CPU as a peer: luxcore_server.py SCENE.xml SPP THREADS, with a Python that has pyluxcore (pip install
pyluxcore).

A Cornell box as cornell.py reads it, by PATHCPU and LuxCore's default sampler. Then as answers.py has it.
"""
import sys
import time

from answers import serve  # Before pyluxcore, which writes to standard output.

import pyluxcore

from cornell import read_box


def properties(entries):
    made = pyluxcore.Properties()
    for name, value in entries.items():
        made.Set(pyluxcore.Property(name, list(value) if isinstance(value, (tuple, list)) else value))
    return made


def add_surface(scene, surface):
    corners = [corner for face in surface.faces for corner in face]
    triangles = []
    for first in range(0, len(corners), 4):
        triangles += [(first, first + 1, first + 2), (first, first + 2, first + 3)]
    scene.DefineMesh(surface.name, corners, triangles, None, None, None, None)
    material = f"scene.materials.{surface.name}."
    entries = {material + "type": "matte", material + "kd": surface.reflectance}
    if surface.radiance is not None:
        entries |= {material + "emission": surface.radiance, material + "emission.gain": (1.0, 1.0, 1.0)}
    scene.Parse(properties(entries))
    thing = f"scene.objects.{surface.name}."
    scene.Parse(properties({thing + "shape": surface.name, thing + "material": surface.name}))


def main():
    box, spp, threads = read_box(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
    pyluxcore.Init(lambda message: None)
    if box.width != box.height:
        sys.exit("luxcore_server: square pictures only")
    scene = pyluxcore.Scene()
    # LuxCore 2.11's pictures stand a pixel lower than others'.
    pixel = 2 / box.height
    scene.Parse(properties({
        "scene.camera.type": "perspective", "scene.camera.lookat.orig": box.origin,
        "scene.camera.lookat.target": box.target, "scene.camera.up": box.up, "scene.camera.fieldofview": box.fov,
        "scene.camera.screenwindow": (-1.0, 1.0, -1 - pixel, 1 - pixel)}))
    for surface in box.surfaces:
        add_surface(scene, surface)

    def render(seed, path):
        config = pyluxcore.RenderConfig(properties({
            "renderengine.type": "PATHCPU", "renderengine.seed": seed + 1, "native.threads.count": threads,
            "film.width": box.width, "film.height": box.height, "film.filter.type": "BOX",
            "film.filter.xwidth": 0.5, "film.filter.ywidth": 0.5, "path.clamping.variance.maxvalue": 0.0,
            "path.pathdepth.total": box.max_depth, "path.pathdepth.diffuse": box.max_depth,
            "batch.haltspp": spp}), scene)
        session = pyluxcore.RenderSession(config)
        start = time.perf_counter()
        session.Start()
        while not session.HasDone():
            time.sleep(0.02)
            session.UpdateStats()
        seconds = time.perf_counter() - start
        session.Stop()
        session.GetFilm().SaveOutput(path, pyluxcore.FilmOutputType.RGB, pyluxcore.Properties())
        return seconds

    serve(f"LuxCore {pyluxcore.Version()} PATHCPU", render)


if __name__ == "__main__":
    main()
