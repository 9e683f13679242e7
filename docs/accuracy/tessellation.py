# SPDX-License-Identifier: MIT
"""A sphere by its equation against meshes of 10^2 to 10^6 triangles, flat and with the sphere's normals at the corners:
scenes/shapes/sphere.xml with its sphere exchanged."""
import array
import math
import sys

from plot import plot
from program import ROOT, scientific, table

RINGS = [6, 16, 50, 158, 500]


def write_sphere(path, rings, smooth):
    """Circles of latitude of twice as many corners, and two poles."""
    around = 2 * rings
    corners = [(0.0, 1.0, 0.0)]
    for ring in range(1, rings):
        theta = math.pi * ring / rings
        corners += [(math.sin(theta) * math.cos(2 * math.pi * i / around), math.cos(theta),
                     math.sin(theta) * math.sin(2 * math.pi * i / around)) for i in range(around)]
    corners.append((0.0, -1.0, 0.0))
    south = len(corners) - 1
    faces = []
    for i in range(around):
        j = (i + 1) % around
        faces += [(0, 1 + j, 1 + i), (south, south - around + i, south - around + j)]
        for first in range(1, south - around, around):
            below = first + around
            faces += [(first + i, first + j, below + i), (first + j, below + j, below + i)]
    normals = "property float nx\nproperty float ny\nproperty float nz\n" if smooth else ""
    values = array.array("f", [v for corner in corners for v in (corner + corner if smooth else corner)])
    count = len(faces)
    assert sys.byteorder == "little"
    with open(path, "wb") as file:
        file.write(f"ply\nformat binary_little_endian 1.0\nelement vertex {len(corners)}\nproperty float x\n"
                   f"property float y\nproperty float z\n{normals}element face {count}\n"
                   "property list uchar int vertex_indices\nend_header\n".encode())
        file.write(values.tobytes())
        file.write(b"".join(b"\x03" + array.array("i", face).tobytes() for face in faces))
    return count


def measure(strahl):
    text = (ROOT / "scenes/shapes/sphere.xml").read_text(encoding="utf-8")
    text = text.replace('"stage.xml"', f'"{ROOT}/scenes/shapes/stage.xml"')
    begin, end = text.index('<shape type="sphere">'), text.index("</shape>") + len("</shape>")
    options = ["-D", "res=256", "--spp", "16"]

    def best(scene, name):
        stats = [strahl.render(scene, name, *options) for _ in range(strahl.rounds)]
        return {"kernel": min(s["seconds"]["kernel"] for s in stats), "bytes": stats[0]["bytes"]["device"],
                "prepare": min(s["seconds"]["load"] + s["seconds"]["bvh"] + s["seconds"]["upload"] for s in stats)}

    results = [{"kind": "sphere", "triangles": 0, "rmse": 0, "flip": 0,
                **best(ROOT / "scenes/shapes/sphere.xml", "sphere.exr")}]
    for rings in RINGS:
        for smooth in (False, True):
            triangles = write_sphere(strahl.path("sphere.ply"), rings, smooth)
            scene = strahl.path("mesh.xml")
            scene.write_text(text[:begin] + '<shape type="ply"><string name="filename" value="sphere.ply"/>'
                             '<ref id="clay"/></shape>' + text[end:], encoding="utf-8")
            costs = best(scene, "mesh.exr")
            results.append({"kind": "smooth" if smooth else "flat", "triangles": triangles, **costs,
                            **strahl.compare("mesh.exr", "sphere.exr", "rmse", "flip")})
    return results


def show(results):
    sphere = results[0]["kernel"]
    rows = [[r["kind"], f"{r['triangles']:,}" if r["triangles"] else "–", scientific(r["rmse"]), f"{r['flip']:.5f}",
             f"{1e3 * r['kernel']:.1f} ms", f"× {r['kernel'] / sphere:.2f}", f"{1e3 * r['prepare']:.0f} ms",
             f"{r['bytes'] / 2**20:.2f} MiB"] for r in results]
    series = {f"{kind} triangles": [(r["triangles"], r["rmse"]) for r in results if r["kind"] == kind]
              for kind in ("flat", "smooth")}
    picture = plot("A sphere from triangles, against the sphere", "triangles", "RMSE to the sphere's picture", series)
    words = table(["sphere", "triangles", "RMSE", "FLIP", "kernel", "of the sphere", "load, tree, upload", "on the device"],
                  rows)
    return {"tessellation.svg": picture}, words
