# SPDX-License-Identifier: MIT
"""Cycles on the CPU as a peer: cycles_server.py SCENE.xml SPP THREADS, with a Python that has bpy (pip install bpy).

A Cornell box as cornell.py reads it; nothing is clamped, denoised or left out early. Then as answers.py has it.
"""
import math
import sys
import time

from answers import serve  # Before bpy, which writes to standard output.

import bpy
import mathutils

from cornell import read_box


def material(surface):
    """Diffuse; a lamp shines where it faces, as Mitsuba's do: Cycles' would to both sides."""
    made = bpy.data.materials.new(surface.name)
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    nodes.clear()
    output = nodes.new("ShaderNodeOutputMaterial")
    diffuse = nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (*surface.reflectance, 1)
    if surface.radiance is None:
        links.new(diffuse.outputs[0], output.inputs["Surface"])
        return made
    largest = max(surface.radiance)
    emission = nodes.new("ShaderNodeEmission")
    emission.inputs["Color"].default_value = (*(c / largest for c in surface.radiance), 1)
    emission.inputs["Strength"].default_value = largest
    both, mix, side = (nodes.new(f"ShaderNode{kind}") for kind in ("AddShader", "MixShader", "NewGeometry"))
    links.new(diffuse.outputs[0], both.inputs[0])
    links.new(emission.outputs[0], both.inputs[1])
    links.new(side.outputs["Backfacing"], mix.inputs[0])
    links.new(both.outputs[0], mix.inputs[1])
    links.new(diffuse.outputs[0], mix.inputs[2])
    links.new(mix.outputs[0], output.inputs["Surface"])
    made.cycles.emission_sampling = "FRONT"
    return made


def add_surface(scene, surface):
    corners = [corner for face in surface.faces for corner in face]
    mesh = bpy.data.meshes.new(surface.name)
    mesh.from_pydata(corners, [], [tuple(range(first, first + 4)) for first in range(0, len(corners), 4)])
    mesh.materials.append(material(surface))
    scene.collection.objects.link(bpy.data.objects.new(surface.name, mesh))


def add_camera(scene, box):
    """Blender's cameras look along -z with y up."""
    back = (mathutils.Vector(box.origin) - mathutils.Vector(box.target)).normalized()
    right = mathutils.Vector(box.up).cross(back).normalized()
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit = "HORIZONTAL"
    camera.angle = math.radians(box.fov)
    seen = bpy.data.objects.new("camera", camera)
    rotation = mathutils.Matrix((right, back.cross(right), back)).transposed().to_4x4()
    seen.matrix_world = mathutils.Matrix.Translation(box.origin) @ rotation
    scene.collection.objects.link(seen)
    scene.camera = seen


def main():
    box, spp, threads = read_box(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    for surface in box.surfaces:
        add_surface(scene, surface)
    add_camera(scene, box)
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples = spp
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.pixel_filter_type = "BOX"
    # A bounce is what lies between two segments, and the last one's lamps are sampled beside.
    cycles.max_bounces = cycles.diffuse_bounces = box.max_depth - 2
    scene.render.threads_mode = "FIXED"
    scene.render.threads = threads
    scene.render.use_persistent_data = True
    scene.render.resolution_x, scene.render.resolution_y = box.width, box.height
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_mode = "RGB"
    scene.render.image_settings.color_depth = "32"

    def render(seed, path):
        cycles.seed = seed
        start = time.perf_counter()
        bpy.ops.render.render()
        seconds = time.perf_counter() - start
        bpy.data.images["Render Result"].save_render(path, scene=scene)
        return seconds

    serve(f"Cycles {bpy.app.version_string} CPU", render)


if __name__ == "__main__":
    main()
