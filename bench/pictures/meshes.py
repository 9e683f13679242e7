# SPDX-License-Identifier: MIT
"""Meshes of any number of triangles as PLY files: torus knots, spheres and landscapes."""
import array
import math
import random
import struct


def write_ply(path, vertices, faces):
    """vertices: (x, y, z) each, or with normals nx, ny, nz, or with texture coordinates u, v behind these; faces: three
    indices each."""
    names = ("x", "y", "z", "nx", "ny", "nz", "u", "v")[:len(vertices[0])]
    with open(path, "wb") as file:
        header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(vertices)}"]
        header += [f"property float {name}" for name in names]
        header += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
        file.write(("\n".join(header) + "\n").encode("ascii"))
        row = struct.Struct(f"<{len(names)}f")
        file.write(b"".join(row.pack(*vertex) for vertex in vertices))
        row = struct.Struct("<B3i")
        file.write(b"".join(row.pack(3, *face) for face in faces))


def grid_faces(columns, rows, around):
    """Two triangles a cell of a grid of vertices, row by row; around: the grid closes in both directions."""
    faces = []
    for i in range(columns if around else columns - 1):
        for j in range(rows if around else rows - 1):
            a, b = i * rows + j, (i + 1) % columns * rows + j
            c, d = (i + 1) % columns * rows + (j + 1) % rows, i * rows + (j + 1) % rows
            faces += [(a, b, c), (a, c, d)]
    return faces


def normalized(v):
    length = math.sqrt(sum(x * x for x in v))
    return tuple(x / length for x in v)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def knot(triangles, thickness=0.35, has_uvs=False):
    """A (2, 3) torus knot within a ball of radius 1 around the origin, with normals that point outwards; u along it, v
    around it."""
    rows = max(6, round(math.sqrt(triangles / 12.5)))
    columns = max(24, round(triangles / (2 * rows)))
    size = 3 + thickness
    vertices = []

    def centre(u):
        r = 2 + math.cos(3 * u)
        return (r * math.cos(2 * u), r * math.sin(2 * u), -math.sin(3 * u))

    for i in range(columns):
        u = 2 * math.pi * i / columns
        here = centre(u)
        along = normalized(tuple(b - a for a, b in zip(centre(u - 1e-3), centre(u + 1e-3))))
        side = normalized(cross(along, here))
        other = cross(side, along)
        for j in range(rows):
            c, s = math.cos(2 * math.pi * j / rows), math.sin(2 * math.pi * j / rows)
            normal = tuple(c * a + s * b for a, b in zip(other, side))
            uv = (i / columns, j / rows) if has_uvs else ()
            vertices.append(tuple((p + thickness * n) / size for p, n in zip(here, normal)) + normal + uv)
    return vertices, [(a, c, b) for a, b, c in grid_faces(columns, rows, True)]


def icosahedron(triangles=20):
    """Radius 1, without normals; each of its triangles divided into four until there are so many or more."""
    g = (1 + math.sqrt(5)) / 2
    corners = [normalized(v) for v in [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
                                       (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
             (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10),
             (8, 6, 7), (9, 8, 1)]
    while len(faces) < triangles:
        middles, finer = {}, []

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(corners)
                corners.append(normalized(tuple((x + y) / 2 for x, y in zip(corners[a], corners[b]))))
            return middles[key]

        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = finer
    return corners, faces


def terrain(triangles, seed=1):
    """Hills over [-1, 1]^2 that face up (y): octaves of smoothed random heights, each half as high and twice as fine."""
    side = round(math.sqrt(triangles / 2)) + 1
    chance = random.Random(seed)
    heights = array.array("d", bytes(8 * side * side))
    height, cells = 0.12, 3
    while 2 * cells < side:
        lattice = [[chance.uniform(-height, height) for _ in range(cells + 2)] for _ in range(cells + 2)]
        steps = []
        for k in range(side):
            place = k * cells / (side - 1)
            cell = min(int(place), cells - 1)
            f = place - cell
            steps.append((cell, f * f * (3 - 2 * f)))
        for i, (ci, fi) in enumerate(steps):
            low, high = lattice[ci], lattice[ci + 1]
            across = [a + fi * (b - a) for a, b in zip(low, high)]
            for j, (cj, fj) in enumerate(steps):
                heights[i * side + j] += across[cj] + fj * (across[cj + 1] - across[cj])
        height, cells = height / 2, cells * 2
    vertices = [(2 * i / (side - 1) - 1, heights[i * side + j], 2 * j / (side - 1) - 1)
                for i in range(side) for j in range(side)]
    return vertices, [(a, c, b) for a, b, c in grid_faces(side, side, False)]
