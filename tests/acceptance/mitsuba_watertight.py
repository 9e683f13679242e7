#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Rays that leave closed convex meshes between their triangles: Mitsuba 3, Mitsuba's robust option, strahl.

mitsuba_watertight.py STRAHL [RAYS]: needs Python's mitsuba and numpy (exit code 77 where they are not there). Six
closed convex meshes of 20,480 triangles; from points inside, RAYS rays a mesh (default 2000) are aimed exactly at
vertices and at points of edges, and as many along the axes. Each must hit. Prints the table of docs/numerics.md and
fails where strahl's robust tier loses a ray.
"""
import pathlib
import subprocess
import sys
import tempfile

try:
    import mitsuba as mi
    import numpy as np
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

# Its rays one by one: no LLVM is needed. Both its CPU variants leave intersection to Embree.
mi.set_variant("scalar_rgb")


def sphere():
    """A subdivided icosahedron: 20,480 triangles."""
    g = (1 + 5 ** 0.5) / 2
    points = [np.array(p, float) / np.linalg.norm(p) for p in (
        (-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
        (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1))]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
             (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10),
             (8, 6, 7), (9, 8, 1)]
    for _ in range(5):
        middles, finer = {}, []

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                m = points[a] + points[b]
                middles[key] = len(points)
                points.append(m / np.linalg.norm(m))
            return middles[key]

        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        faces = finer
    return np.array(points), np.array(faces, dtype=np.uint32)


MESHES = {
    "unit": (np.array([1.0, 1, 1]), 0.0),
    "needle": (np.array([1.0, 1e-3, 1e-3]), 0.0),
    "offset": (np.array([1.0, 1, 1]), 1e5),
    "tiny": (np.array([1e-6, 1e-6, 1e-6]), 0.0),
    "huge": (np.array([1e6, 1e6, 1e6]), 0.0),
    "flat": (np.array([1.0, 1, 1e-3]), 0.0),
}


def write_ply(path, points, faces):
    corners = np.empty(len(faces), dtype=[("n", "u1"), ("i", "<u4", 3)])
    corners["n"], corners["i"] = 3, faces
    with open(path, "wb") as file:
        file.write(b"ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty float x\nproperty float y\n"
                   b"property float z\nelement face %d\nproperty list uchar uint vertex_indices\nend_header\n"
                   % (len(points), len(faces)))
        file.write(points.astype("<f4").tobytes() + corners.tobytes())


def aimed_rays(rng, points, faces, size, offset, count):
    """float32 origins inside; directions to vertices (half) and to points of edges, and then along the axes."""
    inside = rng.normal(size=(count, 3))
    inside *= (rng.random(count) ** (1 / 3) * 0.5 / np.linalg.norm(inside, axis=1))[:, None]
    origins = (inside * size + offset).astype(np.float32)
    targets = points[rng.integers(0, len(points), count)].astype(np.float64)
    edge = faces[rng.integers(0, len(faces), count)]
    along = rng.random((count, 1))
    on_edge = points[edge[:, 0]] * (1 - along) + points[edge[:, 1]] * along
    targets[count // 2:] = on_edge[count // 2:]
    aimed = (targets - origins).astype(np.float32)
    axes = np.zeros((count, 3), np.float32)
    axes[np.arange(count), rng.integers(0, 3, count)] = rng.choice([-1, 1], count)
    return np.concatenate([origins, origins]), np.concatenate([aimed, axes])


def mitsuba_hits(ply, origins, directions, robust):
    scene = mi.load_dict({"type": "scene", "embree_use_robust_intersections": robust,
                          "mesh": {"type": "ply", "filename": str(ply)}})
    lengths = np.linalg.norm(directions.astype(np.float64), axis=1)[:, None]
    directions = (directions / lengths).astype(np.float32)
    return np.array([scene.ray_intersect_preliminary(mi.Ray3f(list(map(float, o)), list(map(float, d)))).is_valid()
                     for o, d in zip(origins, directions)])


def strahl_hits(program, folder, ply, origins, directions):
    rays = np.zeros((len(origins), 8), np.float32)
    rays[:, :3], rays[:, 3:6], rays[:, 7] = origins, directions, np.inf
    np.save(folder / "rays.npy", rays)
    subprocess.run([program, "intersect", str(ply), "--rays", str(folder / "rays.npy"), "-o", str(folder / "hits.npy"),
                    "--precision", "robust", "-q"], check=True)
    return np.load(folder / "hits.npy")[:, 2] >= 0


def main():
    program, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 2000
    rng = np.random.default_rng(4)
    points, faces = sphere()
    lost = {}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        print(f"Mitsuba {mi.__version__} ({mi.variant()}), {count} aimed rays a mesh and {count} along the axes\n")
        print("| mesh | rays aimed | Mitsuba | with its robust option | strahl robust | along the axes, likewise |")
        print("|---|---|---|---|---|---|")
        for mesh, (size, offset) in MESHES.items():
            placed = (points * size + offset).astype(np.float32)
            write_ply(folder / "mesh.ply", placed, faces)
            origins, directions = aimed_rays(rng, placed.astype(np.float64), faces, size, offset, count)
            hits = [mitsuba_hits(folder / "mesh.ply", origins, directions, False),
                    mitsuba_hits(folder / "mesh.ply", origins, directions, True),
                    strahl_hits(program, folder, folder / "mesh.ply", origins, directions)]
            aimed = [int(np.sum(~h[:count])) for h in hits]
            axes = [int(np.sum(~h[count:])) for h in hits]
            lost[mesh] = aimed[2] + axes[2]
            print(f"| {mesh} | {count} | {aimed[0]} | {aimed[1]} | {aimed[2]} | {axes[0]}, {axes[1]}, {axes[2]} |",
                  flush=True)
    sys.exit(1 if any(lost.values()) else 0)


if __name__ == "__main__":
    main()
