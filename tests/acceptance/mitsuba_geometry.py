#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Random scenes of Mitsuba's own shapes, transforms and cameras: strahl and Mitsuba 3 see the same.

mitsuba_geometry.py STRAHL [SCENES]: needs Python's mitsuba and numpy (exit code 77 where they are not there). Per scene
20 shapes under random transforms. Mitsuba's camera rays go through `strahl intersect --precision double`: hit masks and
shapes must agree (or be equally far: overlapping faces), t and normals to 1e-5, since Mitsuba computes in single
precision; the depth picture must show the same distances, so that cameras agree too. Normals are those that Mitsuba
shades by; under a mirror the geometric ones of its rectangles and cubes point the other way. Rays within rounding of an
edge may part: up to 0.1 % of a scene's rays.
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

mi.set_variant("scalar_rgb")


def transform(rng, uniform):
    steps = ""
    for _ in range(rng.integers(1, 4)):
        kind = rng.integers(0, 3)
        if kind == 0:
            axis = rng.normal(size=3)
            axis /= np.linalg.norm(axis)
            steps += '<rotate x="%.9f" y="%.9f" z="%.9f" angle="%g"/>' % (*axis, rng.uniform(-180, 180))
        elif kind == 1 and uniform:
            steps += '<scale value="%g"/>' % rng.uniform(0.3, 1.5)
        elif kind == 1:
            steps += '<scale x="%g" y="%g" z="%g"/>' % tuple(rng.uniform(0.3, 1.5, 3) * rng.choice([1, 1, 1, -1], 3))
        else:
            steps += '<translate x="%g" y="%g" z="%g"/>' % tuple(rng.uniform(-2, 2, 3))
    return f'<transform name="to_world">{steps}</transform>'


def shape(rng, index, mesh):
    kind = rng.choice(["sphere", "rectangle", "cube", "disk", "cylinder", "obj"])
    inner = '<boolean name="flip_normals" value="true"/>' if rng.random() < 0.3 else ""
    if kind == "obj":
        inner += f'<string name="filename" value="{mesh}"/>'
    if kind == "sphere" and rng.random() < 0.5:
        inner += '<point name="center" x="%g" y="%g" z="%g"/>' % tuple(rng.uniform(-2, 2, 3))
        inner += '<float name="radius" value="%g"/>' % rng.uniform(0.2, 1)
    if kind == "cylinder" and rng.random() < 0.5:
        inner += '<point name="p0" x="%g" y="%g" z="%g"/>' % tuple(rng.uniform(-2, 2, 3))
        inner += '<point name="p1" x="%g" y="%g" z="%g"/>' % tuple(rng.uniform(-2, 2, 3))
        inner += '<float name="radius" value="%g"/>' % rng.uniform(0.1, 1)
    placed = transform(rng, kind in ("sphere", "disk", "cylinder"))
    return kind, f'<shape type="{kind}" id="s{index}">{inner}{placed}</shape>'


def camera(rng):
    kind = rng.choice(["perspective", "orthographic"])
    lens = ""
    if kind == "perspective":
        lens = '<float name="fov" value="%g"/>' % rng.uniform(20, 120)
        lens += '<string name="fov_axis" value="%s"/>' % rng.choice(["x", "y", "diagonal", "smaller", "larger"])
        for axis in "xy":
            lens += '<float name="principal_point_offset_%s" value="%g"/>' % (axis, rng.uniform(-0.2, 0.2))
    eye, tilt = rng.normal(size=3) * 6, rng.normal(size=2) * 0.3
    place = '<lookat origin="%g,%g,%g" target="0,0,0" up="%g,1,%g"/>' % (*eye, *tilt)
    film = '<film type="hdrfilm"><integer name="width" value="%d"/><integer name="height" value="%d"/></film>' % tuple(
        rng.integers(40, 70, 2))
    near = '<float name="near_clip" value="0.01"/><float name="far_clip" value="10000"/>'
    return f'<sensor type="{kind}">{lens}{near}<transform name="to_world">{place}</transform>{film}</sensor>'


