#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the last column of sionna_hits.csv by Mitsuba 3 (pip install mitsuba): sionna_hits.py ../shared/data/sionna.

Only the PLY meshes and floor_wall's sensor come from the files; strahl takes no part. Rays through the pixels' middles
start from the camera that strahl promises for a scene without a sensor: along -z, 40 degrees across the smaller side,
5 % of room around the bounding box. An argument after the folder writes the hit masks there as NumPy files.
"""
import pathlib
import sys
import xml.etree.ElementTree as ElementTree

import mitsuba
import numpy

mitsuba.set_variant("scalar_rgb")


def rotation(axis, degrees):
    return numpy.array(mitsuba.ScalarTransform4f().rotate(axis, degrees).matrix, dtype=float)


def camera_of(root, low, high):
    """Origin, right, down, forward (orthonormal), tangent of half the opening across the width, width, height."""
    if root.find("sensor") is None:
        width, height = 768, 576
        tangent = numpy.tan(numpy.radians(20))
        distance = 1.05 * max(high[0] - low[0], high[1] - low[1]) / 2 / tangent
        origin = numpy.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, high[2] + distance])
        frame = numpy.array([1, 0, 0]), numpy.array([0, -1, 0]), numpy.array([0, 0, -1])
        return origin, *frame, tangent * width / height, width, height
    sensor = root.find("sensor")
    assert sensor.find("string[@name='fov_axis']").get("value") == "x"
    tangent = numpy.tan(numpy.radians(float(sensor.find("float[@name='fov']").get("value")) / 2))
    world = numpy.eye(4)
    for step in sensor.find("transform"):
        if step.tag == "rotate":
            axis = [float(step.get(name, 0)) for name in "xyz"]
            world = rotation(axis, float(step.get("angle"))) @ world
        else:
            assert step.tag == "translate"
            world[:3, 3] += [float(word) for word in step.get("value").split()]
    return world[:3, 3], -world[:3, 0], -world[:3, 1], world[:3, 2], tangent, 1920, 1080


def hit_mask(path):
    root = ElementTree.parse(path).getroot()
    scene = {"type": "scene"}
    for number, shape in enumerate(root.iter("shape")):
        assert shape.get("type") == "ply" and shape.find("transform") is None
        name = shape.find("string[@name='filename']").get("value")
        scene[f"shape{number}"] = {"type": "ply", "filename": str(path.parent / name), "face_normals": True}
    scene = mitsuba.load_dict(scene)
    box = scene.bbox()
    origin, right, down, forward, tangent, width, height = camera_of(root, numpy.array(box.min), numpy.array(box.max))
    mask = numpy.zeros((height, width), dtype=bool)
    for y in range(height):
        for x in range(width):
            sx = (2 * x + 1 - width) / width * tangent
            sy = (2 * y + 1 - height) / height * tangent * height / width
            direction = forward + sx * right + sy * down
            direction = direction / numpy.linalg.norm(direction)
            mask[y, x] = scene.ray_test(mitsuba.Ray3f(origin.tolist(), direction.tolist()))
    return mask


if __name__ == "__main__":
    print("scene,width,height,mitsuba")
    for scene_path in sorted(pathlib.Path(sys.argv[1]).glob("*/*.xml")):
        hits = hit_mask(scene_path)
        print(f"{scene_path.stem},{hits.shape[1]},{hits.shape[0]},{hits.sum()}", flush=True)
        if len(sys.argv) > 2:
            numpy.save(pathlib.Path(sys.argv[2]) / f"{scene_path.stem}.npy", hits)