def mitsuba_hits(scene, width, height, meshes):
    """Rays (N x 8), hits (t, shape, normal) and distances from the camera's origin. meshes: which shapes are files."""
    number = {s.id(): int(s.id()[1:]) for s in scene.shapes()}
    sensor = scene.sensors()[0]
    eye = np.array(sensor.world_transform().translation()).reshape(-1)
    rays, hits = np.zeros((width * height, 8)), np.zeros((width * height, 5))
    rays[:, 7], hits[:, 0], hits[:, 1] = np.inf, np.inf, -1
    for i in range(width * height):
        ray, _ = sensor.sample_ray(0, 0, [(i % width + 0.5) / width, (i // width + 0.5) / height], [0.5, 0.5])
        rays[i, :3], rays[i, 3:6] = ray.o, ray.d
        found = scene.ray_intersect(mi.Ray3f(ray.o, ray.d))
        if found.is_valid():
            normal = found.n if found.shape.is_mesh() and meshes[number[found.shape.id()]] else found.sh_frame.n
            hits[i] = found.t, number[found.shape.id()], *normal
    perspective = "Perspective" in str(sensor)
    start = np.linalg.norm(rays[:, :3] - eye, axis=1) if perspective else np.full(width * height, 0.01)
    return rays, hits, np.where(np.isfinite(hits[:, 0]), hits[:, 0] + start, 0)


def compare(strahl, seed, folder):
    rng = np.random.default_rng(seed)
    mesh = pathlib.Path(__file__).resolve().parents[2] / "scenes/mesh/torus.obj"
    shapes = [shape(rng, i, mesh) for i in range(20)]
    text = '<scene version="3.0.0"><integrator type="depth"/>%s%s</scene>' % (
        camera(rng), "".join(element for _, element in shapes))
    (folder / "scene.xml").write_text(text)
    scene = mi.load_string(text)
    width, height = scene.sensors()[0].film().size()
    rays, theirs, distance = mitsuba_hits(scene, width, height, [kind == "obj" for kind, _ in shapes])
    np.save(folder / "rays.npy", rays)
    subprocess.run([strahl, "intersect", folder / "scene.xml", "--rays", folder / "rays.npy", "-o", folder / "hits.npy",
                    "-q", "--precision", "double"], check=True, stderr=subprocess.DEVNULL)
    subprocess.run([strahl, "render", folder / "scene.xml", "-o", folder / "depth.pfm", "-q", "--sampler", "centre",
                    "--precision", "double"], check=True, stderr=subprocess.DEVNULL)
    ours = np.load(folder / "hits.npy")
    body = (folder / "depth.pfm").read_bytes().split(b"\n", 3)[3]
    depth = np.frombuffer(body, "<f4").reshape(height, width, 3)[::-1, :, 0].reshape(-1)

    met = np.isfinite(theirs[:, 0]) & np.isfinite(ours[:, 0])
    reach = np.where(met, theirs[:, 0], 1)
    t_off = met & (np.abs(np.where(met, ours[:, 0], 1) - reach) > 1e-5 * np.maximum(1, reach))
    same = ours[:, 2] == theirs[:, 1]
    wrong = (np.isfinite(theirs[:, 0]) != np.isfinite(ours[:, 0])) | (~same & t_off)
    hit = same & met
    n_off = hit & (np.linalg.norm(ours[:, 6:9] - theirs[:, 2:5], axis=1) > 1e-5)
    d_off = same & (np.abs(depth - distance) > 1e-4 * np.maximum(1, distance))
    counts = [int(wrong.sum()), int((t_off & same).sum()), int(n_off.sum()), int(d_off.sum())]
    print(f"scene {seed}: {len(rays)} rays, {int(hit.sum())} hits; differ: shape {counts[0]}, t {counts[1]}, "
          f"normal {counts[2]}, depth picture {counts[3]}")
    return max(counts) <= len(rays) / 1000


def main():
    scenes = int(sys.argv[2]) if len(sys.argv) > 2 else 20
    with tempfile.TemporaryDirectory() as folder:
        right = [compare(sys.argv[1], seed, pathlib.Path(folder)) for seed in range(scenes)]
    print(f"{sum(right)} of {scenes} scenes agree")
    return 0 if all(right) else 1


if __name__ == "__main__":
    sys.exit(main())
